#pragma once
/// \file
/// A path and what is measured of it, as the file of a witness has them.

#include <nlohmann/json.hpp>
#include <tcert/geometry.hpp>
#include <witness/checker.hpp>
#include <witness/free_cells.hpp>
#include <witness/path.hpp>

namespace tcert {

[[nodiscard]] nlohmann::ordered_json point_json(Point p);
/// \throws WitnessFormatError if it is not [x, y].
[[nodiscard]] Point point_from(const nlohmann::ordered_json& json);

/// Margin, clearance, radius and bottleneck, all null where there is no path.
void add_measured(const witness::Checked& checked, bool has_path, nlohmann::ordered_json& json);
[[nodiscard]] witness::Checked measured_from(const nlohmann::ordered_json& json, bool has_path);

[[nodiscard]] nlohmann::ordered_json path_json(const witness::Path& path);
/// \throws WitnessFormatError if a piece leaves the box of the lattice or turns by more than 3 rad:
/// it is no path, and whoever draws it would have endless work.
[[nodiscard]] witness::Path path_from(const nlohmann::ordered_json& json,
                                      const witness::Lattice& lattice);

}  // namespace tcert
