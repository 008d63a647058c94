#pragma once
// Tables on standard output whose columns are as wide as what they hold.

#include <string>
#include <vector>

namespace verstat::app {

class Table {
 public:
  /// `align` has one letter per column: l to the left, r to the right.
  explicit Table(std::string align, std::string indent = "")
      : align_(std::move(align)), indent_(std::move(indent)) {}
  /// A row; cells that are left out are empty.
  void add(std::vector<std::string> cells);
  /// All rows, two blanks between columns, none at the end of a line.
  [[nodiscard]] std::string text() const;
  void print() const;

 private:
  std::string align_;
  std::string indent_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace verstat::app
