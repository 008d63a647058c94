// verstat models: the catalogue of process models: list, show, search, evaluate, count, write pages.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include <fmt/format.h>

#include "app/cli.h"
#include "models/catalogue/catalogue.h"
#include "scenarios/catalogue_pages.h"
#include "scenarios/function_json.h"
#include "scenarios/model_json.h"

namespace verstat::app {

namespace {

using models::Field;
using models::Function;
using models::Source;
using nlohmann::json;
using nlohmann::ordered_json;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void list(const std::string& source_id, const std::vector<std::string>& words, bool as_json) {
  ordered_json answer = ordered_json::array();
  bool any = false;
  for (const Source& source : models::catalogue().sources()) {
    if (!source_id.empty() && lower(source.info().id) != lower(source_id)) continue;
    bool headed = false;
    for (const Function& f : source.functions()) {
      if (!scenarios::function_matches(source, f, words)) continue;
      any = true;
      if (as_json) {
        answer.push_back(scenarios::function_json(source, f, false));
        continue;
      }
      if (!headed) fmt::print("{}  {} ({})\n", source.info().id, source.info().title, source.info().role);
      headed = true;
      fmt::print("  {:<44} {}\n", f.key, f.summary);
    }
  }
  if (as_json) {
    fmt::print("{}\n", answer.dump(2));
  } else if (!any) {
    fmt::print("no function matches\n");
  } else if (words.empty() && source_id.empty()) {
    fmt::print("\n{} functions from {} sources; `verstat models show KEY` explains one\n",
               models::catalogue().function_count(), models::catalogue().sources().size());
  }
}

void show_fields(const char* head, const std::vector<Field>& fields, bool input) {
  fmt::print("{}\n", head);
  for (const Field& f : fields) {
    std::string allowed;
    const auto kind = f.access->type_info().kind;
    using Kind = models::TypeInfo::Kind;
    if (kind == Kind::number || kind == Kind::integer)
      allowed = f.range.text(f.name);
    else
      allowed = f.access->type();
    fmt::print("  {:<26} {:<10} {}\n", f.name, f.unit == "1" || f.unit == "-" ? "" : f.unit, f.meaning);
    fmt::print("  {:<26} {:<10}   {}", "", "", allowed);
    if (input && !f.required) fmt::print("; default {}", f.default_value.to_string());
    fmt::print("\n");
  }
}

void show(const std::string& key, bool as_json) {
  const Function& f = models::catalogue().at(key);
  const Source& source = scenarios::source_of(f);
  if (as_json) {
    fmt::print("{}\n", scenarios::function_json(source, f, true).dump(2));
    return;
  }
  fmt::print("{}\n{}\n\n{} {}, {}: {}\n{}\n\n", f.key, f.summary, source.info().id, f.equation,
             models::to_string(f.provenance), source.info().authors, source.info().published);
  show_fields("inputs", f.inputs, true);
  show_fields("outputs", f.outputs, false);
  for (const std::string& note : f.notes) fmt::print("note: {}\n", note);
  const ordered_json inputs = scenarios::to_json(f.example_inputs());
  fmt::print("\nexample\n  verstat models eval {} --inputs '{}'\n  {}\n", f.key, inputs.dump(),
             scenarios::to_json(f.evaluate(f.example_inputs())).dump());
}

std::string read_all(const std::string& file) {
  if (file != "-") return scenarios::read_text_file(file);
  return {std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
}

void evaluate(const std::string& key, const std::string& inputs, const std::string& batch,
              const std::string& source) {
  if (!batch.empty()) {
    if (!key.empty()) throw UsageError(fmt::format("--batch {}: takes no KEY beside it", batch));
    try {
      fmt::print("{}\n", scenarios::evaluate_batch(scenarios::parse_json(read_all(batch)), source).dump(1));
    } catch (const scenarios::InputError& e) {
      throw UsageError(fmt::format("--batch {}: {}", batch, e.what()));
    } catch (const std::invalid_argument& e) {
      throw UsageError(fmt::format("--batch {}: {}", batch, e.what()));
    }
    return;
  }
  if (key.empty()) throw UsageError("models eval: needs a KEY such as K117.part_cost, or --batch FILE");
  const std::string full = key.find('.') == std::string::npos && !source.empty() ? source + "." + key : key;
  const Function& f = models::catalogue().at(full);
  json given;
  try {
    given = scenarios::parse_json(inputs);
  } catch (const scenarios::InputError& e) {
    throw UsageError(fmt::format("--inputs: {}", e.what()));
  }
  fmt::print("{}\n", scenarios::to_json(f.evaluate(scenarios::to_value(given))).dump(2));
}

void write_pages(const std::string& out, const std::string& points) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(points))
    throw UsageError(fmt::format("--points {}: is no folder of reference points <ID>.json", points));
  const auto pages = scenarios::catalogue_pages(points);
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw UsageError(fmt::format("--out {}: {}", out, error.message()));
  std::size_t changed = 0;
  for (const auto& [name, text] : pages) {
    const fs::path file = fs::path(out) / name;
    // Unchanged pages keep their time; a page is renamed into place, so none is ever half-written.
    if (fs::exists(file) && scenarios::read_text_file(file.string()) == text) continue;
    const fs::path part = fs::path(out) / (name + ".part");
    if (std::ofstream to(part, std::ios::binary); !(to << text) || !to.flush())
      throw UsageError(fmt::format("--out {}: cannot write {}", out, part.string()));
    fs::rename(part, file, error);
    if (error) throw UsageError(fmt::format("--out {}: {}", out, error.message()));
    ++changed;
  }
  fmt::print("{}: {} pages, {} changed\n", out, pages.size(), changed);
}

void count(const std::string& points, bool as_json) {
  if (!std::filesystem::is_directory(points))
    throw UsageError(fmt::format("--points {}: is no folder of reference points <ID>.json", points));
  const auto uses = scenarios::source_uses(points);
  const auto& catalogue = models::catalogue();
  if (!as_json) {
    fmt::print("{}\n", models::count_line(catalogue, uses));
    return;
  }
  std::size_t sum = 0;
  for (const auto& use : uses) sum += use.reference_points;
  fmt::print("{}\n", ordered_json{{"sources", catalogue.sources().size()},
                                  {"functions", catalogue.function_count()},
                                  {"reference_points", sum}}
                         .dump(2));
}

}  // namespace

