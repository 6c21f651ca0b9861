#include "cli/runs/experiment/cell_files.hpp"

#include <algorithm>
#include <optional>

#include "analysis/study/replay/replay_trial.hpp"
#include "analysis/study/trials/study_tables.hpp"
#include "cli/runs/bundle_digest.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/experiment/cell_jobs.hpp"
#include "cli/runs/experiment/chunk_rows.hpp"
#include "cli/runs/program_digest.hpp"
#include "cli/runs/progress.hpp"
#include "reports/features_table.hpp"
#include "reports/replay_table.hpp"
#include "reports/sha256.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kChunk = 64;

/// What the entries of all chunks depend on besides their logs and the job.
std::string common_key(const Bundle& bundle, const LogOptions& logs) {
  std::string text = "rows of a chunk\nprogram " + program_digest() + '\n';
  for (const ManifestFile& file : bundle_inputs(bundle, {})) {
    text += file.digest.sha256 + "  " + file.path + '\n';
  }
  text += logs.repair ? "repair\n" : "";
  text += logs.decimal_comma ? "decimal-comma\n" : "";
  return text;
}

std::string features_text(const study::StudiedTrial& trial, const Table& table) {
  std::string line;
  append_csv_row(line, table, features_row(study::summarise(trial)));
  return line;
}

std::string replay_text(const study::StudiedTrial& trial,
                        const Bundle& bundle,
                        const study::ParameterSet& set,
                        const Table& table) {
  study::ReplaySetup setup;
  setup.laws = {set.speed_law};
  std::string text;
  for (const study::ReplayedTrial& one : study::replay_trial(trial, bundle.info, set, setup)) {
    append_csv_row(text, table, replay_row(one.record));
  }
  return text;
}

class Maker {
 public:
  Maker(const OpenedBundle& opened,
        std::int64_t threads,
        Progress& progress,
        const std::vector<Job>& jobs,
        Cache* store,
        CellFiles& files)
      : opened_(opened),
        threads_(threads),
        progress_(progress),
        jobs_(jobs),
        store_(store),
        files_(files),
        features_(features_table(opened.bundle)),
        replays_(replay_table()),
        key_(common_key(opened.bundle, opened.logs)),
        stage_(progress, "trials", opened.trials.size()) {
    replays_.synthetic = features_.synthetic;
    for (const Job& job : jobs) {
      std::string header;
      append_csv_header(header, table_of(job));
      tables_.push_back(std::move(header));
    }
  }

  void add_chunk(std::span<const std::size_t> trials) {
    const std::string logs = digest_of(trials);
    std::vector<std::optional<ChunkRows>> entries(jobs_.size());
    std::vector<std::string> keys(jobs_.size());
    std::vector<std::size_t> wanted;
    for (std::size_t j = 0; j < jobs_.size(); ++j) {
      keys[j] = key_of(jobs_[j], logs);
      if (const auto stored = store_ != nullptr ? store_->get(keys[j]) : std::nullopt) {
        entries[j] = chunk_rows_from(*stored);
      } else {
        wanted.push_back(j);
      }
    }
    files_.from_cache += jobs_.size() - wanted.size();
    files_.made += wanted.size();
    make(trials, wanted, entries);
    for (const std::size_t j : wanted) {
      if (store_ != nullptr) {
        store_->put(keys[j], to_text(*entries[j]));
      }
    }
    for (std::size_t j = 0; j < jobs_.size(); ++j) {
      tables_[j] += entries[j]->rows;
    }
    if (!entries.empty()) {
      const auto& rejected = entries.front()->rejected;
      files_.rejected.insert(files_.rejected.end(), rejected.begin(), rejected.end());
    }
    done_ += trials.size();
    stage_.reach(done_);
  }

  /// After the last chunk: the tables, one per job.
  std::vector<std::string> finish() {
    files_.inputs = bundle_inputs(opened_.bundle, logs_.finish());
    return std::move(tables_);
  }

 private:
  [[nodiscard]] const Table& table_of(const Job& job) const {
    return job.kind == TableKind::features ? features_ : replays_;
  }

  [[nodiscard]] std::string key_of(const Job& job, const std::string& logs) const {
    return sha256(key_ + logs + (job.kind == TableKind::features ? "features\n" : "replay\n") +
                  job.print);
  }

