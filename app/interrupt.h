#pragma once
// Ctrl-C and SIGTERM end a study between two replications, with the best so far; a second one ends the
// program at once.

namespace verstat::app {

/// From now on the first SIGINT or SIGTERM is only noted.
void note_interrupts();
/// True once one came.
[[nodiscard]] bool end_asked();

}  // namespace verstat::app
