#include "app/interrupt.h"

#include <csignal>

namespace verstat::app {

namespace {

volatile std::sig_atomic_t came = 0;

void note(int) {
  came = 1;
}

}  // namespace

void note_interrupts() {
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second one is the system's
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file that may not grow any more is an error of writing, with words, not a sudden end.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool end_asked() {
  return came != 0;
}

}  // namespace verstat::app
