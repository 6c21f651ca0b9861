#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "cli/runs/batch/batch.hpp"
#include "cli/runs/batch/part.hpp"
#include "cli/runs/thread_limit.hpp"

namespace tcert::cli {
namespace {

std::optional<std::uint64_t> whole(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

/// The number of this task of a job array, counted from 0.
std::optional<std::uint64_t> task() {
  const auto number = [](const char* name) -> std::optional<std::uint64_t> {
    const char* const text = std::getenv(name);
    return text == nullptr ? std::nullopt : whole(text);
  };
  if (const auto slurm = number("SLURM_ARRAY_TASK_ID")) {
    return slurm;
  }
  const auto grid_engine = number("SGE_TASK_ID");  // "undefined" outside of an array.
  return grid_engine && *grid_engine > 0 ? std::optional(*grid_engine - 1) : std::nullopt;
}

/// \throws UsageError.
std::uint64_t shard_of(const WorkRequest& request, std::uint64_t shards) {
  std::optional<std::uint64_t> shard;
  if (request.shard.empty()) {
    shard = task();
    if (!shard) {
      throw UsageError(
          "needs --shard I/N, or the number of a task of an array of Slurm "
          "(SLURM_ARRAY_TASK_ID) or Grid Engine (SGE_TASK_ID)");
    }
    *shard = std::min(*shard, kMostShards) + static_cast<std::uint64_t>(request.offset);
  } else {
    if (is_given(request.given, "offset")) {
      throw UsageError("--offset is added to the number of a task; it does nothing to --shard");
    }
    const auto slash = request.shard.find('/');
    shard = whole(request.shard.substr(0, slash));
    const auto count =
        slash == std::string::npos ? std::nullopt : whole(request.shard.substr(slash + 1));
    if (!shard || !count) {
      throw UsageError(
          fmt::format("--shard: found '{}', expected I/N, such as 0/{}", request.shard, shards));
    }
    if (*count != shards) {
      throw UsageError(fmt::format("--shard: found {} shards, the plan has {}", *count, shards));
    }
  }
  if (*shard >= shards) {
    throw UsageError(
        fmt::format("shard {} is none of the plan, which has 0 to {}", *shard, shards - 1));
  }
  return *shard;
}

/// What this process has taken: "12.3 s of CPU time, 45 MB at most".
std::string used() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return fmt::format("{:.1f} s of CPU time, {} MB at most",
                     seconds(usage.ru_utime) + seconds(usage.ru_stime),
                     usage.ru_maxrss / 1024);
}

}  // namespace

OptionTable options_of(WorkRequest& request) {
  OptionTable table(request.given);
  table.argument({"PLAN", &request.plan, true, OptionRole::input});
  table.add("shard",
            request.shard,
            "I/N",
            "which shard of the plan, from 0 to N - 1; unless given the number of this task of a "
            "job array");
  table
      .add("offset",
           request.offset,
           "K",
           "added to the number of a task, for more shards than an array may have tasks")
      .within(0, static_cast<double>(kMostShards));
  add_common(table, request);
  return table;
}

ExitCode work(const WorkRequest& request, Progress& progress) {
  const ReadPlan plan = read_plan(request.plan);
  const std::uint64_t shard = shard_of(request, plan.plan.shards);
  const std::string name = fmt::format("shard {}/{}", shard, plan.plan.shards);
  if (has_part(plan, shard)) {
    progress.sum_up(name + " is there already.");
    return exit_done;
  }
  const ThreadLimit limit(request.threads);
  const std::vector<ItemSet> sets = plan.plan.pieces().items(request.threads, progress);
  require_items(plan.plan, sets);
  PartWriter part(plan, shard);
  const ItemRange range = plan.plan.range_of(shard);
  make_items(sets, range, progress, [&](std::uint64_t item, std::string_view line) {
    part.add(item, line);
  });
  const bool first = part.commit();
  progress.sum_up(fmt::format("{}: {} items{}; {}.",
                              name,
                              range.last - range.first,
                              first ? "" : ", the same that another process made meanwhile",
                              used()));
  return exit_done;
}

}  // namespace tcert::cli
