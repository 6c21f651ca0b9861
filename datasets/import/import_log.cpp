#include "datasets/import/import_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <table/atomic_file.hpp>
#include <table/path_name.hpp>
#include <table/text_file.hpp>
#include <utility>

#include "datasets/bundle_json.hpp"
#include "datasets/import/bag_streams.hpp"
#include "datasets/import/csv_streams.hpp"
#include "datasets/import/import_words.hpp"
#include "datasets/import/judge_trial.hpp"
#include "datasets/import/trial_outcomes.hpp"
#include "datasets/import/trial_sources.hpp"
#include "datasets/stream_clock.hpp"
#include "datasets/trial_table.hpp"

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;
using table::Severity;

/// The bundle.json that comes of the map and the rays; its problems are those of the map's file.
std::optional<BundleInfo> bundle_info(const LogMap& map,
                                      const std::vector<RayLayout>& layouts,
                                      const std::string& map_file,
                                      table::DiagnosticGroups& problems) {
  nlohmann::json document = map.bundle;
  document["format"] = "tcert-bundle";
  document["version"] = 1;
  if (!document.contains("robot")) {
    document["robot"] = nlohmann::json::object();
  }
  document["rays"] = nlohmann::json::array();
  for (const RayLayout& layout : layouts) {
    for (const nlohmann::json& ray : layout.rays) {
      document["rays"].push_back(ray);
    }
  }
  table::DiagnosticGroups found;
  std::optional<BundleInfo> info = parse_bundle_json(document.dump(), found);
  for (table::Diagnostic& problem : found.take()) {
    problem.file = map_file;
    problems.add(std::move(problem));
  }
  return info;
}

/// One import, from the map to the bundle.
class Importer {
 public:
  Importer(const std::vector<fs::path>& sources,
           fs::path map_file,
           LogMap map,
           const LogImportOptions& options)
      : sources_(sources),
        map_file_(std::move(map_file)),
        map_(std::move(map)),
        options_(options) {}

