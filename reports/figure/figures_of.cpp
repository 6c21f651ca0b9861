#include "reports/figure/figures_of.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "datasets/bytes.hpp"
#include "datasets/path_name.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/figure/h1_figures.hpp"
#include "reports/figure/set_figures.hpp"

namespace tcert {
namespace {

/// Collects figures; what is empty is missing for the reason given.
class Collection {
 public:
  explicit Collection(const Results& results) : results_(results) {}

  void add(const char* name, std::optional<Figure> figure, const std::string& reason) {
    if (figure) {
      found_.figures.push_back(std::move(*figure));
    } else {
      found_.missing.push_back({name, reason});
    }
  }

  /// A table of the first result of a kind; empty if it is not there.
  [[nodiscard]] Table table(ResultKind kind, const char* name) const {
    const Result* const result = results_.find(kind);
    const std::optional<Table> found =
        result != nullptr ? result_table(*result, name) : std::nullopt;
    return found ? *found : Table{};
  }

  [[nodiscard]] StudyFigures figures() && { return std::move(found_); }

 private:
  const Results& results_;
  StudyFigures found_;
};

void add_cells(const Results& results, Collection& collection) {
  bool ablation = false;
  std::size_t sweeps = 0;
  for (const Result& result : results.all) {
    if (result.kind != ResultKind::ablation && result.kind != ResultKind::sweep) {
      continue;
    }
    const std::optional<Table> cells = result_table(result, "cells");
    if (!cells) {
      continue;
    }
    if (result.kind == ResultKind::ablation) {
      collection.add("ablation", cells_figure(*cells, "ablation", "Parts left out"), "no AUC");
      ablation = true;
    } else {
      ++sweeps;
      const std::string name =
          sweeps == 1 ? "specification_curve" : "specification_curve_" + std::to_string(sweeps);
      collection.add(name.c_str(),
                     cells_figure(*cells, name, "Specification curve: " + result.name),
                     "no AUC");
    }
  }
  if (!ablation) {
    collection.add("ablation", std::nullopt, "no result of 'tcert ablate'");
  }
  if (sweeps == 0) {
    collection.add("specification_curve", std::nullopt, "no result of 'tcert sweep'");
  }
}

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<World> world_of(const Results& results, const std::string& trial_id) {
  const Result* const corpus = results.find(ResultKind::corpus);
  if (corpus == nullptr) {
    return std::nullopt;
  }
  const auto path = corpus->folder / "worlds" / (trial_id + ".json");
  const BytesResult file = read_raw_file(path);
  if (!file.bytes) {
    return std::nullopt;
  }
  try {
    return world_from_json(file.bytes->view());
  } catch (const WorldFormatError& error) {
    throw MissingResult("'" + path.string() + "': " + error.what());
  }
}

}  // namespace

StudyFigures study_figures(const Results& results) {
  Collection all(results);
  const std::string no_h1 = "no result of 'tcert hypotheses h1'";
  all.add("roc", roc_figure(all.table(ResultKind::h1, "h1_roc")), no_h1);
  all.add("incidence", incidence_figure(all.table(ResultKind::h1, "h1_incidence_curve")), no_h1);
  all.add("calibration", calibration_figure(all.table(ResultKind::h1, "h1_calibration")), no_h1);
  all.add(
      "forest",
      forest_figure(all.table(ResultKind::h1, "h1_mixed"), all.table(ResultKind::h1, "h1_time")),
      no_h1);
  all.add("equivalence",
          equivalence_figure(all.table(ResultKind::h2, "h2_pairs"),
                             all.table(ResultKind::h2, "h2_equality")),
          "no result of 'tcert hypotheses h2'");
  all.add("pareto",
          pareto_figure(all.table(ResultKind::h3, "h3")),
          "no result of 'tcert hypotheses h3'");
  add_cells(results, all);
  all.add("gate",
          gate_figure(all.table(ResultKind::gate, "gate"),
                      all.table(ResultKind::gate, "gate_passes"),
                      all.table(ResultKind::gate, "gate_curve"),
                      all.table(ResultKind::gate, "gate_calibration")),
          "no result of 'tcert gate'");
  const Result* const certificates = results.find(ResultKind::certificates);
  const std::optional<DataTable> features =
      certificates != nullptr ? result_data(*certificates, "features.csv") : std::nullopt;
  const Table speed = all.table(ResultKind::certificates, "speed");
  for (const char* const grouped_by : {"algorithm", "lighting"}) {
    const std::string name = std::string("speed_by_") + grouped_by;
    all.add(name.c_str(),
            features ? speed_figure(speed, *features, grouped_by) : std::nullopt,
            "no result of 'tcert certify', or no such column");
  }
  all.add("truth",
          features ? truth_figure(*features, results.synthetic) : std::nullopt,
          "no columns truth_lower_m and truth_upper_m in features.csv: 'tcert certify --truth' "
          "writes them");
  return std::move(all).figures();
}

std::optional<TrialPicture> trial_picture(const Results& results, const std::string& trial_id) {
  const Result* const certificates = results.find(ResultKind::certificates);
  if (certificates == nullptr || !is_file_name(trial_id)) {
    return std::nullopt;
  }
  std::optional<DataTable> series = result_data(*certificates, "series/" + trial_id + ".csv");
  if (!series) {
    return std::nullopt;
  }
  TrialPicture picture;
  picture.trial_id = trial_id;
  picture.series = std::move(*series);
  picture.edges = result_data(*certificates, "edges/" + trial_id + ".csv");
  picture.synthetic = certificates->manifest.synthetic;
  picture.world = world_of(results, trial_id);
  if (const auto rows = result_data(*certificates, "certificates.csv")) {
    for (std::size_t row = 0; row < rows->rows; ++row) {
      if (text_at(*rows, row, "trial_id") == trial_id) {
        picture.bottleneck_x_m = finite(number_at(*rows, row, "bottleneck_x_m"));
        picture.bottleneck_y_m = finite(number_at(*rows, row, "bottleneck_y_m"));
        picture.issued_s = finite(number_at(*rows, row, "issued_s"));
      }
    }
  }
  return picture;
}

std::vector<std::string> typical_trials(const Results& results) {
  const Result* const certificates = results.find(ResultKind::certificates);
  const std::optional<DataTable> rows =
      certificates != nullptr ? result_data(*certificates, "certificates.csv") : std::nullopt;
  std::vector<std::string> chosen;
  if (!rows) {
    return chosen;
  }
  std::vector<std::pair<double, std::string>> issued;
  std::string failure;
  for (std::size_t row = 0; row < rows->rows; ++row) {
    const std::string id = text_at(*rows, row, "trial_id");
    if (number_at(*rows, row, "issued") == 1.0) {
      issued.emplace_back(number_at(*rows, row, "certificate_m"), id);
    }
    if (failure.empty() && number_at(*rows, row, "success") == 0.0) {
      failure = id;
    }
  }
  std::sort(issued.begin(), issued.end());
  if (!issued.empty()) {
    chosen.push_back(issued[issued.size() / 2].second);
    if (issued.size() > 2) {
      chosen.push_back(issued.front().second);
    }
  }
  if (!failure.empty()) {
    chosen.push_back(failure);
  }
  return chosen;
}

}  // namespace tcert
