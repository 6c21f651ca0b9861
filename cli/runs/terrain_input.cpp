#include "cli/runs/terrain_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <terrain/components.hpp>
#include <terrain/limits.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

static_assert(kMostTerrainSide == terrain::kMostSide);
static_assert(kLargestTerrainValue == terrain::kLargestValue);

template <class Word>
[[nodiscard]] Word word_of(const char* option,
                           const std::string& value,
                           const std::vector<std::pair<std::string, Word>>& words) {
  std::vector<std::string> names;
  std::string expected;
  for (const auto& [name, word] : words) {
    if (name == value) {
      return word;
    }
    names.push_back(name);
    expected += (expected.empty() ? "" : " or ") + name;
  }
  throw UsageError(fmt::format(
      "--{}: found '{}', expected {}{}", option, value, expected, did_you_mean(value, names)));
}

[[nodiscard]] NodataRule nodata_rule(const std::string& text) {
  NodataRule rule;
  if (text == "auto") {
    return rule;
  }
  if (text == "none") {
    rule.recognise = false;
    return rule;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || std::isnan(value)) {
    throw UsageError("--nodata: found '" + text + "', expected a number, auto or none");
  }
  rule.declared = value;
  return rule;
}

constexpr std::string_view kSyntheticPrefix = "SYNTHETIC data, seed ";

}  // namespace

TerrainFileOptions terrain_file_options(const std::string& header,
                                        const std::string& format,
                                        const std::string& nodata) {
  TerrainFileOptions options;
  options.header = word_of<TerrainHeader>(
      "header",
      header,
      {{"auto", TerrainHeader::detect}, {"yes", TerrainHeader::yes}, {"no", TerrainHeader::no}});
  options.format = word_of<TerrainFormat>("terrain-format",
                                          format,
                                          {{"auto", TerrainFormat::detect},
                                           {"grid", TerrainFormat::grid},
                                           {"xyz", TerrainFormat::points},
                                           {"esri", TerrainFormat::esri}});
  options.nodata = nodata_rule(nodata);
  return options;
}

TerrainGrid read_terrain_or_throw(const std::string& path,
                                  const TerrainFileOptions& options,
                                  Progress& progress) {
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) {
    throw NoInput("cannot read the terrain '" + path + "': there is no such file");
  }
  TerrainFileResult file = read_terrain(path, options);
  progress.say(file.diagnostics);
  if (!file.terrain) {
    throw BadData("'" + path + "' is no terrain");
  }
  for (const std::string& note : file.notes) {
    progress.say(fmt::format("{}: {}.", path, note));
  }
  return std::move(*file.terrain);
}

void say_of_threshold(const std::string& path,
                      const TerrainGrid& terrain,
                      double threshold,
                      Progress& progress) {
  double low = terrain::kLargestValue;
  double high = -terrain::kLargestValue;
  for (const double v : terrain.values) {
    low = std::isnan(v) ? low : std::min(low, v);
    high = std::isnan(v) ? high : std::max(high, v);
  }
  if (high >= threshold && low < threshold) {
    return;
  }
  progress.say(
      fmt::format("{}: {} cell is safe: the values run from {:g} to {:g}, {} below the "
                  "threshold {:g} (--threshold).",
                  path,
                  high < threshold ? "no" : "every",
                  low,
                  high,
                  high < threshold ? "all" : "none",
                  threshold));
}

std::optional<SyntheticLabel> label_of(const TerrainGrid& grid) {
  if (grid.header.rfind(kSyntheticPrefix, 0) != 0) {
    return std::nullopt;
  }
  return SyntheticLabel{std::strtoull(grid.header.c_str() + kSyntheticPrefix.size(), nullptr, 10)};
}

terrain::CellSet blocked_cells(const TerrainGrid& terrain,
                               const std::string& obstacles,
                               const TerrainFileOptions& options,
                               Progress& progress) {
  terrain::CellSet blocked(terrain.values.size());
  std::transform(terrain.values.begin(), terrain.values.end(), blocked.begin(), [](double v) {
    return std::isnan(v) ? std::uint8_t{1} : std::uint8_t{0};
  });
  if (!obstacles.empty()) {
    TerrainFileOptions layer_options = options;
    layer_options.header = TerrainHeader::detect;
    layer_options.format = TerrainFormat::detect;
    // A value that means a gap of the terrain may be a free cell's here.
    layer_options.nodata.declared.reset();
    const TerrainGrid layer = read_terrain_or_throw(obstacles, layer_options, progress);
    if (layer.rows != terrain.rows || layer.columns != terrain.columns) {
      throw BadData(fmt::format("'{}': found {} x {} cells, expected the terrain's {} x {}",
                                obstacles,
                                layer.rows,
                                layer.columns,
                                terrain.rows,
                                terrain.columns));
    }
    for (std::size_t i = 0; i < blocked.size(); ++i) {
      // A gap of the layer is not known to be free.
      blocked[i] = blocked[i] != 0 || layer.values[i] != 0.0 ? 1 : 0;
    }
  }
  return terrain::count(blocked) > 0 ? blocked : terrain::CellSet{};
}

void require_free(const terrain::Grid& grid,
                  const TerrainGrid& terrain,
                  const terrain::CellSet& blocked,
                  terrain::Cell start,
                  const std::vector<terrain::Cell>& goals) {
  if (blocked.empty()) {
    return;
  }
  const auto require = [&](const char* name, terrain::Cell cell) {
    if (blocked[grid.index(cell)] != 0) {
      throw BadData(fmt::format("the {} ({}, {}) lies in {}; name another cell",
                                name,
                                cell.x,
                                cell.y,
                                std::isnan(terrain.values[grid.index(cell)])
                                    ? "a gap of the terrain, where nothing is known"
                                    : "a physical obstacle"));
    }
  };
  require("start", start);
  terrain::CellSet free(blocked.size());
  std::transform(blocked.begin(), blocked.end(), free.begin(), [](std::uint8_t b) {
    return b == 0 ? std::uint8_t{1} : std::uint8_t{0};
  });
  const terrain::CellSet reach = terrain::component_of(grid, free, start);
  for (const terrain::Cell goal : goals) {
    require("goal", goal);
    if (reach[grid.index(goal)] == 0) {
      throw BadData(fmt::format(
          "the goal ({}, {}) cannot be reached whatever the ground is: obstacles or gaps "
          "lie all the way between it and the start ({}, {})",
          goal.x,
          goal.y,
          start.x,
          start.y));
    }
  }
}

}  // namespace tcert::cli
