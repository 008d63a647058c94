// verstat calibrate: uncertain inputs of a scenario from last month's totals.
#include <fmt/format.h>

#include "app/cli.h"
#include "app/fit_answer.h"
#include "fit/shop_calibration.h"

namespace verstat::app {

void add_calibrate(CLI::App& program) {
  struct Flags {
    CommonOptions common;
    std::string scenario, totals, out;
    std::vector<std::string> uncertain;
    std::string points = "100";
    std::string rounds = "3";
    std::string confidence = "0.95";
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command = program.add_subcommand(
      "calibrate", "Adjust uncertain inputs until the model makes last month's totals");
  command->add_option("SCENARIO", f->scenario, "scenario file (JSON)")->required();
  command->add_option("--totals", f->totals, "what was counted, and which inputs are uncertain (JSON)")
      ->required();
  command
      ->add_option("--uncertain", f->uncertain,
                   "POINTER=LOW..HIGH: a further uncertain input; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--points", f->points, "simulated months in each round")->capture_default_str();
  command->add_option("--rounds", f->rounds, "rounds, each nearer to the answer")->capture_default_str();
  command->add_option("--confidence", f->confidence, "of the intervals, 0.5 to 0.999")->capture_default_str();
  command->add_option("--out", f->out, "write the changes with their provenance to this file, for --changes");
  command->add_option("--seed", f->common.seed, "seed of all random streams, 0 to 18446744073709551615");
  command->add_option("--threads", f->common.threads, "threads to use (results do not depend on it)");
  add_changes(*command, f->common);
  add_json(*command, f->common);
  command->footer(
      "Example:\n  verstat calibrate scenarios/gallery/heavy-lathe.json --totals "
      "docs/examples/fit/last-month.json\n"
      "The answer says what the totals can tell and what they cannot.");
  command->callback([f] {
    const LoadedScenario loaded = load_scenario(f->scenario, changes_of(f->common));
    const fit::CalibrationSpec spec = fit::read_calibration(f->totals, f->uncertain);
    fit::CalibrationOptions options;
    options.points_per_round = static_cast<int>(whole_flag("--points", f->points, 20, 100'000));
    options.rounds = static_cast<int>(whole_flag("--rounds", f->rounds, 1, 10));
    options.confidence = real_flag("--confidence", f->confidence, 0.5, 0.999);
    options.seed = loaded.scenario.simulation.seed.value;
    answer(fit::calibrate_shop(loaded.json, spec, options, thread_count(f->common), origin_now(f->totals)),
           f->common.json, f->out);
  });
}

}  // namespace verstat::app
