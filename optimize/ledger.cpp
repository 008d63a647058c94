#include "optimize/ledger.h"

#include <cstring>

namespace verstat::optimize {

// By bits: 0.1 + 0.2 and 0.3 are two questions.
std::string Ledger::key_of(const Trial& trial) {
  std::string key = trial.stage;
  const auto append = [&](const void* data, std::size_t bytes) {
    const std::size_t at = key.size();
    key.resize(at + bytes);
    std::memcpy(key.data() + at, data, bytes);
  };
  key += '\0';
  append(&trial.first_replication, sizeof trial.first_replication);
  append(&trial.replications, sizeof trial.replications);
  if (!trial.x.empty()) append(trial.x.data(), trial.x.size() * sizeof(double));
  return key;
}

}  // namespace verstat::optimize
