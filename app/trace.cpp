// verstat trace: one replication, event by event. verstat graph: the shop as a picture.
#include <sstream>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/files.h"
#include "sim/shop/shop.h"
#include "sim/shop/trace_export.h"

namespace verstat::app {

void add_trace(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto file = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  auto format = std::make_shared<std::string>("json");
  auto replication = std::make_shared<std::uint64_t>(0);
  CLI::App* command =
      program.add_subcommand("trace", "Record one replication: machine states, crews, parts, queues, edges");
  command->add_option("SCENARIO", *file, "scenario file (JSON)")->required();
  command->add_option("--out", *out, "file to write; without it, standard output");
  command
      ->add_option("--format", *format,
                   "json; compact (JSON for drawing); csv (state intervals); chrome (opens in Perfetto)")
      ->check(CLI::IsMember({"json", "compact", "csv", "chrome"}))
      ->capture_default_str();
  command->add_option("--replication", *replication, "number of the replication, from 0")
      ->capture_default_str();
  add_run_options(*command, *options);
  command->footer(
      "Example:\n  verstat trace scenarios/gallery/heavy-lathe.json --format chrome --out trace.json\n"
      "One simulated minute is shown as one second.");
  command->callback([options, file, out, format, replication] {
    const LoadedScenario loaded = load_scenario(*file, changes_of(*options));
    shop::Trace trace;
    shop::Shop one(loaded.scenario, *replication, &trace);
    static_cast<void>(one.run());
    std::ostringstream text;
    if (*format == "csv")
      shop::write_csv(text, loaded.scenario, trace);
    else if (*format == "chrome")
      shop::write_chrome(text, loaded.scenario, trace);
    else if (*format == "compact")
      shop::write_compact(text, loaded.scenario, trace);
    else
      shop::write_json(text, loaded.scenario, trace);
    if (out->empty())
      fmt::print("{}", text.str());
    else
      write_file("--out", *out, text.str());
  });
}

void add_graph(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto file = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("graph", "The shop as a graph for Graphviz");
  command->add_option("SCENARIO", *file, "scenario file (JSON)")->required();
  add_run_options(*command, *options);
  command->footer("Example:\n  verstat graph scenarios/gallery/mixed-plant.json | dot -Tsvg > plant.svg");
  command->callback([options, file] {
    const LoadedScenario loaded = load_scenario(*file, changes_of(*options));
    std::ostringstream text;
    shop::write_graphviz(text, loaded.scenario);
    fmt::print("{}", text.str());
  });
}

}  // namespace verstat::app
