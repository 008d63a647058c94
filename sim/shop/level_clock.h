#pragma once
// A level over time: how many are busy, how much lies on the shelf.

namespace verstat::shop {

class LevelClock {
 public:
  /// The level is `level` from `now_min` on.
  void set(double level, double now_min) {
    settle(now_min);
    level_ = level;
  }
  void add(double change, double now_min) { set(level_ + change, now_min); }
  /// Forgets the past; the present level goes on.
  void reset(double now_min) {
    area_ = 0;
    since_min_ = now_min;
  }
  /// Books the time up to `now_min`.
  void settle(double now_min) {
    area_ += level_ * (now_min - since_min_);
    since_min_ = now_min;
  }
  [[nodiscard]] double level() const { return level_; }
  /// Integral of the level over time, min, as of the last settle or change.
  [[nodiscard]] double area_min() const { return area_; }

 private:
  double level_ = 0;
  double since_min_ = 0;
  double area_ = 0;
};

}  // namespace verstat::shop
