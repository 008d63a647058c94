#pragma once
// What describes a model function once. The command line, the web explorer, the JSON binding, the generated
// catalogue pages and the reference-point tests all work from these descriptions; a formula itself is a plain
// function from one struct to another.
//
// A source is one file pair models/<role>/k117_<slug>.{h,cpp} in namespace verstat::models::k117, with
//
//   void describe(Catalogue& catalogue) {
//     Source& source = catalogue.source({.id = "K117", .title = "...", ...});
//     source.function<&weibull_from_moments>("weibull_from_moments", "Weibull shape and scale ...", "section
//     A",
//                                            Provenance::completion)
//         .input(&WeibullFromMomentsInputs::mean_min, "mean_min", "T", "min", above(0), "mean life", 60.0)
//         .optional(&WeibullFromMomentsInputs::cv, "cv", "CV", "1", closed(0.05, 2), "coefficient of
//         variation") .output(&WeibullMoments::shape, "shape", "b", "1", above(0), "Weibull shape");
//   }
//
// and every public function opens with `return guarded<&weibull_from_moments>(in, [&] { ... });`, which
// checks the inputs against their ranges and the outputs for NaN.

#include <concepts>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "models/catalogue/error.h"
#include "models/catalogue/field.h"
#include "models/catalogue/range.h"
#include "models/catalogue/value.h"

namespace verstat::models {

/// What the paper says and what was added, so that a user always sees which is which.
enum class Provenance {
  paper,          ///< as printed
  repaired,       ///< printed with an error that the card repairs, with reasons
  reconstructed,  ///< rebuilt from a garbled or partial print
  completion      ///< a textbook addition that the paper needs but does not give
};
[[nodiscard]] std::string_view to_string(Provenance provenance);

class Source;

/// One model function: key, words, fields, and the type-erased call.
class Function {
 public:
  std::string key;       ///< "K117.part_cost"
  std::string name;      ///< "part_cost"
  std::string summary;   ///< one sentence
  std::string equation;  ///< where it stands: "eq. (3)", "section E"
  Provenance provenance = Provenance::completion;
  std::vector<std::string> notes;  ///< what a reader needs to trust it
  std::vector<Field> inputs;
  std::vector<Field> outputs;

  /// Evaluates with named inputs; named outputs in the order of the description.
  /// Throws ModelError for unknown, missing, ill-typed or out-of-range inputs.
  [[nodiscard]] Value evaluate(const Value& named_inputs) const;
  /// The example of every required input.
  [[nodiscard]] Value example_inputs() const;
  /// Throws ModelError naming the first input outside its range. `in` is the function's input struct.
  void check_inputs(const void* in) const;
  /// Throws ModelError when an output is NaN or infinite. `out` is the function's output struct.
  void check_outputs(const void* out) const;

 private:
  friend class Source;
  Value (*call_)(const Function&, const Value&) = nullptr;
};

/// One paper.
struct SourceInfo {
  std::string id;                        ///< "K117"
  std::string title;                     ///< of the paper, in English
  std::string authors;                   ///< "Andronov O. Yu."
  std::string published;                 ///< collection, issue, place, year
  std::string models;                    ///< what it models: a paragraph
  std::string role;                      ///< folder of models/: "reliability"
  std::vector<std::string> errata = {};  ///< errors found in print and what was done
};

template <auto F>
struct FunctionSlot {
  static inline const Function* described = nullptr;
};

/// What the builders below do, once for all functions: their calls are many, so they stay small.
class FunctionDraft {
 public:
  explicit FunctionDraft(Function& f) : f_(&f) {}
  void add_input(Field field, Value example);
  void add_optional(Field field);
  void add_output(Field field);
  void set_example(Value value);
  void set_length(std::size_t least, std::size_t most);
  void add_note(std::string_view text);

 private:
  Function* f_;
};

/// An example as it is written in a description.
class Example {
 public:
  Example(bool b) : value_(b) {}                                      // NOLINT(google-explicit-constructor)
  Example(int i) : value_(i) {}                                       // NOLINT(google-explicit-constructor)
  Example(std::int64_t i) : value_(i) {}                              // NOLINT(google-explicit-constructor)
  Example(double d) : value_(d) {}                                    // NOLINT(google-explicit-constructor)
  [[gnu::noinline]] Example(const char* s) : value_(s) {}             // NOLINT(google-explicit-constructor)
  [[gnu::noinline]] Example(Value::List l) : value_(std::move(l)) {}  // NOLINT(google-explicit-constructor)
  [[gnu::noinline]] Example(Value::Map m) : value_(std::move(m)) {}   // NOLINT(google-explicit-constructor)
  [[gnu::noinline]] Example(Value v) : value_(std::move(v)) {}        // NOLINT(google-explicit-constructor)
  [[gnu::noinline]] ~Example() = default;
  [[nodiscard]] const Value& value() const { return value_; }

