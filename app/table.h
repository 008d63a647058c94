#pragma once
// Tables on standard output whose columns are as wide as what they hold.

#include <string>
#include <vector>

namespace verstat::app {

class Table {
 public:
  /// `align` has one letter per column: l to the left, r to the right. Columns are at least `least_width`.
  explicit Table(std::string align, std::string indent = "", std::size_t least_width = 0)
      : align_(std::move(align)), indent_(std::move(indent)), least_width_(least_width) {}
  /// A row; cells that are left out are empty.
  void add(std::vector<std::string> cells);
  /// All rows, two blanks between columns, none at the end of a line.
  [[nodiscard]] std::string text() const;
  void print() const;

 private:
  std::string align_;
  std::string indent_;
  std::size_t least_width_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace verstat::app