  LogImportResult run(const fs::path& output, const TrialsDone& done) {
    table::DiagnosticGroups problems;
    const std::vector<TrialSource> found = find_trials(sources_, map_, problems);
    const bool usable = !found.empty() && !problems.has_error();
    const auto whole = std::ranges::find(found, std::string(), &TrialSource::problem);
    layouts_ = usable && whole != found.end() ? layouts_of(*whole, problems) : std::nullopt;
    info_ = layouts_ ? bundle_info(map_, *layouts_, map_file_.string(), problems) : std::nullopt;
    if (info_ &&
        !(map_.bundle.contains("robot") && map_.bundle["robot"].contains("body_width_m"))) {
      problems.add({Severity::warning,
                    map_file_.string(),
                    0,
                    "robot.body_width_m",
                    "",
                    fmt::format("the width of the body; without it {} m is taken",
                                info_->robot.body_width_m),
                    1});
    }
    take(problems);
    for (std::size_t i = 0; i < number_of_streams(map_); ++i) {
      result_.streams.push_back(key_of(map_, i));
    }
    if (!info_ || !outcomes_are_good(found)) {
      return std::move(result_);
    }
    result_.rays = info_->robot.rays.size();
    result_.has_goal = info_->course.goal.has_value();
    table::AtomicFolder folder(output);
    for (std::size_t i = 0; i < found.size(); ++i) {
      read(found[i], folder.staging() / "logs");
      if (done) {
        done(i + 1, found.size());
      }
    }
    write(folder);
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::optional<std::vector<RayLayout>> layouts_of(
      const TrialSource& trial, table::DiagnosticGroups& problems) const {
    if (trial.bag.empty()) {
      return find_layouts(trial.files, map_, {options_.decimal_comma}, problems);
    }
    const auto bag = open_bag(trial.bag, problems);
    return bag ? find_layouts(*bag, trial.bag.string(), map_, problems) : std::nullopt;
  }

  [[nodiscard]] std::vector<fs::path> table_folders() const {
    const fs::path beside = map_file_.parent_path();
    std::vector<fs::path> folders{beside.empty() ? fs::path(".") : beside};
    for (const fs::path& source : sources_) {
      std::error_code ignored;
      folders.push_back(fs::is_directory(source, ignored) ? source : source.parent_path());
    }
    return folders;
  }

  /// A table that would refuse the import is said before the hours that the streams may take.
  [[nodiscard]] bool outcomes_are_good(const std::vector<TrialSource>& found) {
    std::vector<TrialRow> rows;
    for (const TrialSource& trial : found) {
      rows.emplace_back().trial_id = trial.trial_id;
    }
    table::DiagnosticGroups problems;
    if (map_.trials.column.empty()) {
      read_outcomes(map_, table_folders(), options_.decimal_comma, rows, problems);
    }
    const bool good = !problems.has_error();
    if (!good) {
      take(problems);
    }
    return good;
  }

  void read(const TrialSource& source, const fs::path& logs) {
    // A trial's problems are its own: the same ones of two trials are two lines.
    table::DiagnosticGroups problems;
    std::map<std::string, std::unique_ptr<StreamSet>, std::less<>> sets;
    std::vector<std::string> order;
    const auto window_ns = to_nanoseconds(info_->max_gap_s);
    const auto reject = [&](const std::string& found, const std::string& expectation) {
      problems.add({Severity::error,
                    source.files.empty() ? "" : source.files.front().string(),
                    0,
                    map_.trials.column,
                    table::shortened(found),
                    expectation,
                    1});
      return nullptr;
    };
    const auto set_of = [&](std::string_view name) -> StreamSet* {
      const std::string trial = source.trial_id.empty() ? std::string(name) : source.trial_id;
      if (!table::is_file_name(trial)) {
        return reject(trial, std::string(table::kFileNameRule) + "; its rows are not used");
      }
      if (!sets.contains(trial) && !names_.insert(trial).second) {
        return reject(trial, "each trial in one source; its rows are not used");
      }
      auto& set = sets[trial];
      if (!set) {
        set = std::make_unique<StreamSet>(map_, *layouts_, logs / trial, window_ns);
        order.push_back(trial);
      }
      return set.get();
    };
    bool read_all = false;
    std::vector<fs::path> files = source.files;
    if (!source.problem.empty()) {
      problems.add({Severity::error,
                    source.place.string(),
                    0,
                    "",
                    "no file",
                    source.problem + "; the trial is rejected",
                    1});
    } else if (source.bag.empty()) {
      read_all = read_csv_streams(
          source.files, map_, *layouts_, {options_.decimal_comma}, set_of, problems);
    } else if (const auto bag = open_bag(source.bag, problems)) {
      files = {source.bag};
      read_all =
          read_bag_streams(*bag, source.bag.string(), map_, *layouts_, *set_of(""), problems);
    }
    if (order.empty()) {
      if (!problems.has_error()) {
        reject("no rows", "rows below the header; the trial is rejected");
      }
      result_.trials.push_back({source.trial_id, true, {}, {}});
    }
    for (const std::string& trial : order) {
      ImportedTrial imported{trial, !read_all, {}, sets[trial]->finish()};
      if (read_all) {
        judge_trial(map_, imported, logs / trial, files, problems);
      }
      std::error_code ignored;
      if (imported.rejected) {
        fs::remove_all(logs / trial, ignored);
      } else if (map_.control && imported.streams.back().use.used == 0) {
        fs::remove(logs / trial / "control.csv", ignored);
      }
      result_.trials.push_back(std::move(imported));
    }
    take(problems);
  }

  void write(table::AtomicFolder& folder) {
    std::vector<TrialRow> rows;
    std::vector<std::size_t> places_of;
    for (std::size_t i = 0; i < result_.trials.size(); ++i) {
      const ImportedTrial& trial = result_.trials[i];
      if (!trial.rejected) {
        TrialRow row;
        row.trial_id = trial.trial_id;
        row.time_s = duration_of(trial);
        rows.push_back(std::move(row));
        places_of.push_back(i);
      }
    }
    table::DiagnosticGroups problems;
    if (!rows.empty()) {
      read_outcomes(map_, table_folders(), options_.decimal_comma, rows, problems);
    }
    const bool good = !rows.empty() && !problems.has_error();
    take(problems);
    if (!good) {
      return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      result_.trials[places_of[i]].success = rows[i].success;
    }
    info_->provenance = "Imported from " + places_in_words(sources_) + " by map.json" +
                        use_in_words(map_, result_.trials);
    table::write_file_atomically(folder.staging() / "bundle.json", to_bundle_json(*info_));
    table::write_file_atomically(folder.staging() / "trials.csv", to_trials_csv(rows, {}));
    table::write_file_atomically(folder.staging() / "map.json", map_.document.dump(2) + "\n");
    folder.commit();
    result_.is_written = true;
  }

  [[nodiscard]] double duration_of(const ImportedTrial& trial) const {
    const StreamUse& pose = trial.streams[0].use;
    const StreamUse rays = use_of_rays(map_, trial);
    return 1e-9 * static_cast<double>(std::min(pose.last_ns, rays.last_ns) -
                                      std::max(pose.first_ns, rays.first_ns));
  }

  void take(table::DiagnosticGroups& problems) {
    std::ranges::move(problems.take(), std::back_inserter(result_.diagnostics));
  }

  const std::vector<fs::path>& sources_;
  fs::path map_file_;
  LogMap map_;
  LogImportOptions options_;
  std::optional<std::vector<RayLayout>> layouts_;
  std::optional<BundleInfo> info_;
  std::set<std::string> names_;  // of the trials so far
  LogImportResult result_;
};

}  // namespace

LogImportResult import_log(const std::vector<fs::path>& sources,
                           const fs::path& map_file,
                           const fs::path& output,
                           const LogImportOptions& options,
                           const TrialsDone& done) {
  LogImportResult result;
  const table::BytesResult file = table::read_text_file(map_file);
  if (!file.bytes) {
    result.diagnostics.push_back(
        {Severity::error, map_file.string(), 0, "", file.problem, "a readable file", 1});
    return result;
  }
  table::DiagnosticGroups problems;
  std::optional<LogMap> map = parse_log_map(file.bytes->view(), map_file.string(), problems);
  if (!map) {
    result.diagnostics = problems.take();
    return result;
  }
  return Importer(sources, map_file, std::move(*map), options).run(output, done);
}

}  // namespace tcert::recording
