#include <fmt/format.h>

#include <table/row_text.hpp>

#include "cli/runs/batch/batch.hpp"
#include "cli/runs/batch/job_scripts.hpp"
#include "cli/runs/batch/part.hpp"

namespace tcert::cli {
namespace {

std::vector<std::uint64_t> missing_shards(const ReadPlan& plan, Progress& progress) {
  std::vector<std::uint64_t> missing;
  Stage stage(progress, "parts", plan.plan.shards);
  for (std::uint64_t shard = 0; shard < plan.plan.shards; ++shard) {
    if (!has_part(plan, shard)) {
      missing.push_back(shard);
    }
    stage.advance();
  }
  return missing;
}

/// The items of the parts that are there.
ItemSource items_of_parts(const ReadPlan& plan, const std::vector<std::uint64_t>& missing) {
  return [&plan, &missing](const std::vector<ItemSet>& sets, const TakeItem& take) {
    require_items(plan.plan, sets);
    auto next = missing.begin();
    for (std::uint64_t shard = 0; shard < plan.plan.shards; ++shard) {
      if (next != missing.end() && *next == shard) {
        ++next;
        continue;
      }
      read_part(plan, shard, [&](std::uint64_t item, std::string_view line) {
        const ItemPlace place = place_of(sets, item);
        try {
          take(place.set, place.item, line);
        } catch (const table::RowError& error) {
          throw BadData(fmt::format(
              "the part '{}', item {}: {}", part_path(plan, shard).string(), item, error.what()));
        }
      });
    }
  };
}

}  // namespace

OptionTable options_of(MergeRequest& request) {
  OptionTable table(request.given);
  table.argument({"PLAN", &request.plan, true, OptionRole::input});
  table.add(
      "partial",
      request.partial,
      "show what the parts that are there come to, though some are missing; nothing is written");
  add_common(table, request);
  return table;
}

ExitCode merge(const MergeRequest& request, Progress& progress) {
  if (request.partial && !request.output.path.empty()) {
    throw UsageError("--partial shows and writes nothing: it does not go with --output");
  }
  const ReadPlan plan = read_plan(request.plan);
  const std::vector<std::uint64_t> missing = missing_shards(plan, progress);
  if (!missing.empty()) {
    const std::string count =
        fmt::format("{} of {} shards are missing", missing.size(), plan.plan.shards);
    if (!request.partial) {
      progress.say(count + ". To make them,\n" +
                   commands_for(missing, plan.plan, std::filesystem::absolute(request.plan)));
      return exit_rejected;
    }
    progress.say("PARTIAL: " + count + "; what follows is without them.");
  }
  const std::string output = request.partial ? ""
                             : !request.output.path.empty()
                                 ? request.output.path
                                 : (plan.folder / "result" / "").string();
  const ExitCode code =
      plan.plan.pieces().finish(output, request.threads, progress, items_of_parts(plan, missing));
  if (!missing.empty()) {
    return exit_rejected;
  }
  if (!output.empty()) {
    table::sweep_leftovers_in(plan.folder / "parts");
    progress.sum_up("The result of " + std::to_string(plan.plan.count()) + " items is in '" +
                    output + "'.");
  }
  return code;
}

}  // namespace tcert::cli
