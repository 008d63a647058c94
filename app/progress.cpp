#include "app/progress.h"

#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

namespace verstat::app {

ProgressBar::ProgressBar(std::string what) : what_(std::move(what)) {
  const char* term = std::getenv("TERM");
  terminal_ = isatty(STDERR_FILENO) != 0 && !(term != nullptr && std::string_view(term) == "dumb");
}

ProgressBar::~ProgressBar() {
  if (open_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::update(std::int64_t done, std::int64_t of, const std::optional<double>& best) {
  const auto now = std::chrono::steady_clock::now();
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double share = of > 0 ? static_cast<double>(done) / static_cast<double>(of) : 1;
  const double left_s = share > 0 ? elapsed_s * (1 - share) / share : 0;
  const std::string shown_best = best ? fmt::format("  best {:.6g}", *best) : "";
  if (terminal_) {
    if (done < of && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    const int filled = static_cast<int>(share * 30);
    fmt::print(stderr, "\r\033[K{} [{:#<{}}{:.<{}}] {}/{}{}  {:.0f} s left", what_, "", filled, "",
               30 - filled, done, of, shown_best, left_s);
    open_ = true;
    return;
  }
  // Short work needs no news.
  const int tenth = static_cast<int>(share * 10);
  if (tenth > tenth_ && elapsed_s > 2)
    fmt::print(stderr, "{}: {} of {},{} {:.0f} s left\n", what_, done, of, shown_best, left_s);
  tenth_ = std::max(tenth_, tenth);
}

}  // namespace verstat::app
