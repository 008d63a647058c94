// Past findings and fresh variations of honest inputs at every door.
//   VERSTAT_FUZZ_TARGET=model VERSTAT_FUZZ_RUNS=10000000 VERSTAT_FUZZ_SEED=3 test_fuzz
// does more of it. Whatever ends the program shows the input that did it.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "scenarios/json_text.h"
#include "tests/fuzz/targets.h"

using namespace verstat::fuzz;
namespace fs = std::filesystem;

namespace {

std::string setting(const char* name, const std::string& otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : text;
}

const std::string* eaten = nullptr;

void show_input(int signal) {
  if (eaten != nullptr) (void)!::write(STDERR_FILENO, eaten->data(), eaten->size());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

TEST_CASE("what was found once is found no more", "[corpus]") {
  std::size_t files = 0;
  for (const Target& one : targets()) {
    const fs::path folder = fs::path("tests/fuzz/corpus") / one.name;
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      INFO(entry.path());
      CHECK_NOTHROW(one.eat(verstat::scenarios::read_text_file(entry.path().string())));
      ++files;
    }
  }
  CHECK(files > 0);
}

TEST_CASE("variations of honest inputs are taken or refused in words", "[mutation]") {
  const std::string only = setting("VERSTAT_FUZZ_TARGET", "");
  const std::uint64_t asked = std::stoull(setting("VERSTAT_FUZZ_RUNS", "0"));
  const std::uint64_t seed = std::stoull(setting("VERSTAT_FUZZ_SEED", "1"));
  const double most_s = std::stod(setting("VERSTAT_FUZZ_SECONDS", "1e9"));
  std::signal(SIGABRT, show_input);
  std::signal(SIGSEGV, show_input);
  for (const Target& one : targets()) {
    if (!only.empty() && one.name != only) continue;
    const std::vector<std::string> seeds = one.seeds();
    REQUIRE_FALSE(seeds.empty());
    for (const std::string& honest : seeds) one.eat(honest);
    const auto start = std::chrono::steady_clock::now();
    const std::uint64_t runs = asked == 0 ? one.short_run : asked;
    std::uint64_t k = 0;
    double slowest_s = 0;
    for (; k < runs; ++k) {
      const std::uint64_t dice = seed * 1'000'000'007U + k;
      std::string text = mutated(seeds[dice % seeds.size()], one.form, dice);
      if (dice % 3 == 0) text = mutated(text, one.form, ~dice);
      eaten = &text;
      const auto before = std::chrono::steady_clock::now();
      try {
        one.eat(text);
      } catch (const std::exception& e) {
        FAIL(one.name << " " << dice << ": " << e.what() << "\n" << text.substr(0, 20'000));
      }
      const auto now = std::chrono::steady_clock::now();
      const double took_s = std::chrono::duration<double>(now - before).count();
      if (took_s > 5) FAIL(one.name << " " << dice << " took " << took_s << " s\n" << text.substr(0, 20'000));
      slowest_s = std::max(slowest_s, took_s);
      if (std::chrono::duration<double>(now - start).count() > most_s) break;
    }
    if (runs > 10'000)
      WARN(one.name << ": " << k << " inputs in "
                    << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()
                    << " s, the slowest took " << slowest_s << " s");
  }
}
