#pragma once
/// \file
/// The rays of a stream as the bundle has them, and what their columns of tactile.csv are.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "datasets/import/log_map.hpp"

namespace tcert::recording {

/// What a scan says of its beams.
struct ScanGeometry {
  std::size_t beams = 0;
  double angle_min_rad = 0.0;
  double angle_increment_rad = 0.0;
  std::optional<double> range_min_m;
  std::optional<double> range_max_m;
  ScanOffset offset;  ///< Found out, if it was asked for.

  /// The same beams; a scanner that is turned or moved is another.
  [[nodiscard]] bool has_beams_of(const ScanGeometry& other) const noexcept;
};

struct RayColumns {
  std::string name;
  bool bends = false;
  double reach_m = 0.0;
  ValueSource value;   ///< Of a scan: its beam, plain.
  ValueSource force;   ///< Not given: the ray has no column of force.
  NoReturn no_return;  ///< Of the ray and its stream together.
};

struct RayLayout {
  std::vector<RayColumns> columns;
  std::vector<nlohmann::json> rays;      ///< For bundle.json, one a column.
  std::optional<ScanGeometry> geometry;  ///< Of a scan.

  /// Of its columns: their names in tactile.csv, the value and, if it is given, the force of each.
  [[nodiscard]] std::vector<std::string> column_names() const;
};

/// Of rays that the map lists.
[[nodiscard]] RayLayout layout_of(const StreamSource& stream);

/// Of a scan: rays "<prefix>000", "<prefix>004", ... by beam, at angle_min + i angle_increment from
/// the scanner, which may be turned; their reach is that of the map, or the scan's longest range.
/// \pre the stream is of a scan.
[[nodiscard]] RayLayout layout_of(const StreamSource& stream,
                                  const ScanGeometry& geometry,
                                  const std::string& prefix);

/// "181 beams from -1.57 rad by 0.0175, 0.1 to 8 m, at (0.2, 0, 0)".
[[nodiscard]] std::string in_words(const ScanGeometry& scan);

/// True if two scans have the same rays to a micrometre and a microradian, mounts and limits with
/// them: one robot carried both.
[[nodiscard]] bool are_same_rays(const RayLayout& a, const RayLayout& b);

}  // namespace tcert::recording