  [[nodiscard]] std::string text_of(const study::StudiedTrial& trial, const Job& job) const {
    return job.kind == TableKind::features ? features_text(trial, features_)
                                           : replay_text(trial, opened_.bundle, *job.set, replays_);
  }

  std::string digest_of(std::span<const std::size_t> trials) {
    std::string text;
    for (const std::size_t t : trials) {
      const TrialRow& row = opened_.bundle.trials[t];
      const FileDigest digest = log_digest(opened_.bundle, row);
      logs_.add(row.trial_id, digest);
      text += digest.sha256 + "  " + row.trial_id + '\n';
    }
    return text;
  }

  void make(std::span<const std::size_t> trials,
            const std::vector<std::size_t>& wanted,
            std::vector<std::optional<ChunkRows>>& entries) {
    std::vector<study::ParameterSet> sets;
    for (const std::size_t j : wanted) {
      sets.push_back(*jobs_[j].set);
      entries[j].emplace();
    }
    const study::StudyOptions options{{opened_.logs.repair}, static_cast<int>(threads_)};
    const study::CellReuse reuse = study::study_cells(
        opened_.bundle,
        trials,
        sets,
        options,
        [&](study::StudiedTrial& trial, std::size_t set) {
          return text_of(trial, jobs_[wanted[set]]);
        },
        [&](study::CellTrial&& trial) {
          progress_.say(trial.diagnostics);
          for (std::size_t w = 0; w < wanted.size(); ++w) {
            if (trial.rejected) {
              entries[wanted[w]]->rejected.push_back(trial.row->trial_id);
            } else {
              entries[wanted[w]]->rows += trial.texts[w];
            }
          }
        });
    for (const auto part : {&study::CellReuse::read,
                            &study::CellReuse::resample,
                            &study::CellReuse::certify,
                            &study::CellReuse::features}) {
      (files_.reuse.*part).done += (reuse.*part).done;
      (files_.reuse.*part).reused += (reuse.*part).reused;
    }
  }

  const OpenedBundle& opened_;
  std::int64_t threads_;
  Progress& progress_;
  const std::vector<Job>& jobs_;
  Cache* store_;
  CellFiles& files_;
  Table features_;
  Table replays_;
  std::vector<std::string> tables_;
  std::string key_;
  ListDigest logs_;
  Stage stage_;
  std::size_t done_ = 0;
};

/// Jobs of both kinds become two lists of their own: where each job is in the list of its kind.
std::vector<std::size_t> places_of(const Jobs& jobs, CellFiles& files) {
  std::vector<std::size_t> places;
  for (const Job& job : jobs.jobs) {
    auto& list = job.kind == TableKind::features ? files.features : files.replays;
    places.push_back(list.size());
    list.emplace_back();
  }
  const auto placed = [&](std::vector<std::size_t> of) {
    for (std::size_t& job : of) {
      job = job == kNoTable ? job : places[job];
    }
    return of;
  };
  files.features_of = placed(jobs.features_of);
  files.replays_of = placed(jobs.replays_of);
  return places;
}

}  // namespace

CellFiles unmade_files(std::span<const study::PlannedCell> cells) {
  CellFiles files;
  static_cast<void>(places_of(jobs_of(cells), files));
  return files;
}

CellFiles files_of_cells(const OpenedBundle& opened,
                         std::int64_t threads,
                         Progress& progress,
                         std::span<const study::PlannedCell> cells,
                         Cache* store) {
  const Jobs jobs = jobs_of(cells);
  CellFiles files;
  const std::vector<std::size_t> places = places_of(jobs, files);
  Maker maker(opened, threads, progress, jobs.jobs, store, files);
  const std::span<const std::size_t> trials(opened.trials);
  for (std::size_t first = 0; first < trials.size(); first += kChunk) {
    maker.add_chunk(trials.subspan(first, std::min(kChunk, trials.size() - first)));
    if (opened.logs.strict && !files.rejected.empty()) {
      throw BadData("trial '" + files.rejected.front() +
                    "' is rejected, and --strict was asked for");
    }
  }
  std::vector<std::string> tables = maker.finish();
  for (std::size_t j = 0; j < tables.size(); ++j) {
    auto& list = jobs.jobs[j].kind == TableKind::features ? files.features : files.replays;
    list[places[j]] = std::move(tables[j]);
  }
  return files;
}

}  // namespace tcert::cli
