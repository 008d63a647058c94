#pragma once
// The REST interface /api/v1 over the results database, the model catalogue and the queue of jobs.
// openapi.cpp describes it; api_*.cpp hold the handlers.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "web-ui/server/jobs.h"
#include "web-ui/server/message.h"
#include "web-ui/server/url.h"

namespace verstat::web {

class Api {
 public:
  /// `database` is opened anew for every request and closed at once, so that no reader holds up a writer's
  /// checkpoints. `version` is the program's. Without `jobs` the interface is read-only: it evaluates and
  /// plans, but starts and stores nothing.
  Api(std::filesystem::path database, std::string version, std::shared_ptr<Jobs> jobs = nullptr,
      std::vector<std::string> study_flags = {});

  /// Answers a request whose path begins with "api". Never throws: what goes wrong is an error answer. May be
  /// called from several threads at once.
  [[nodiscard]] Response answer(const Request& request, const Target& target) const;

  /// Every method and address there is, as openapi.cpp writes them: "GET", "/runs/{id}".
  [[nodiscard]] static std::vector<std::pair<std::string_view, std::string_view>> routes();

 private:
  [[nodiscard]] Response route(const Request& request, const Target& target) const;

  std::filesystem::path database_;
  std::string version_;
  std::shared_ptr<Jobs> jobs_;
  std::vector<std::string> study_flags_;
};

}  // namespace verstat::web
