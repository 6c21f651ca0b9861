#include "reports/study/terrain_report.hpp"

#include <cmath>
#include <statistics/basics/quantile.hpp>

#include "reports/columns_of.hpp"
#include "reports/study/study_summary.hpp"

namespace tcert {
namespace {

using terrain::study::BaselineRun;
using terrain::study::ScenarioRun;
using terrain::study::Soundness;

auto count(std::size_t Soundness::*member) {
  return [member](const TerrainRates& row) { return static_cast<std::int64_t>(row.found.*member); };
}

ColumnsOf<TerrainRates>& add_found(ColumnsOf<TerrainRates>& columns) {
  return columns.integer("terrains", "terrains", count(&Soundness::terrains))
      .integer(
          "with_unsafe_cells", "with unsafe cells held safe", count(&Soundness::with_unsafe_cells))
      .integer("with_unsafe_visits", "with a step onto one", count(&Soundness::with_unsafe_visits));
}

Table told_table(const std::vector<TerrainRates>& rows) {
  ColumnsOf<TerrainRates> columns;
  columns
      .fixed("told", "told, of L", "", 2, [](const TerrainRates& row) { return row.telling.told; })
      .yes_or_no("model_trusted", "model trusted", [](const TerrainRates& row) {
        return row.telling.trusted;
      });
  add_found(columns)
      .integer("contradicted", "L found contradicted", count(&Soundness::contradicted))
      .integer("reached", "reached", count(&Soundness::reached))
      .integer("not_reachable", "not reachable", count(&Soundness::not_reachable))
      .integer("limit", "ended by the limit", count(&Soundness::limit))
      .fixed("mean_samples", "mean measurements", "", 1, [](const TerrainRates& row) {
        return row.found.mean_samples();
      });
  Table table =
      columns.table("terrain_soundness", "What the certified rules hold safe that is not", rows);
  table.footnotes = {"Random terrains of 48 x 36 cells, length scale 8, threshold at their mean."};
  return table;
}

Table trust_table(const std::vector<TerrainRates>& rows) {
  ColumnsOf<TerrainRates> columns;
  columns.number("beta", "beta", [](const TerrainRates& row) { return row.telling.beta; })
      .fixed("sd", "band", "sd", 2, [](const TerrainRates& row) {
        return std::sqrt(row.telling.beta);
      });
  add_found(columns)
      .integer("reached", "reached", count(&Soundness::reached))
      .fixed("mean_samples", "mean measurements", "", 1, [](const TerrainRates& row) {
        return row.found.mean_samples();
      });
  return columns.table(
      "terrain_trust", "What a band of the model costs that is trusted with certifying", rows);
}

Table scenario_table(const std::vector<ScenarioRun>& runs) {
  const auto whole = [](auto value) {
    return [value](const ScenarioRun& run) { return static_cast<std::int64_t>(value(run)); };
  };
  ColumnsOf<ScenarioRun> columns;
  columns.text("scenario", "scenario", &ScenarioRun::scenario)
      .text("variant", "rules", &ScenarioRun::variant)
      .integer("seed", "seed", &ScenarioRun::seed)
      .text("end",
            "end",
            [](const ScenarioRun& run) { return std::string(to_string(run.result.end)); })
      .integer("iterations", "iterations", whole([](const ScenarioRun& run) {
                 return run.result.steps.size();
               }))
      .integer("first", "measured first", &ScenarioRun::first)
      .integer("safe", "safe cells", whole([](const ScenarioRun& run) {
                 return run.result.last().safe;
               }))
      .integer("unsafe_visits", "steps onto unsafe cells", whole([](const ScenarioRun& run) {
                 return run.result.last().unsafe_visits;
               }))
      .integer("unsafe_certified", "unsafe cells held safe", whole([](const ScenarioRun& run) {
                 return run.result.most_unsafe_certified;
               }))
      .fixed("travelled",
             "travelled",
             "cells",
             1,
             [](const ScenarioRun& run) { return run.result.last().travelled; })
      .integer("ways", "ways", whole([](const ScenarioRun& run) { return run.result.ways; }))
      .integer("fallbacks", "ended by a route", whole([](const ScenarioRun& run) {
                 return run.result.controller_fallbacks;
               }))
      .fixed("controller_cells",
             "by the controller",
             "cells",
             1,
             [](const ScenarioRun& run) { return run.result.controller_cells; })
      .fixed("route_cells",
             "by routes",
             "cells",
             1,
             [](const ScenarioRun& run) { return run.result.route_cells; })
      .fixed("certificate", "certificate", "", 2, [](const ScenarioRun& run) {
        return run.result.last().certificate;
      });
  return columns.table("scenarios", "The scenarios of the thesis, by rules", runs);
}

Table baseline_table(const std::vector<BaselineRun>& runs) {
  ColumnsOf<BaselineRun> columns;
  columns.text("scenario", "scenario", &BaselineRun::scenario)
      .text("method", "method", &BaselineRun::method)
      .integer("seed", "seed", &BaselineRun::seed)
      .yes_or_no("reached", "reached", [](const BaselineRun& run) { return run.result.reached; })
      .integer("unsafe_visits",
               "steps onto unsafe cells",
               [](const BaselineRun& run) {
                 return static_cast<std::int64_t>(run.result.unsafe_visits);
               })
      .integer("samples",
               "measurements",
               [](const BaselineRun& run) { return static_cast<std::int64_t>(run.result.samples); })
      .integer("plans",
               "plans",
               [](const BaselineRun& run) { return static_cast<std::int64_t>(run.result.plans); })
      .fixed(
          "length", "length", "cells", 1, [](const BaselineRun& run) { return run.result.length; });
  return columns.table("baselines", "What the method is compared with", runs);
}

}  // namespace

FitReport terrain_soundness_report(const std::vector<TerrainRates>& told,
                                   const std::vector<TerrainRates>& trusted,
                                   std::uint64_t seed) {
  FitReport report = study_report("terrain", seed);
  report.summary = study_summary({{"seed", seed}});
  report.tables = {told_table(told), trust_table(trusted)};
  return report;
}

FitReport scenario_report(const std::vector<ScenarioRun>& runs,
                          const std::vector<BaselineRun>& baselines,
                          const std::optional<SyntheticLabel>& label) {
  FitReport report;
  report.model = "terrain";
  report.synthetic = label;
  report.summary = study_summary({{"runs", runs.size()}});
  report.tables = {scenario_table(runs), baseline_table(baselines)};
  return report;
}

FitReport price_report(const std::vector<PriceRow>& rows, std::uint64_t seed) {
  const auto count = [](std::size_t terrain::study::Prices::*member) {
    return [member](const PriceRow& row) { return static_cast<std::int64_t>(row.found.*member); };
  };
  const auto median = [](std::vector<double> terrain::study::Prices::*member) {
    return [member](const PriceRow& row) {
      std::vector<double> values = row.found.*member;
      return statistics::quantile_in_place(values, 0.5);
    };
  };
  using terrain::study::Prices;
  const auto is_certified = [](const PriceRow& row) {
    return row.cell.method.rules == terrain::RuleSet::certified;
  };
  ColumnsOf<PriceRow> columns;
  columns.text("ground", "ground", [](const PriceRow& row) { return row.cell.ground.name; })
      .text("method", "method", [](const PriceRow& row) { return row.cell.method.name; })
      .integer("terrains", "terrains", count(&Prices::terrains))
      .integer("unsafe", "with unsafe cells held safe", count(&Prices::unsafe_cells))
      .integer("visits", "with a step onto one", count(&Prices::unsafe_visits))
      .integer("covered",
               "L covered at all times",
               [=](const PriceRow& row) {
                 return when(is_certified(row), static_cast<std::int64_t>(row.found.covered));
               })
      .integer("reachable", "goal reachable", count(&Prices::reachable))
      .integer("reached", "goal reached", count(&Prices::reached))
      .fixed("samples", "median measurements", "", 1, median(&Prices::samples))
      .fixed("way", "median way", "cells", 1, median(&Prices::ways))
      .fixed("last_ratio", "median last L, of the true", "", 2, [=](const PriceRow& row) {
        const auto ratio = median(&Prices::last_ratios)(row);
        return is_certified(row) ? ratio : std::nullopt;
      });
  FitReport report = study_report("price", seed);
  report.summary = study_summary({{"seed", seed}});
  report.tables = {columns.table("price", "The price of not knowing the Lipschitz constant", rows)};
  report.tables.back().footnotes = {
      "Random terrains of 60 x 48 cells, length scale 8, threshold at their mean; craters of 90 x "
      "60 "
      "cells, safe below 25 degrees. Medians are of the terrains whose goal was reached."};
  return report;
}

}  // namespace tcert
