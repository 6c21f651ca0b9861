#pragma once
/// \file
/// `batch`: a command in pieces. Plan them, make them in any order, on any machines of one kind,
/// and merge them: the result is that of the command alone, byte for byte.

#include <optional>
#include <string>

#include "cli/runs/batch/plan.hpp"
#include "cli/runs/shared_options.hpp"
#include "cli/runs/written_options.hpp"

namespace tcert::cli {

/// What is planned: the request of a command, with its output as the folder of the plan.
template <class Request>
struct PlanRequest : Request {
  std::optional<std::int64_t> shards;
};

/// The inputs of a request: the names that words of a plan have for them, and their absolute paths.
[[nodiscard]] std::vector<PlanInput> inputs_of(const OptionTable& table);

/// \throws UsageError for an option that says how, not what: it is told to the work.
void require_no_process_options(const OptionTable& table);

/// Writes a plan into a new folder. \throws UsageError if the command has no items; WriteError.
[[nodiscard]] ExitCode write_plan(Plan plan,
                                  const std::vector<ItemSet>& sets,
                                  const std::string& folder,
                                  Progress& progress);

template <class Request>
[[nodiscard]] OptionTable options_of(PlanRequest<Request>& request) {
  OptionTable table = options_of(static_cast<Request&>(request));
  table
      .add("shards",
           request.shards,
           "N",
           "into how many pieces the work is cut; each should last minutes")
      .within(1, static_cast<double>(kMostShards));
  return table;
}

/// \param command "study". \throws UsageError, NoInput, BadData, WriteError.
template <class Request>
[[nodiscard]] ExitCode plan_batch(const std::string& command,
                                  const PlanRequest<Request>& request,
                                  Progress& progress) {
  Request alone = request;
  const std::string folder = alone.output.path;
  if (folder.empty() || !request.shards) {
    throw UsageError("needs --shards N and --output PLAN");
  }
  alone.output.path.clear();
  require_no_process_options(options_of(alone));
  Plan plan;
  plan.command = command;
  plan.arguments = written(alone).arguments;
  plan.inputs = inputs_of(options_of(alone));
  plan.shards = static_cast<std::uint64_t>(*request.shards);
  return write_plan(std::move(plan), items_of(alone, progress), folder, progress);
}

struct WorkRequest {
  std::string plan;
  std::string shard;        ///< "I/N"; empty: from the environment of a job array.
  std::int64_t offset = 0;  ///< Added to the number of a task.
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

struct MergeRequest {
  std::string plan;
  bool partial = false;
  OutputPath output;
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(WorkRequest& request);
[[nodiscard]] OptionTable options_of(MergeRequest& request);

/// Makes one shard, unless it is there. \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode work(const WorkRequest& request, Progress& progress);

/// Makes of the parts what the command makes. exit_rejected, with nothing made, if a part is
/// missing. \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode merge(const MergeRequest& request, Progress& progress);

}  // namespace tcert::cli
