#include "cli/runs/batch/trial_features.hpp"

#include <map>
#include <optional>
#include <utility>

#include "cli/runs/certify_trials.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/scratch_folder.hpp"
#include "cli/runs/thread_limit.hpp"
#include "cli/runs/written_options.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {
namespace {

/// Trials whose logs are on disk at a time.
constexpr std::uint64_t kOnDisk = 64;

/// Some of the trials as a bundle, as long as it lives.
struct MadeBundle {
  template <class Request>
  MadeBundle(const Request& request, ItemRange trials, Progress& progress) {
    const auto folder = scratch.path() / "bundle";
    make_trials(request, trials, folder);
    opened = open_for(folder.string(), LogOptions{}, progress);
  }

  ScratchFolder scratch;
  OpenedBundle opened;
};

std::vector<std::string> rows_of(const MadeBundle& made, std::int64_t threads, Progress& progress) {
  const Bundle& bundle = made.opened.bundle;
  const Table table = features_table(bundle);
  std::map<std::string, std::string> rows;
  static_cast<void>(
      certify_trials(made.opened, threads, progress, nullptr, {}, [&](study::TrialRecord&& trial) {
        std::string& row = rows[trial.row.trial.trial_id];
        append_csv_row(row, table, features_row(trial));
        row.pop_back();  // The line feed.
      }));
  std::vector<std::string> lines;
  for (const TrialRow& trial : bundle.trials) {
    lines.push_back(std::move(rows[trial.trial_id]));
  }
  return lines;
}

template <class Request>
std::vector<ItemSet> items(const Request& request, Progress& progress) {
  const auto make = [request, &progress](std::uint64_t first,
                                         std::uint64_t last,
                                         const std::function<void()>& /*done*/) {
    OnlyWords words(progress);
    return rows_of(MadeBundle(request, {first, last}, words), request.threads, words);
  };
  return {{"trials", trials_of(request), kOnDisk, make}};
}

template <class Request>
ExitCode features(const char* command,
                  const Request& request,
                  Progress& progress,
                  const ItemSource& source) {
  const ThreadLimit limit(request.threads);
  std::optional<ResultFolder> folder;
  std::optional<ResultFile> file;
  if (!request.output.path.empty()) {
    folder.emplace(request.output.path, command);
    file.emplace(folder->staging() / "features.csv");
  }
  const auto write = [&](std::string_view text) {
    if (file) {
      file->write(text);
    } else {
      progress.show(text);
    }
  };
  const MadeBundle one(request, {0, 1}, progress);
  std::string header;
  append_csv_header(header, features_table(one.opened.bundle));
  write(header);
  std::uint64_t rejected = 0;
  source(items(request, progress),
         [&](std::size_t /*set*/, std::uint64_t /*trial*/, std::string_view line) {
           if (line.empty()) {
             ++rejected;
           } else {
             write(std::string(line) + '\n');
           }
         });
  if (folder) {
    file->close();
    Manifest manifest;
    manifest.command = command;
    record(written(request), manifest);
    manifest.seed = static_cast<std::uint64_t>(request.seed);
    manifest.parameters = as_settings(one.opened.parameters, one.opened.bundle.info.robot);
    manifest.synthetic = synthetic_label(one.opened.bundle.info);
    folder->commit(std::move(manifest));
  }
  if (rejected > 0) {
    progress.say(std::to_string(rejected) + " trials are rejected");
    return exit_rejected;
  }
  return exit_done;
}

}  // namespace

std::vector<ItemSet> items_of(const SimulateRequest& request, Progress& progress) {
  if (request.micro_study) {
    throw UsageError("--micro-study: its 60 passes are made at once, not in pieces");
  }
  return items(request, progress);
}

std::vector<ItemSet> items_of(const DriveRequest& request, Progress& progress) {
  return items(request, progress);
}

ExitCode simulated_features(const SimulateRequest& request,
                            Progress& progress,
                            const ItemSource& source) {
  return features("batch simulate", request, progress, source);
}

ExitCode driven_features(const DriveRequest& request,
                         Progress& progress,
                         const ItemSource& source) {
  return features("batch drive", request, progress, source);
}

ExitCode simulated_features(const SimulateRequest& request, Progress& progress) {
  return simulated_features(request, progress, made_here(progress));
}

ExitCode driven_features(const DriveRequest& request, Progress& progress) {
  return driven_features(request, progress, made_here(progress));
}

}  // namespace tcert::cli
