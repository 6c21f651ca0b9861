#include "reports/witness_path_json.hpp"

#include <cmath>
#include <limits>

#include "reports/witness_json.hpp"

namespace tcert {
namespace {

using nlohmann::ordered_json;

constexpr double kMostTurn = 3.0;  // rad

ordered_json number_or_null(double value) {
  return value < std::numeric_limits<double>::infinity() ? ordered_json(value) : ordered_json();
}

void require_within(const witness::Piece& piece, const witness::Lattice& lattice) {
  const auto lies_within = [&](Point p) {
    const int column = lattice.column_of(p.x_m);
    const int row = lattice.row_of(p.y_m);
    return column >= 0 && column < lattice.columns && row >= 0 && row < lattice.rows;
  };
  if (!lies_within(piece.from) || !lies_within(piece.to) ||
      !(std::abs(piece.turn_rad) <= kMostTurn)) {
    throw WitnessFormatError(
        "a piece of the path leaves the box of the free space, or turns by more than 3 rad");
  }
}

}  // namespace

ordered_json point_json(Point p) { return {p.x_m, p.y_m}; }

Point point_from(const ordered_json& json) {
  if (!json.is_array() || json.size() != 2) {
    throw WitnessFormatError("a point is not [x, y]");
  }
  return {json[0].get<double>(), json[1].get<double>()};
}

void add_measured(const witness::Checked& checked, bool has_path, ordered_json& json) {
  json["margin_m"] = has_path ? ordered_json(checked.margin_m) : ordered_json();
  json["clearance_m"] = has_path ? ordered_json(checked.clearance_m) : ordered_json();
  json["turn_radius_m"] = has_path ? number_or_null(checked.turn_radius_m) : ordered_json();
  json["bottleneck"] = has_path ? point_json(checked.bottleneck) : ordered_json();
}

witness::Checked measured_from(const ordered_json& json, bool has_path) {
  witness::Checked checked;
  if (!has_path) {
    for (const char* key : {"margin_m", "clearance_m", "turn_radius_m", "bottleneck"}) {
      if (!json.at(key).is_null()) {
        throw WitnessFormatError(std::string(key) + " is stated of no path");
      }
    }
    return checked;
  }
  checked.margin_m = json.at("margin_m");
  checked.clearance_m = json.at("clearance_m");
  const ordered_json& radius = json.at("turn_radius_m");
  checked.turn_radius_m =
      radius.is_null() ? std::numeric_limits<double>::infinity() : radius.get<double>();
  checked.bottleneck = point_from(json.at("bottleneck"));
  return checked;
}

ordered_json path_json(const witness::Path& path) {
  ordered_json json = ordered_json::array();
  for (const witness::Piece& piece : path) {
    json.push_back({{"from", point_json(piece.from)},
                    {"to", point_json(piece.to)},
                    {"turn_rad", piece.turn_rad}});
  }
  return json;
}

witness::Path path_from(const ordered_json& json, const witness::Lattice& lattice) {
  witness::Path path;
  for (const ordered_json& piece : json) {
    path.push_back(
        {point_from(piece.at("from")), point_from(piece.at("to")), piece.at("turn_rad")});
    require_within(path.back(), lattice);
  }
  return path;
}

}  // namespace tcert
