#pragma once
// The REST interface /api/v1 over the results database and the model catalogue. Read-only: the only POST
// evaluates a model function and stores nothing. openapi.cpp describes it.

#include <filesystem>
#include <string>

#include "web-ui/server/message.h"
#include "web-ui/server/url.h"

namespace verstat::web {

class Api {
 public:
  /// `database` is opened anew for every request and closed at once, so that no reader holds up a writer's
  /// checkpoints. `version` is the program's.
  Api(std::filesystem::path database, std::string version);

  /// Answers a request whose path begins with "api". Never throws: what goes wrong is an error answer. May be
  /// called from several threads at once.
  [[nodiscard]] Response answer(const Request& request, const Target& target) const;

 private:
  [[nodiscard]] Response route(const Request& request, const Target& target) const;
  [[nodiscard]] Response runs(const Target& target) const;
  [[nodiscard]] Response run(const std::string& id, const Target& target) const;
  [[nodiscard]] Response studies(const Target& target) const;
  [[nodiscard]] Response study(const std::string& id, const Target& target) const;

  std::filesystem::path database_;
  std::string version_;
};

}  // namespace verstat::web
