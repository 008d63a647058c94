#pragma once
#include <stdexcept>
#include <string>
#include <utility>

namespace verstat::scenarios {

/// Bad input in a file or a change: where it is and what would be right, in one line.
class InputError : public std::runtime_error {
 public:
  /// `pointer` is a JSON pointer ("/machines/0/count"), empty when the whole file is meant.
  InputError(std::string pointer, const std::string& text)
      : std::runtime_error(text), pointer_(std::move(pointer)) {}
  [[nodiscard]] const std::string& pointer() const { return pointer_; }

 private:
  std::string pointer_;
};

}  // namespace verstat::scenarios
