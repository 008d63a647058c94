#pragma once
// What goes wrong in a model: always bad input, always named.

#include <stdexcept>
#include <string>
#include <string_view>

#include "models/catalogue/value.h"

namespace verstat::models {

/// Bad input to a model function, in the words a user reads:
/// "K109.mill_reliability_paper: r_tooth = 1.2, allowed 0 < r_tooth < 1 (reliability of one tooth ...)".
class ModelError : public std::runtime_error {
 public:
  ModelError(std::string function, std::string input, const std::string& text)
      : std::runtime_error(function + ": " + text),
        function_(std::move(function)),
        input_(std::move(input)) {}
  /// Key of the function, "K109.mill_reliability_paper".
  [[nodiscard]] const std::string& function() const { return function_; }
  /// Name of the offending input; empty when no single input is to blame.
  [[nodiscard]] const std::string& input() const { return input_; }

 private:
  std::string function_;
  std::string input_;
};

/// Thrown inside a formula that does not know its own key; `guarded` turns it into a ModelError.
class DomainError : public std::domain_error {
 public:
  DomainError(std::string input, const std::string& text)
      : std::domain_error(text), input_(std::move(input)) {}
  [[nodiscard]] const std::string& input() const { return input_; }

 private:
  std::string input_;
};

/// A condition between inputs that a range cannot express.
/// Throws DomainError "`input` = `value`, `allowed`" when `ok` is false.
/// Example: require(in.gamma_min < in.gamma_max, "gamma_min", in.gamma_min, "must be below gamma_max");
void require(bool ok, std::string_view input, const Value& value, std::string_view allowed);

/// No single input is to blame. Throws DomainError with `text`.
[[noreturn]] void reject(std::string_view text);

}  // namespace verstat::models
