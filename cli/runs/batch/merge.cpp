#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <table/row_text.hpp>

#include "cli/runs/batch/batch.hpp"
#include "cli/runs/batch/job_scripts.hpp"
#include "cli/runs/batch/part.hpp"

namespace tcert::cli {
namespace {

struct Gaps {
  std::vector<std::uint64_t> shards;  ///< Missing, or of no use; ascending.
  std::string words;                  ///< Why some are of no use, a line each;
  std::string paths;                  ///< and where these lie, for a shell.
};

Gaps gaps_of(const ReadPlan& plan, Progress& progress) {
  Gaps gaps;
  Stage stage(progress, "parts", plan.plan.shards);
  for (std::uint64_t shard = 0; shard < plan.plan.shards; ++shard) {
    try {
      if (!has_part(plan, shard)) {
        gaps.shards.push_back(shard);
      }
    } catch (const BadData& error) {
      gaps.shards.push_back(shard);
      gaps.words += std::string(error.what()) + '\n';
      gaps.paths += ' ' + quoted(part_path(plan, shard).string());
    }
    stage.advance();
  }
  return gaps;
}

/// "3, 17 to 19": some of them, if they are many.
std::string in_words(const std::vector<std::uint64_t>& shards) {
  constexpr std::size_t kMostRuns = 12;
  std::string text;
  std::size_t runs = 0;
  for (std::size_t i = 0; i < shards.size();) {
    if (runs++ == kMostRuns) {
      return text + " and more";
    }
    std::size_t end = i + 1;
    while (end < shards.size() && shards[end] == shards[end - 1] + 1) {
      ++end;
    }
    text += fmt::format("{}{}", text.empty() ? "" : ", ", shards[i]);
    text += end - i > 1 ? fmt::format(" to {}", shards[end - 1]) : "";
    i = end;
  }
  return text;
}

/// What tasks have left that were killed, or that made a shard which another one had made.
void remove_leftovers(const ReadPlan& plan) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(plan.folder / "parts", error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') && name.ends_with(".tmp")) {
      std::filesystem::remove(entry.path(), error);
    }
  }
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
  const Gaps gaps = gaps_of(plan, progress);
  if (!gaps.words.empty()) {
    progress.say(gaps.words.substr(0, gaps.words.size() - 1));
  }
  if (!gaps.shards.empty()) {
    const std::string count = fmt::format("{} of {} shards missing{}: {}",
                                          gaps.shards.size(),
                                          plan.plan.shards,
                                          gaps.words.empty() ? "" : " or of no use",
                                          in_words(gaps.shards));
    if (!request.partial) {
      const auto place = [&](const char* name) { return quoted((plan.folder / name).string()); };
      const std::string remove = gaps.paths.empty() ? "" : "rm -r" + gaps.paths + " && ";
      progress.say(count + ". This makes them, and the merge again:\n  " + remove + "sh " +
                   place("submit") + "\nor, without Slurm:\n  " + remove + "sh " +
                   place("run_parallel") + " && tcert batch merge " + quoted(plan.folder.string()) +
                   (std::filesystem::exists(plan.folder / "logs")
                        ? "\nWhy a task failed is in " + place("logs") + "."
                        : ""));
      if (!gaps.words.empty()) {
        throw BadData("nothing is merged: parts are damaged or foreign, see above");
      }
      return exit_rejected;
    }
    progress.show("# PARTIAL: " + count + "; what follows is without them.\n");
  }
  const std::filesystem::path place = request.output.path.empty()
                                          ? plan.folder / "result"
                                          : std::filesystem::path(request.output.path);
  const std::string output = request.partial ? "" : (place / "").string();
  const ExitCode code = plan.plan.pieces().finish(
      output, request.threads, progress, items_of_parts(plan, gaps.shards));
  if (request.partial) {
    return gaps.shards.empty() ? code : exit_rejected;
  }
  remove_leftovers(plan);
  progress.sum_up(fmt::format("The result of {} items is in '{}'.", plan.plan.count(), output));
  return code;
}

}  // namespace tcert::cli
