// verstat schema: the JSON Schema of scenario files, for editors.
#include "scenarios/schema.h"

#include <fmt/format.h>

#include "app/cli.h"

namespace verstat::app {

void add_schema(CLI::App& program) {
  CLI::App* command = program.add_subcommand("schema", "Print the JSON Schema of scenario files");
  command->footer("Example:\n  verstat schema > scenario.schema.json");
  command->callback([] { fmt::print("{}\n", scenarios::scenario_schema().dump(2)); });
}

}  // namespace verstat::app
