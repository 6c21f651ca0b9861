#include "cli/runs/report/courses.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <table/path_name.hpp>
#include <utility>

#include "cli/runs/errors.hpp"
#include "datasets/bundle_files.hpp"
#include "datasets/world.hpp"
#include "reports/html/trial_block.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

/// A file of the bundle; none for a name that leads elsewhere.
std::optional<std::string> find(const BundleFiles& files, const std::string& name) {
  return files.problem().empty() && table::leads_below(name) ? files.find(name) : std::nullopt;
}

/// True unless the manifest names a trials.csv with another digest; of a .zip, results made of the
/// archive list the archive, those made of its folder the trials.csv in it.
bool is_input_of(const Bundle& bundle, const Result& certified) {
  const auto& inputs = certified.manifest.inputs;
  std::error_code error;
  const bool archive = fs::is_regular_file(bundle.path, error);
  const BundleFiles files(bundle.path);
  return std::all_of(inputs.begin(), inputs.end(), [&](const ManifestFile& input) {
    if (input.path.ends_with(".zip")) {
      return archive && digest_file(bundle.path).sha256 == input.digest.sha256;
    }
    if (!input.path.starts_with("trials.csv")) {
      return true;
    }
    const auto found = find(files, input.path);
    if (!found) {
      return false;
    }
    if (!archive) {
      return digest_file(bundle.path / *found).sha256 == input.digest.sha256;
    }
    const table::BytesResult bytes = files.read(*found);
    return bytes.bytes && sha256(bytes.bytes->view()) == input.digest.sha256;
  });
}

/// The column `world` of trials.csv, or the trial's own name.
std::map<std::string, std::string, std::less<>> worlds_of(const Bundle& bundle) {
  const auto column = std::find(bundle.extra_columns.begin(), bundle.extra_columns.end(), "world");
  const auto at = static_cast<std::size_t>(column - bundle.extra_columns.begin());
  std::map<std::string, std::string, std::less<>> worlds;
  for (const TrialRow& row : bundle.trials) {
    worlds[row.trial_id] = column == bundle.extra_columns.end() ? row.trial_id : row.extra[at];
  }
  return worlds;
}

}  // namespace

Courses::Courses(const Results& results, const Result& certified, const std::string& path) {
  const Result* corpus = results.find(ResultKind::corpus);
  corpus = corpus == nullptr ? results.find(ResultKind::driven) : corpus;
  if (path.empty() && corpus == nullptr) {
    missing_ =
        "No courses on the maps: the results do not hold the logs. --bundle FOLDER shows where "
        "they "
        "are.";
    return;
  }
  const fs::path folder = path.empty() ? corpus->folder : fs::path(path);
  std::error_code error;
  if (!fs::exists(folder, error)) {
    throw NoInput("there is no bundle at '" + folder.string() + "'");
  }
  BundleResult opened = open_bundle(folder);
  if (!opened.bundle) {
    throw BadData(
        "'" + folder.string() + "' is not a bundle" +
        (opened.diagnostics.empty() ? "" : ": " + table::to_string(opened.diagnostics.front())));
  }
  if (!is_input_of(*opened.bundle, certified)) {
    const std::string words = "'" + folder.filename().string() + "' is not the bundle that '" +
                              certified.name + "' was made from";
    if (!path.empty()) {
      throw BadData(words + "; name the right one");
    }
    missing_ = "No courses on the maps: " + words + ".";
    return;
  }
  bundle_ = std::move(opened.bundle);
  world_of_ = worlds_of(*bundle_);
}

std::string Courses::file_of(std::string_view trial_id) const {
  const auto known = world_of_.find(trial_id);
  return "worlds/" + (known == world_of_.end() ? std::string(trial_id) : known->second) + ".json";
}

bool Courses::has_walls(std::string_view trial_id) const {
  return bundle_ && find(BundleFiles(bundle_->path), file_of(trial_id)).has_value();
}

std::optional<std::string> Courses::block(std::string_view trial_id) const {
  if (!bundle_) {
    return std::nullopt;
  }
  const std::string name = file_of(trial_id);
  const BundleFiles files(bundle_->path);
  World world;
  if (const auto found = find(files, name)) {
    const table::BytesResult bytes = files.read(*found);
    if (!bytes.bytes) {
      throw BadData(name + ": " + bytes.problem);
    }
    try {
      world = world_from_json(bytes.bytes->view());
    } catch (const WorldFormatError& cause) {
      throw BadData(name + ": " + cause.what());
    }
  }
  if (!world.start) {
    world.start = bundle_->info.course.start;
  }
  if (!world.goal) {
    world.goal = bundle_->info.course.goal;
  }
  return world_block(world);
}

}  // namespace tcert::cli