 private:
  Value value_;
};

/// Fills in the description of one function; each call adds one field and returns the builder.
template <class In, class Out>
class FunctionBuilder {
 public:
  explicit FunctionBuilder(Function& f) : draft_(f) {}

  /// A required input with an example inside its range.
  template <class T, class B>
  requires std::derived_from<In, B> FunctionBuilder& input(T B::*pointer, std::string_view name,
                                                           std::string_view symbol, std::string_view unit,
                                                           const Range& range, std::string_view meaning,
                                                           const Example& example) {
    draft_.add_input(member<In>(pointer, name, symbol, unit, range, meaning, true), example.value());
    return *this;
  }
  /// An input that may be left out: the default is what a default-constructed input struct holds.
  template <class T, class B>
  requires std::derived_from<In, B> FunctionBuilder& optional(T B::*pointer, std::string_view name,
                                                              std::string_view symbol, std::string_view unit,
                                                              const Range& range, std::string_view meaning) {
    draft_.add_optional(member<In>(pointer, name, symbol, unit, range, meaning, false));
    return *this;
  }
  template <class T, class B>
  requires std::derived_from<Out, B> FunctionBuilder& output(T B::*pointer, std::string_view name,
                                                             std::string_view symbol, std::string_view unit,
                                                             const Range& range, std::string_view meaning) {
    draft_.add_output(member<Out>(pointer, name, symbol, unit, range, meaning, true));
    return *this;
  }
  /// Example of the field added last (for optional inputs whose default makes a dull example).
  FunctionBuilder& example(const Example& value) {
    draft_.set_example(value.value());
    return *this;
  }
  /// Allowed number of entries of the list added last (input).
  FunctionBuilder& length(std::size_t least, std::size_t most) {
    draft_.set_length(least, most);
    return *this;
  }
  /// Adds a group of fields shared by several functions: `group` is called with this builder.
  template <class Group>
  FunctionBuilder& with(Group&& group) {
    group(*this);
    return *this;
  }
  FunctionBuilder& note(std::string_view text) {
    draft_.add_note(text);
    return *this;
  }

 private:
  FunctionDraft draft_;
};

class Source {
 public:
  explicit Source(SourceInfo info) : info_(std::move(info)) {}
  [[nodiscard]] const SourceInfo& info() const { return info_; }
  /// In the order of the card.
  [[nodiscard]] const std::deque<Function>& functions() const { return functions_; }

  /// Describes F, a function `Out F(const In&)`.
  template <auto F>
  auto function(std::string_view name, std::string_view summary, std::string_view equation,
                Provenance provenance) {
    return add<F>(F, name, summary, equation, provenance);
  }

 private:
  using Call = Value (*)(const Function&, const Value&);
  Function& add_function(std::string_view name, std::string_view summary, std::string_view equation,
                         Provenance provenance, Call call);

  template <auto F, class In, class Out>
  FunctionBuilder<In, Out> add(Out (*)(const In&), std::string_view name, std::string_view summary,
                               std::string_view equation, Provenance provenance) {
    Function& f =
        add_function(name, summary, equation, provenance, [](const Function& self, const Value& named) {
          In in{};
          read_fields(&in, self.inputs, named);
          const Out out = F(in);
          return write_fields(&out, self.outputs);
        });
    FunctionSlot<F>::described = &f;
    return FunctionBuilder<In, Out>(f);
  }

  SourceInfo info_;
  std::deque<Function> functions_;  // a deque: addresses must stay
};

class Catalogue {
 public:
  Source& source(SourceInfo info) { return sources_.emplace_back(std::move(info)); }
  /// In the order of their ids.
  [[nodiscard]] const std::deque<Source>& sources() const { return sources_; }
  /// Function with the key "K117.part_cost", or null.
  [[nodiscard]] const Function* find(std::string_view key) const;
  /// As find, but throws ModelError that names the closest key.
  [[nodiscard]] const Function& at(std::string_view key) const;
  [[nodiscard]] std::size_t function_count() const;

 private:
  std::deque<Source> sources_;
};

/// The catalogue of this program: built at the first call, constant afterwards.
[[nodiscard]] const Catalogue& catalogue();

namespace detail {
[[noreturn]] void rethrow_with_key(const Function& f);
}

/// Runs the body of the model function F between the checks that its description asks for: inputs inside
/// their ranges before, no NaN or infinity after. DomainError and Boost.Math's errors leave as ModelError
/// with the key.
template <auto F, class In, class Body>
[[nodiscard]] auto guarded(const In& in, Body&& body) {
  // NOLINTNEXTLINE(readability-misleading-indentation)
  static const Function& f = (static_cast<void>(catalogue()), *FunctionSlot<F>::described);
  f.check_inputs(&in);
  try {
    auto out = body();
    f.check_outputs(&out);
    return out;
  } catch (const ModelError&) {
    throw;
  } catch (...) {
    detail::rethrow_with_key(f);
  }
}

}  // namespace verstat::models
