#pragma once
// One function per address and method of /api/v1. Each throws Refused, or an error of the layer it asks; Api
// turns them into answers.

#include <filesystem>
#include <string>
#include <vector>

#include "web-ui/server/jobs.h"
#include "web-ui/server/message.h"
#include "web-ui/server/url.h"

namespace verstat::web {

struct Call {
  const std::filesystem::path& database;
  const std::string& version;
  Jobs* jobs;  ///< null: read-only
  const std::vector<std::string>& study_flags;
  const Request& request;
  const Target& target;
  std::vector<std::string> parameters;  ///< the steps that stand for {id}, {key}
};

// api_results.cpp
Response list_runs(const Call& call);
Response show_run(const Call& call);
Response show_run_scenario(const Call& call);
Response list_studies(const Call& call);
Response show_study(const Call& call);
Response list_trials(const Call& call);
Response list_tags(const Call& call);
Response annotate_run(const Call& call);
Response annotate_study(const Call& call);

// api_models.cpp
Response list_models(const Call& call);
Response show_model(const Call& call);
Response evaluate_model(const Call& call);
Response map_model(const Call& call);
Response list_kinds(const Call& call);
Response make_plan(const Call& call);
Response show_schema(const Call& call);
Response check_scenario(const Call& call);

// api_jobs.cpp
Response list_jobs(const Call& call);
Response show_job(const Call& call);
Response start_job(const Call& call);
Response cancel_job(const Call& call);
Response follow_job(const Call& call);
Response show_output(const Call& call);

}  // namespace verstat::web
