#include "cli/runs/import_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "datasets/import/import_log.hpp"

namespace tcert::cli {
namespace {

/// "pose 2010 of 2010 rows", of all trials that are in the bundle.
std::string use_of_stream(const recording::LogImportResult& result, std::size_t stream) {
  std::size_t rows = 0;
  std::size_t used = 0;
  for (const recording::ImportedTrial& trial : result.trials) {
    if (!trial.rejected) {
      rows += trial.streams[stream].use.rows;
      used += trial.streams[stream].use.used;
    }
  }
  return fmt::format("{} {} of {} rows", result.streams[stream], used, rows);
}

void sum_up(const recording::LogImportResult& result,
            const std::string& output,
            Progress& progress) {
  const auto count = [&](auto&& holds) {
    return std::count_if(result.trials.begin(), result.trials.end(), holds);
  };
  const auto rejected = count([](const auto& trial) { return trial.rejected; });
  const auto successes = count([](const auto& trial) { return trial.success.value_or(false); });
  const auto failures = count([](const auto& trial) { return !trial.success.value_or(true); });
  const auto kept = static_cast<std::ptrdiff_t>(result.trials.size()) - rejected;
  std::string used;
  for (std::size_t i = 0; i < result.streams.size(); ++i) {
    used += (used.empty() ? "" : ", ") + use_of_stream(result, i);
  }
  progress.sum_up(
      fmt::format("Imported {} trial{} ({} successes, {} failures, {} of unknown "
                  "outcome), {} ray{}; {}. Bundle: {}",
                  kept,
                  kept == 1 ? "" : "s",
                  successes,
                  failures,
                  kept - successes - failures,
                  result.rays,
                  result.rays == 1 ? "" : "s",
                  used,
                  output));
  progress.sum_up(
      fmt::format("Next: 'tcert check {0}' looks at its values, 'tcert certify {0} "
                  "--output results' certifies it{1}.",
                  output,
                  result.has_goal ? ""
                                  : "; without a goal in the map ('course') there is "
                                    "no certificate, only the on-policy corridor "
                                    "value"));
}

}  // namespace

OptionTable options_of(ImportLogRequest& request) {
  OptionTable table(request.given);
  table.argument({"FORMAT", &request.format});
  table.argument({"SOURCE", &request.source, true, OptionRole::input});
  table.rest(request.more_sources);
  table.add_input(
      "map",
      request.map,
      "FILE",
      "which topics or columns are the streams; 'tcert check SOURCE --write-map' drafts "
      "it, 'tcert help map' lists its keys");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode import_log(const ImportLogRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty()) {
    throw UsageError("needs --output DIR");
  }
  if (request.map.empty()) {
    throw UsageError("needs --map FILE; 'tcert check " + request.source +
                     " --write-map map.json' drafts one");
  }
  std::vector<std::filesystem::path> sources{request.source};
  sources.insert(sources.end(), request.more_sources.begin(), request.more_sources.end());
  std::vector<std::filesystem::path> read = sources;
  read.emplace_back(request.map);
  for (const std::filesystem::path& path : read) {
    if (!std::filesystem::exists(path)) {
      throw NoInput("there is nothing at " + path.string());
    }
  }
  std::optional<Stage> stage;
  const recording::LogImportResult result =
      recording::import_log(sources,
                            request.map,
                            output,
                            {request.decimal_comma},
                            [&](std::size_t done, std::size_t all) {
                              if (!stage) {
                                stage.emplace(progress, "trials imported", all);
                              }
                              stage->reach(done);
                            });
  stage.reset();
  progress.say(result.diagnostics);
  if (!result.is_written) {
    throw BadData("nothing is written: no trial of " + request.source + " can be used by " +
                  request.map);
  }
  sum_up(result, output, progress);
  const bool any_rejected = std::any_of(
      result.trials.begin(), result.trials.end(), [](const auto& trial) { return trial.rejected; });
  return any_rejected ? exit_rejected : exit_done;
}

}  // namespace tcert::cli
