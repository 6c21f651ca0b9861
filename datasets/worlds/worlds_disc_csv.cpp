#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <table/cell_reading.hpp>
#include <table/csv.hpp>

#include "datasets/worlds/region_distance.hpp"
#include "datasets/worlds/world_files.hpp"

namespace tcert {
namespace {

void widen(Bounds& bounds, const Region& region) {
  const Extent extent = extent_of(region);
  bounds.low.x_m = std::min(bounds.low.x_m, extent.low.x_m);
  bounds.low.y_m = std::min(bounds.low.y_m, extent.low.y_m);
  bounds.high.x_m = std::max(bounds.high.x_m, extent.high.x_m);
  bounds.high.y_m = std::max(bounds.high.y_m, extent.high.y_m);
}

Bounds bounds_of(const World& world) {
  const Extent first = extent_of(world.obstacles.front());
  Bounds bounds{first.low, first.high};
  for (const Region& obstacle : world.obstacles) {
    widen(bounds, obstacle);
  }
  for (const auto& region : {world.start, world.goal}) {
    if (region) {
      widen(bounds, *region);
    }
  }
  return bounds;
}

std::optional<double> finite_cell(std::string_view cell) {
  const table::CellReading reading = table::read_cell(cell);
  const bool is_number =
      reading.meaning == table::CellMeaning::number && std::isfinite(reading.value);
  return is_number ? std::optional(reading.value) : std::nullopt;
}

}  // namespace

WorldsResult worlds_from_disc_csv(const table::Bytes& bytes,
                                  const std::string& file,
                                  const WorldFrame& frame) {
  WorldsResult result;
  table::DiagnosticGroups problems;
  table::CsvOptions csv;
  csv.file = file;
  const std::vector<std::string> names{"world", "x_m", "y_m", "radius_m"};
  const auto table = table::read_text_table(bytes, csv, names, problems);
  if (!table) {
    result.diagnostics = problems.take();
    return result;
  }
  const std::size_t name_column = *table->find("world");
  std::map<std::string, std::size_t, std::less<>> index;
  std::vector<bool> bad;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    const std::string& name = table->at(row, name_column);
    const auto [place, fresh] = index.emplace(name, result.worlds.size());
    if (fresh) {
      result.worlds.emplace_back();
      result.worlds.back().name = name;
      bad.push_back(false);
    }
    std::array<double, 3> values{};
    bool good = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string& cell = table->at(row, *table->find(names[k + 1]));
      const auto value = finite_cell(cell);
      if (!value || (k == 2 && !(*value > 0.0))) {
        problems.add({table::Severity::error,
                      file,
                      table->lines[row],
                      names[k + 1],
                      table::shortened(cell),
                      std::string(k == 2 ? "a positive number" : "a finite number") + "; world '" +
                          table::shortened(name) + "' is left out",
                      1});
        good = false;
      } else {
        values[k] = *value;
      }
    }
    if (good) {
      result.worlds[place->second].obstacles.emplace_back(Disc{{values[0], values[1]}, values[2]});
    } else {
      bad[place->second] = true;
    }
  }
  std::vector<World> kept;
  for (std::size_t i = 0; i < result.worlds.size(); ++i) {
    World& world = result.worlds[i];
    if (bad[i]) {
      continue;
    }
    world.start = frame.start;
    world.goal = frame.goal;
    world.bounds = frame.bounds ? *frame.bounds : bounds_of(world);
    kept.push_back(std::move(world));
  }
  result.worlds = std::move(kept);
  if (table->rows() == 0) {
    problems.add({table::Severity::error, file, 0, "", "", "a disc, but the file has no rows", 1});
  }
  result.diagnostics = problems.take();
  return result;
}

}  // namespace tcert
