#include "datasets/bundle.hpp"

#include <iterator>
#include <utility>

#include "datasets/bundle_files.hpp"
#include "datasets/bundle_json.hpp"
#include "datasets/trial_table.hpp"

namespace tcert {

namespace {

void append(std::vector<table::Diagnostic>& all, table::DiagnosticGroups& of_one_file) {
  std::vector<table::Diagnostic> more = of_one_file.take();
  all.insert(all.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

/// Bytes of a file that every bundle has; its absence is reported.
std::optional<table::Bytes> read_required(const BundleFiles& files,
                                          const std::string& name,
                                          table::DiagnosticGroups& problems) {
  const auto found = files.find(name);
  if (!found) {
    problems.add({table::Severity::error, name, 0, "", "", "this file in the bundle", 1});
    return std::nullopt;
  }
  table::BytesResult result = files.read(*found);
  if (!result.bytes) {
    problems.add({table::Severity::error, *found, 0, "", result.problem, "a readable file", 1});
  }
  return std::move(result.bytes);
}

table::Diagnostic no_bundle(const std::filesystem::path& path, const BundleFiles& files) {
  return {table::Severity::error,
          path.string(),
          0,
          "",
          files.problem(),
          "a folder or a .zip with a bundle.json",
          1};
}

/// Empty, and said why, if bundle.json cannot be used.
std::optional<BundleInfo> info_in(const BundleFiles& files, table::DiagnosticGroups& problems) {
  const auto bytes = read_required(files, "bundle.json", problems);
  return bytes ? parse_bundle_json(bytes->view(), problems) : std::nullopt;
}

}  // namespace

BundleInfoResult read_bundle_info(const std::filesystem::path& path) {
  BundleInfoResult result;
  const BundleFiles files(path);
  if (!files.problem().empty()) {
    result.diagnostics.push_back(no_bundle(path, files));
    return result;
  }
  table::DiagnosticGroups problems;
  result.info = info_in(files, problems);
  result.diagnostics = problems.take();
  return result;
}

BundleResult open_bundle(const std::filesystem::path& path, const BundleOptions& options) {
  BundleResult result;
  const BundleFiles files(path);
  if (!files.problem().empty()) {
    result.diagnostics.push_back(no_bundle(path, files));
    return result;
  }
  Bundle bundle;
  bundle.path = path;
  bundle.decimal_comma = options.decimal_comma;
  table::DiagnosticGroups problems;
  std::optional<BundleInfo> info = info_in(files, problems);
  const bool usable = info.has_value();
  bundle.info = std::move(info).value_or(BundleInfo{});
  append(result.diagnostics, problems);
  if (const auto bytes = read_required(files, "trials.csv", problems)) {
    read_trial_table(*bytes, bundle, problems);
  }
  append(result.diagnostics, problems);
  if (usable && !bundle.trials.empty()) {
    result.bundle = std::move(bundle);
  }
  return result;
}

}  // namespace tcert
