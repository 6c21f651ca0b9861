#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "cli/runs/study/studies.hpp"
#include "cli/runs/terrain_input.hpp"
#include "reports/study/terrain_report.hpp"

namespace tcert::cli {
namespace {

using terrain::Terrain;

FitReport scenarios_of(const StudyRequest& request, Progress& progress) {
  TerrainFileOptions reading;
  reading.header = TerrainHeader::yes;  // As the published program does.
  TerrainGrid file = read_terrain_or_throw(request.terrain, reading, progress);
  const std::optional<SyntheticLabel> label = label_of(file);
  const Terrain ground{{file.rows, file.columns}, std::move(file.values)};
  for (const terrain::study::Scenario& scenario : terrain::study::scenarios()) {
    if (!ground.grid.contains(scenario.start) ||
        (scenario.goal && !ground.grid.contains(*scenario.goal))) {
      throw BadData(
          fmt::format("'{}': found {} x {} cells, too few for scenario {} of the thesis, "
                      "whose terrain has 600 x 400",
                      request.terrain,
                      ground.grid.rows,
                      ground.grid.columns,
                      scenario.name));
    }
  }
  try {
    const auto seeds = static_cast<std::size_t>(request.seeds);
    std::optional<Stage> stage;
    const auto runs =
        terrain::study::run_scenarios(ground, seeds, [&](std::size_t done, std::size_t total) {
          if (!stage) {
            stage.emplace(progress, "runs", total);
          }
          stage->reach(done);
        });
    return scenario_report(runs, terrain::study::run_baselines(ground, seeds), label);
  } catch (const std::invalid_argument& error) {
    throw BadData("'" + request.terrain + "': " + error.what());
  } catch (const std::domain_error& error) {
    throw BadData("'" + request.terrain + "': " + error.what());
  }
}

}  // namespace

StudyItems terrain_study(const StudyRequest& request, Progress& progress) {
  StudyItems items;
  if (!request.terrain.empty()) {
    items.report = [request, &progress] { return scenarios_of(request, progress); };
    return items;
  }
  const auto terrains = static_cast<std::uint64_t>(request.terrains);
  const auto seed = static_cast<std::uint64_t>(request.seed);
  constexpr std::size_t kTold = 6;
  const auto rates = std::make_shared<std::vector<TerrainRates>>();
  for (const bool trust : {false, true}) {
    for (const double told : {1.0, 0.75, 0.5}) {
      rates->push_back({{told, trust}, {}});
    }
  }
  for (const double beta : {3.0, 9.0, 16.0, 25.0, 36.0}) {
    rates->push_back({{1.0, true, beta}, {}});
  }
  for (const TerrainRates& row : *rates) {
    items.sets.push_back(
        independent_items("terrains", terrains, [telling = row.telling, seed](std::uint64_t i) {
          return table::row_text(terrain::study::explore_terrain(telling, seed, i));
        }));
  }
  items.take = [rates](std::size_t set, std::uint64_t /*terrain*/, std::string_view line) {
    rates->at(set).found.add(table::from_row<terrain::study::TerrainOutcome>(line));
  };
  items.report = [rates, seed] {
    const auto middle = rates->begin() + kTold;
    return terrain_soundness_report({rates->begin(), middle}, {middle, rates->end()}, seed);
  };
  return items;
}

StudyItems price_study(const StudyRequest& request, Progress& /*progress*/) {
  StudyItems items;
  const auto terrains = static_cast<std::uint64_t>(request.terrains);
  const auto seed = static_cast<std::uint64_t>(request.seed);
  const auto rows = std::make_shared<std::vector<PriceRow>>();
  for (terrain::study::PriceCell& cell : terrain::study::price_cells()) {
    rows->push_back({std::move(cell), {}});
  }
  for (const PriceRow& row : *rows) {
    items.sets.push_back(
        independent_items("terrains", terrains, [cell = row.cell, seed](std::uint64_t i) {
          return table::row_text(terrain::study::explore_at_price(cell, seed, i));
        }));
  }
  items.take = [rows](std::size_t set, std::uint64_t /*terrain*/, std::string_view line) {
    rows->at(set).found.add(table::from_row<terrain::study::PriceOutcome>(line));
  };
  items.report = [rows, seed] { return price_report(*rows, seed); };
  return items;
}

}  // namespace tcert::cli
