#include "cli/runs/live/live_bundle.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <table/bytes.hpp>
#include <utility>

#include "cli/runs/errors.hpp"
#include "datasets/bundle_files.hpp"
#include "datasets/bundle_json.hpp"

namespace tcert::cli {

BundleInfo describe(const std::string& path, Progress& progress) {
  if (path.empty()) {
    throw UsageError("needs --bundle");
  }
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw NoInput("no bundle at '" + path + "'");
  }
  const bool is_json = std::filesystem::path(path).extension() == ".json";
  if (!is_json && !BundleFiles(path).contains("bundle.json")) {
    throw BadData("'" + path + "' holds no bundle.json: name a bundle or its bundle.json");
  }
  table::BytesResult bytes =
      is_json ? table::read_file(path) : BundleFiles(path).read("bundle.json");
  if (!bytes.bytes) {
    throw BadData("'" + path + "': " + bytes.problem);
  }
  table::DiagnosticGroups problems;
  auto info = parse_bundle_json(bytes.bytes->view(), problems);
  progress.say(problems.take());
  if (!info) {
    throw BadData("'" + path + "' is not a bundle.json that can be used");
  }
  return std::move(*info);
}

Runtime runtime_of(const Course& course, const ActionSetup& actions) {
  try {
    return {course, actions};
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace tcert::cli
