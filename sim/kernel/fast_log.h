#pragma once
// Natural logarithm for random numbers.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace verstat::sim::detail {

/// log x = k log 2 + log c + log(1 + (x / 2^k - c) / c) with c the middle of one of 128 intervals and a
/// series of degree 7. The tables are computed by the compiler.
class LogTable {
 public:
  constexpr LogTable() : rows_{} {
    for (std::size_t i = 0; i < size; ++i) {
      const double c = std::bit_cast<double>(first_bits + (2 * i + 1) * (interval_bits / 2));
      rows_[i] = Row{c, 1.0 / c, series_log(c)};
    }
  }

  /// For normal x > 0. Error below 2 units in the last place of the result, anywhere. Plain arithmetic:
  /// the bits are the same on every machine, unlike those of the C library, which uses fused instructions
  /// where there are some.
  [[nodiscard]] double log(double x) const noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t offset = bits - first_bits;
    const Row& row = rows_[(offset / interval_bits) % size];
    const auto k = static_cast<double>(static_cast<std::int64_t>(offset) >> 52);
    const double z = std::bit_cast<double>(bits - (offset & (0xfffULL << 52U)));
    const double r = (z - row.middle) * row.inverse;  // the difference is exact
    const double r2 = r * r;
    const double head = k * log2_high + row.log;
    const double series =
        r2 * ((-0.5 + r * (1.0 / 3.0)) + r2 * ((-0.25 + r * 0.2) + r2 * (-1.0 / 6.0 + r * (1.0 / 7.0))));
    return head + (r + (series + k * log2_low));
  }

 private:
  struct Row {
    double middle = 1.0;
    double inverse = 1.0;
    double log = 0.0;
  };
  static constexpr std::size_t size = 128;
  static constexpr std::uint64_t interval_bits = std::uint64_t{1} << 45U;
  // Intervals from about 0.69 to 1.38, placed so that 1 is a middle: near 1 the series alone stands.
  static constexpr std::uint64_t first_bits = 0x3ff0000000000000ULL - 80 * interval_bits - interval_bits / 2;
  // log 2 in two parts, the first with trailing zeros so that its multiples are exact.
  static constexpr double log2_high = 0x1.62e42fefa3800p-1;
  static constexpr double log2_low = 0x1.ef35793c76730p-45;

  static constexpr double series_log(double c) {
    // log c = 2 artanh y, y = (c - 1) / (c + 1), in extended precision.
    const long double y = (static_cast<long double>(c) - 1.0L) / (static_cast<long double>(c) + 1.0L);
    long double power = y;
    long double sum = 0.0L;
    for (int n = 1; n < 60; n += 2) {
      sum += power / n;
      power *= y * y;
    }
    return static_cast<double>(2.0L * sum);
  }

  std::array<Row, size> rows_;
};

inline constexpr LogTable log_table;

}  // namespace verstat::sim::detail
