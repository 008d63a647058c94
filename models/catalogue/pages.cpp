#include "models/catalogue/pages.h"

#include <map>

#include <fmt/format.h>

#include "models/catalogue/formulas.h"

namespace verstat::models {

namespace {

constexpr const char* generated =
    "<!-- Written by `verstat models doc` from the descriptions in models/: change those, not this. -->\n\n";

/// A cell of a Markdown table: bars would end it.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

/// A formula as plain text: Markdown would read its stars and brackets as markup.
std::string text(std::string_view formula) {
  std::string out;
  for (const char c : formula) {
    if (c == '*' || c == '<' || c == '[' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string unit_of(const Field& f) {
  return f.unit == "1" || f.unit == "-" ? "" : f.unit;
}

bool numeric(const TypeInfo& type) {
  using Kind = TypeInfo::Kind;
  return type.kind == Kind::number || type.kind == Kind::integer ||
         (type.kind == Kind::list && numeric(type.element.front()));
}

/// What values a field takes: its type, and the range of its numbers.
std::string allowed_of(const Field& f) {
  const TypeInfo type = f.access->type_info();
  std::string text = type.kind == TypeInfo::Kind::number ? std::string() : type.text();
  if (numeric(type)) {
    const std::string range = f.range.text("x");
    if (range != "x finite") text += (text.empty() ? "" : ", ") + range;
  }
  return text;
}

void fields_table(std::string& out, const std::vector<Field>& fields, bool inputs) {
  out += inputs ? "| input | symbol | unit | values | default | meaning |\n|---|---|---|---|---|---|\n"
                : "| output | symbol | unit | meaning |\n|---|---|---|---|\n";
  for (const Field& f : fields) {
    const std::string symbol = f.symbol == "-" ? "" : cell(f.symbol);
    if (inputs)
      out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", f.name, symbol, cell(unit_of(f)),
                         cell(allowed_of(f)), f.required ? "" : cell(f.default_value.to_string()),
                         cell(f.meaning));
    else
      out += fmt::format("| `{}` | {} | {} | {} |\n", f.name, symbol, cell(unit_of(f)), cell(f.meaning));
  }
  out += '\n';
}

void function_section(std::string& out, const Function& f) {
  out += fmt::format("### {}\n\n{}  \n*{}: {}*\n\n", f.name, f.summary, to_string(f.provenance), f.equation);
  if (const auto formula = formula_of(f.key); !formula.empty()) out += fmt::format("{}\n\n", text(formula));
  if (!f.inputs.empty()) fields_table(out, f.inputs, true);
  fields_table(out, f.outputs, false);
  for (const std::string& note : f.notes) out += fmt::format("- {}\n", note);
  if (!f.notes.empty()) out += '\n';
}

std::string plural(std::size_t n, std::string_view one) {
  return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s");
}

std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : ", ") + part;
  return out;
}

}  // namespace

std::string page_name(const Source& source) {
  return source.info().id + ".md";
}

std::string source_page(const Source& source, const SourceUse& use) {
  const SourceInfo& info = source.info();
  std::string out = generated;
  out += fmt::format("# {} {}\n\n{}{} {}.\n\n{}\n\n", info.id, info.title, info.authors,
                     info.authors.ends_with('.') ? "" : ".", info.published, info.models);
  std::map<std::string_view, std::size_t> by_provenance;
  for (const Function& f : source.functions()) ++by_provenance[to_string(f.provenance)];
  out += fmt::format("Role: {}. {}", info.role, plural(source.functions().size(), "function"));
  std::string separator = ": ";
  for (const auto& [name, count] : by_provenance) {
    out += fmt::format("{}{} {}", separator, count, name);
    separator = ", ";
  }
  out += fmt::format("; {}.", plural(use.reference_points, "reference point"));
  if (!use.kinds.empty()) out += fmt::format(" Used by: {}.", joined(use.kinds));
  out += "\n\n";
  if (!info.errata.empty()) {
    out += "## Errors in print, and what was done\n\n";
    for (const std::string& erratum : info.errata) out += fmt::format("- {}\n", erratum);
    out += '\n';
  }
  out += "## Functions\n\n";
  for (const Function& f : source.functions()) function_section(out, f);
  const Function& first = source.functions().front();
  out += fmt::format("A worked example of each: `verstat models show {}`.\n", first.key);
  return out;
}

std::string count_line(const Catalogue& catalogue, const std::vector<SourceUse>& uses) {
  std::size_t points = 0;
  for (const SourceUse& use : uses) points += use.reference_points;
  return fmt::format("{}, {}, {}", plural(catalogue.sources().size(), "source"),
                     plural(catalogue.function_count(), "function"), plural(points, "reference point"));
}

std::string index_page(const Catalogue& catalogue, const std::vector<SourceUse>& uses) {
  std::string out = generated;
  out += fmt::format(
      "# The catalogue of process models\n\n{}.\n\nEach function says whether it stands in its paper as "
      "printed "
      "(paper), was repaired or\nreconstructed, or is a textbook COMPLETION. `verstat models list` lists "
      "them, "
      "`verstat models show KEY` explains\none with an example, `verstat models eval KEY --inputs '{{...}}'` "
      "evaluates it.\n\n",
      count_line(catalogue, uses));
  out += "| source | title | role | functions | points | used by |\n|---|---|---|---|---|---|\n";
  std::size_t k = 0;
  for (const Source& source : catalogue.sources()) {
    const SourceInfo& info = source.info();
    const SourceUse& use = uses.at(k++);
    out +=
        fmt::format("| [{}]({}) | {} | {} | {} | {} | {} |\n", info.id, page_name(source), cell(info.title),
                    info.role, source.functions().size(), use.reference_points, joined(use.kinds));
  }
  return out;
}

}  // namespace verstat::models
