// One door of tests/fuzz under libFuzzer, which keeps what reaches new code and varies it further.
//   VERSTAT_FUZZ_SEEDS=FOLDER fuzz_<door>    writes the honest inputs there and ends
//   fuzz_<door> FOLDER [libFuzzer flags]     see tools/fuzz
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "tests/fuzz/targets.h"

namespace {

using namespace verstat::fuzz;

const Target& door() {
  static const Target one = VERSTAT_FUZZ_DOOR();
  return one;
}

std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (const char* const folder = std::getenv("VERSTAT_FUZZ_SEEDS"); folder != nullptr) {
    int number = 0;
    for (const std::string& seed : door().seeds())
      std::ofstream(std::string(folder) + "/seed-" + std::to_string(++number), std::ios::binary) << seed;
    std::printf("%d seeds in %s\n", number, folder);
    std::fflush(stdout);
    std::_Exit(number > 0 ? 0 : 1);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  door().eat({reinterpret_cast<const char*>(data), size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  // Bytes are left to libFuzzer, which has a dictionary of what the code compares with.
  if (door().form == Form::bytes || seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string text = mutated(text_of(data, size), door().form, seed);
  if (text.empty() || text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data, std::size_t size,
                                                 const std::uint8_t* other, std::size_t other_size,
                                                 std::uint8_t* out, std::size_t most, unsigned seed) {
  std::string text = crossed(text_of(data, size), text_of(other, other_size), door().form, seed);
  if (text.empty() || text.size() > most) {  // as libFuzzer itself would: a piece of one in the other
    text = text_of(data, size);
    const std::size_t from = other_size == 0 ? 0 : seed % other_size;
    text.insert(text.empty() ? 0 : (seed >> 8U) % text.size(),
                text_of(other + from, std::min<std::size_t>(other_size - from, 1 + (seed >> 16U) % 64)));
    text.resize(std::min(text.size(), most));
  }
  std::memcpy(out, text.data(), text.size());
  return text.size();
}
