#include "scenarios/schema.h"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "scenarios/load.h"

using namespace verstat::scenarios;
using nlohmann::json;

namespace {

bool accepts(const json& schema_json, const json& document) {
  valijson::Schema schema;
  valijson::SchemaParser parser;
  const valijson::adapters::NlohmannJsonAdapter schema_adapter(schema_json);
  parser.populateSchema(schema_adapter, schema);
  valijson::Validator validator;
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
}

bool loads(const json& document) {
  try {
    (void)load(document);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

TEST_CASE("the schema file in the repository is the one this program makes") {
  const json file = read_json_file(VERSTAT_SOURCE_DIR "/scenarios/scenario.schema.json");
  CHECK(file == json(scenario_schema()));
}

TEST_CASE("the schema and the loader agree on the gallery and on what is out of range") {
  const json schema = json(scenario_schema());
  for (const auto& entry : std::filesystem::directory_iterator(VERSTAT_SOURCE_DIR "/scenarios/gallery")) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".json") || path.ends_with(".study.json")) continue;
    INFO(path);
    const json document = read_json_file(path);
    CHECK(accepts(schema, document));
    CHECK(loads(document));
  }
  const json good = read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/heavy-lathe.json");
  for (const char* change :
       {"/machines/0/count=0", "/machines/0/counts=1", "/tools/0/strategy/gamma=2", "/machines=[]",
        "/tools/0/strategy/kind=none", "/inserts/0/edge_life/law=gauss", "/parts/0/route=3",
        "/simulation/horizon_min=0", "/crews/0/members=1.5", "/stores/0/name=7"}) {
    INFO(change);
    const json bad = apply(good, {parse_change(change)});
    CHECK_FALSE(accepts(schema, bad));
    CHECK_FALSE(loads(bad));
  }
}
