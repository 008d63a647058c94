#pragma once
// A table of the shop's own data, fitted by a child process as `verstat fit` does it.

#include <nlohmann/json_fwd.hpp>

#include "web-ui/server/jobs.h"

namespace verstat::web {

/// The job that `body` asks for: {"kind": "fit", "fit": {"what": "life", "table": TEXT, "file":
/// "removals.csv", "columns": {"life": "Cutting time, min"}, "options": {"to": "/inserts/0"}}}. The table is
/// text of at most 2 MiB, the options are those of `verstat fit WHAT` without the dashes. Throws Refused
/// (400) naming the member, its value and what would be right.
[[nodiscard]] JobSpec fit_job(const nlohmann::json& body);

}  // namespace verstat::web
