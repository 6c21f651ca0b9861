#include <string>

#include "datasets/import/bag.hpp"
#include "datasets/import/bag_folder.hpp"
#include "datasets/import/file_window.hpp"
#include "datasets/import/sqlite_bag.hpp"

namespace tcert::recording {
namespace {

constexpr std::size_t kLookedAt = 16;

std::string first_bytes(const std::filesystem::path& path, std::string& problem) {
  auto window = FileWindow::open(path, problem);
  if (!window) {
    return {};
  }
  const auto bytes = window->at(0, kLookedAt);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

BagKind kind_of(const std::filesystem::path& path, std::string& problem) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    return is_bag_folder(path) ? BagKind::folder : BagKind::none;
  }
  const std::string bytes = first_bytes(path, problem);
  if (begins_as_mcap(bytes)) {
    return BagKind::mcap;
  }
  return begins_as_sqlite(bytes) ? BagKind::sqlite : BagKind::none;
}

}  // namespace

BagKind bag_kind(const std::filesystem::path& path) {
  std::string ignored;
  return kind_of(path, ignored);
}

std::unique_ptr<Bag> open_bag(const std::filesystem::path& path,
                              table::DiagnosticGroups& problems) {
  std::string problem;
  switch (kind_of(path, problem)) {
    case BagKind::mcap:
      return open_mcap(path, problems);
    case BagKind::sqlite:
      return open_sqlite_bag(path, problems);
    case BagKind::folder:
      return open_bag_folder(path, problems);
    case BagKind::none:
      break;
  }
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    return open_bag_folder(path, problems);  // which says why it is none
  }
  problems.add({table::Severity::error,
                path.string(),
                0,
                "",
                "",
                problem.empty() ? "an MCAP file, the database of a rosbag2 or the folder of one"
                                : "a readable file: " + problem,
                1});
  return nullptr;
}

}  // namespace tcert::recording