void add_models(CLI::App& program) {
  CLI::App* command = program.add_subcommand("models", "The catalogue of process models");
  command->require_subcommand(1);
  command->footer("Example:\n  verstat models show K117.part_cost");
  auto as_json = std::make_shared<bool>(false);
  auto key = std::make_shared<std::string>();
  auto source = std::make_shared<std::string>();
  auto words = std::make_shared<std::vector<std::string>>();
  auto inputs = std::make_shared<std::string>("{}");
  auto batch = std::make_shared<std::string>();

  CLI::App* list_command = command->add_subcommand("list", "List all functions");
  list_command->add_option("--source", *source, "only this source, for instance K117");
  list_command->add_flag("--json", *as_json, "print JSON");
  list_command->footer("Example:\n  verstat models list --source K117");
  list_command->callback([=] { list(*source, {}, *as_json); });

  CLI::App* search_command =
      command->add_subcommand("search", "List the functions whose description has all these words");
  search_command->add_option("WORD", *words, "words to look for")->required();
  search_command->add_flag("--json", *as_json, "print JSON");
  search_command->footer("Example:\n  verstat models search insert availability");
  search_command->callback([=] { list("", *words, *as_json); });

  CLI::App* show_command =
      command->add_subcommand("show", "Explain one function: source, inputs, outputs, example");
  show_command->add_option("KEY", *key, "for instance K117.part_cost")->required();
  show_command->add_flag("--json", *as_json, "print JSON");
  show_command->footer("Example:\n  verstat models show K117.part_cost");
  show_command->callback([=] { show(*key, *as_json); });

  auto points = std::make_shared<std::string>("tests/catalogue");
  auto out = std::make_shared<std::string>("docs/catalogue");
  CLI::App* doc_command =
      command->add_subcommand("doc", "Write the catalogue as one readable page per source");
  doc_command->add_option("--out", *out, "folder of the pages")->capture_default_str();
  doc_command->add_option("--points", *points, "folder of the reference points")->capture_default_str();
  doc_command->footer("Example:\n  verstat models doc --out docs/catalogue");
  doc_command->callback([=] { write_pages(*out, *points); });

  CLI::App* count_command =
      command->add_subcommand("count", "Count the sources, functions and reference points");
  count_command->add_option("--points", *points, "folder of the reference points")->capture_default_str();
  count_command->add_flag("--json", *as_json, "print JSON");
  count_command->footer("Example:\n  verstat models count");
  count_command->callback([=] { count(*points, *as_json); });

  CLI::App* eval_command = command->add_subcommand("eval", "Evaluate one function, or a file of points");
  eval_command->add_option("KEY", *key, "for instance K117.part_cost");
  eval_command->add_option("--inputs", *inputs, "named inputs as a JSON object")->capture_default_str();
  eval_command->add_option("--batch", *batch,
                           R"(file with [{"id", "function", "inputs"}...], or - for standard input)");
  eval_command->add_option("--source", *source, "put before function names without one, for instance K117");
  eval_command->add_flag("--json", *as_json, "the answer is JSON anyway");
  eval_command->footer(
      "Example:\n  verstat models eval K117.weibull_from_moments --inputs '{\"mean_min\": 60, \"cv\": 0.7}'\n"
      "A batch prints [{\"id\", \"outputs\"} or {\"id\", \"error\"}...]; a bad point never stops the "
      "others.");
  eval_command->callback([=] { evaluate(*key, *inputs, *batch, *source); });
}

}  // namespace verstat::app
