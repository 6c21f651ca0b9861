#include "datasets/import/trial_sources.hpp"

#include <algorithm>
#include <set>
#include <table/path_name.hpp>
#include <utility>

#include "datasets/import/bag.hpp"

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;
using table::Severity;

constexpr std::string_view kMark = "{trial}";
constexpr std::size_t kMostSourceFiles = 100'000;
constexpr int kDeepestSourceFolder = 8;

void fail(const fs::path& place,
          std::string found,
          std::string expectation,
          table::DiagnosticGroups& problems) {
  problems.add(
      {Severity::error, place.string(), 0, "", std::move(found), std::move(expectation), 1});
}

std::string without_compression(std::string name) {
  for (const char* const end : {".gz", ".zst"}) {
    if (name.ends_with(end)) {
      name.resize(name.size() - std::string_view(end).size());
    }
  }
  return name;
}

/// "run_07" of "run_07.csv.gz", of "run_07/", of "run_07.mcap".
std::string name_of_trial(const fs::path& source) {
  fs::path path = source;
  if (!path.has_filename()) {
    path = path.parent_path();
  }
  std::error_code ignored;
  path = fs::is_directory(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
  std::string name = path.filename().string();
  if (!fs::is_directory(path, ignored)) {
    name = without_compression(std::move(name));
    const std::size_t dot = name.rfind('.');
    name.resize(dot == 0 ? name.size() : std::min(dot, name.size()));
  }
  return table::as_file_name(name);
}

/// Files below a folder, by their path in it, sorted.
std::vector<std::string> files_below(const fs::path& folder, table::DiagnosticGroups& problems) {
  std::vector<std::string> files;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (at.depth() >= kDeepestSourceFolder) {
      at.disable_recursion_pending();
    }
    std::error_code ignored;
    if (at->is_regular_file(ignored)) {
      files.push_back(at->path().lexically_relative(folder).generic_string());
    }
    if (files.size() > kMostSourceFiles) {
      fail(folder, "more than 100,000 files", "a folder of logs", problems);
      return {};
    }
  }
  if (error) {
    fail(folder, error.message(), "a readable folder", problems);
  }
  std::ranges::sort(files);
  return files;
}

/// What stands for {trial} in `file`, everywhere the same; empty if it does not fit.
std::string trial_in(const std::string& pattern, const std::string& file) {
  const std::size_t mark = pattern.find(kMark);
  const std::string before = pattern.substr(0, mark);
  const std::string rest = pattern.substr(mark + kMark.size());
  if (!file.starts_with(before)) {
    return "";
  }
  for (std::size_t end = before.size() + 1; end <= file.size() && file[end - 1] != '/'; ++end) {
    std::string trial = file.substr(before.size(), end - before.size());
    std::string whole = pattern;
    for (std::size_t at = whole.find(kMark); at != std::string::npos;
         at = whole.find(kMark, at + trial.size())) {
      whole.replace(at, kMark.size(), trial);
    }
    if (whole == file) {
      return trial;
    }
  }
  return "";
}

std::string with_trial(std::string pattern, const std::string& trial) {
  for (std::size_t at = pattern.find(kMark); at != std::string::npos;
       at = pattern.find(kMark, at + trial.size())) {
    pattern.replace(at, kMark.size(), trial);
  }
  return pattern;
}

/// `path`, or it with the end of a compressed file.
fs::path existing(const fs::path& path) {
  std::error_code ignored;
  for (const char* const end : {"", ".gz", ".zst"}) {
    fs::path candidate = path;
    candidate += end;
    if (fs::is_regular_file(candidate, ignored)) {
      return candidate;
    }
  }
  return {};
}

/// Fills the files of a trial, and what is wrong with them.
void find_files(const fs::path& source, const LogMap& map, TrialSource& trial) {
  std::error_code ignored;
  const bool is_folder = fs::is_directory(source, ignored);
  for (std::size_t i = 0; i < number_of_streams(map); ++i) {
    const std::string& name = stream_at(map, i).file;
    const bool is_control = i > map.rays.size();
    const fs::path wanted =
        !is_folder && name.empty() ? source : source / with_trial(name, trial.trial_id);
    fs::path file = existing(wanted);
    if (file.empty() && !is_control && trial.problem.empty()) {
      trial.place = wanted;
      trial.problem = is_folder && name.empty()
                          ? "'file' of " + key_of(map, i) + " in the map: which file of this folder"
                          : "the file of " + key_of(map, i) + ", as the map names it";
    }
    trial.files.push_back(std::move(file));
  }
}

void find_bags(const fs::path& source,
               std::vector<TrialSource>& trials,
               table::DiagnosticGroups& problems) {
  if (bag_kind(source) != BagKind::none) {
    trials.push_back({name_of_trial(source), source, {}, {}, {}});
    return;
  }
  std::vector<fs::path> bags;
  std::error_code error;
  for (fs::directory_iterator at(source, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (bag_kind(at->path()) != BagKind::none) {
      bags.push_back(at->path());
    }
  }
  if (bags.empty()) {
    fail(source,
         "no bag",
         "an MCAP file, a rosbag2 database, or a folder of them; 'tcert check " + source.string() +
             "' says what it is",
         problems);
  }
  std::ranges::sort(bags);
  for (const fs::path& bag : bags) {
    trials.push_back({name_of_trial(bag), bag, {}, {}, {}});
  }
}

void find_csv_trials(const fs::path& source,
                     const LogMap& map,
                     std::vector<TrialSource>& trials,
                     table::DiagnosticGroups& problems) {
  const std::string& pattern = map.pose.file;
  if (pattern.find(kMark) == std::string::npos) {
    TrialSource trial;
    trial.trial_id = map.trials.column.empty() ? name_of_trial(source) : "";
    find_files(source, map, trial);
    if (!trial.problem.empty()) {
      fail(trial.place, "no file", trial.problem, problems);
    } else {
      trials.push_back(std::move(trial));
    }
    return;
  }
  const std::size_t before = trials.size();
  for (const std::string& file : files_below(source, problems)) {
    if (file == map.trials.table) {
      continue;
    }
    TrialSource trial;
    trial.trial_id = trial_in(pattern, without_compression(file));
    if (!trial.trial_id.empty()) {
      find_files(source, map, trial);
      trials.push_back(std::move(trial));
    }
  }
  if (trials.size() == before && !problems.has_error()) {
    fail(source, "no file", "files like " + pattern + ", as the map names the pose", problems);
  }
}

}  // namespace

std::vector<TrialSource> find_trials(const std::vector<fs::path>& sources,
                                     const LogMap& map,
                                     table::DiagnosticGroups& problems) {
  std::vector<TrialSource> trials;
  for (const fs::path& source : sources) {
    if (!map.pose.topic.empty()) {
      find_bags(source, trials, problems);
    } else {
      find_csv_trials(source, map, trials, problems);
    }
  }
  std::set<std::string> names;
  for (const TrialSource& trial : trials) {
    if (!trial.trial_id.empty() && !table::is_file_name(trial.trial_id)) {
      fail(trial.trial_id, "this trial", std::string(table::kFileNameRule), problems);
    }
    if (!trial.trial_id.empty() && !names.insert(trial.trial_id).second) {
      fail(
          trial.trial_id, "two sources of this name", "a name of its own for each trial", problems);
    }
  }
  return trials;
}

}  // namespace tcert::recording
