// One --set per line, made in the heavy-lathe cell.
#include "scenarios/load.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

void eat(std::string_view bytes) {
  static const nlohmann::json cell = scenarios::read_json_file("scenarios/gallery/heavy-lathe.json");
  try {
    std::vector<scenarios::Change> changes;
    while (!bytes.empty() && changes.size() < 8) {
      const std::size_t end = std::min(bytes.find('\n'), bytes.size());
      changes.push_back(scenarios::parse_change(bytes.substr(0, end)));
      bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    (void)scenarios::load(scenarios::apply(cell, changes));
  } catch (const scenarios::InputError& e) {
    if (std::string_view(e.what()).empty()) finding("an error without words");
  }
}

std::vector<std::string> seeds() {
  return {"/machines/0/count=3\n/tools/0/strategy/gamma=0.47",
          "/simulation/seed=\"18446744073709551615\"",
          "/operations/0/process/cutting_speed_m_min=75.5\n/crews/0/members=2",
          "/inserts/0/edge_life={\"law\":\"exponential\"}",
          "/parts/0/supply={\"kind\":\"interarrival\",\"time\":"
          "{\"kind\":\"gamma\",\"mean_min\":50,\"cv\":0.5}}",
          "/a~1b/~0=x"};
}

}  // namespace

Target changes_target() {
  return {"changes", Form::bytes, eat, seeds};
}

}  // namespace verstat::fuzz
