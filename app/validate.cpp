// verstat validate: is this scenario one that can be run?
#include <fmt/format.h>

#include "app/cli.h"

namespace verstat::app {

void add_validate(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto file = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("validate", "Check a scenario file without running it");
  command->add_option("SCENARIO", *file, "scenario file (JSON)")->required();
  add_json(*command, *options);
  add_run_options(*command, *options);
  command->footer(
      "Example:\n  verstat validate scenarios/gallery/heavy-lathe.json --set /machines/0/count=3");
  command->callback([options, file] {
    const LoadedScenario loaded = load_scenario(*file, changes_of(*options));
    const scenarios::Scenario& s = loaded.scenario;
    const auto warned = scenarios::warnings(s);
    print_warnings(warned);
    std::int64_t machines = 0;
    for (const auto& machine : s.machines) machines += machine.count;
    if (options->json) {
      const nlohmann::ordered_json answer = {{"valid", true},
                                             {"name", s.name},
                                             {"machines", machines},
                                             {"tools", s.tools.size()},
                                             {"crews", s.crews.size()},
                                             {"part_types", s.parts.size()},
                                             {"operations", s.operations.size()},
                                             {"warnings", scenarios::to_json(warned)}};
      fmt::print("{}\n", answer.dump(2));
    } else {
      fmt::print("{} is valid: \"{}\", {} machines, {} tools, {} crews, {} part types\n", *file, s.name,
                 machines, s.tools.size(), s.crews.size(), s.parts.size());
    }
  });
}

}  // namespace verstat::app
