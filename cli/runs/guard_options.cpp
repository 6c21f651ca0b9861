#include "cli/runs/guard_options.hpp"

#include <stdexcept>

#include "analysis/study/replay/tracking_error_grid.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/result_folder.hpp"

namespace tcert::cli {

void add_tracking_error_option(OptionTable& table, std::string& path) {
  table.add_input(
      "tracking-error",
      path,
      "FILE",
      "a table speed_mps, acceleration_mps2, disturbance, radius_m: a full grid that never falls; "
      "unless given a declared one, for a control loop of 20 ms");
}

TrackingErrorTable tracking_error_table(const std::string& path,
                                        bool decimal_comma,
                                        Progress& progress) {
  if (path.empty()) {
    return TrackingErrorTable();
  }
  const DataFile file = read_data_file(path, {}, decimal_comma, progress);
  try {
    return TrackingErrorTable(study::tracking_error_grid(file.table));
  } catch (const std::invalid_argument& error) {
    throw BadData("'" + path + "': " + error.what());
  }
}

std::optional<ManifestFile> tracking_error_input(const std::string& path) {
  if (path.empty()) {
    return std::nullopt;
  }
  return ManifestFile{std::filesystem::path(path).filename().string(), digest_file(path)};
}

}  // namespace tcert::cli
