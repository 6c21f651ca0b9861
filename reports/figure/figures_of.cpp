#include "reports/figure/figures_of.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <statistics/model/formula.hpp>
#include <table/bytes.hpp>
#include <table/path_name.hpp>
#include <utility>

#include "reports/figure/early_figures.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/figure/h1_figures.hpp"
#include "reports/figure/set_figures.hpp"

namespace tcert {
namespace {

/// Collects figures, and of those that are not drawn the reason.
class Collection {
 public:
  explicit Collection(const Results& results) : results_(results) {}

  /// `reason`: why there is nothing to draw it from; empty if there is.
  void add(const std::string& name, std::optional<Figure> figure, const std::string& reason) {
    if (figure) {
      found_.figures.push_back(std::move(*figure));
    } else {
      found_.missing.push_back({name, reason.empty() ? "no value of it is known" : reason});
    }
  }

  /// Why there is no figure of a kind of results; empty if the results have it.
  [[nodiscard]] std::string without(ResultKind kind, const char* command) const {
    return results_.find(kind) != nullptr ? std::string()
                                          : std::string("no result of 'tcert ") + command + "'";
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

/// Ablations or sweeps; the second of a kind has a 2 behind its name.
void add_cells(const Results& results,
               ResultKind kind,
               const std::string& name,
               const std::string& title,
               const char* command,
               Collection& collection) {
  int count = 0;
  for (const Result& result : results.all) {
    const std::optional<Table> cells =
        result.kind == kind ? result_table(result, "cells") : std::nullopt;
    if (!cells) {
      continue;
    }
    ++count;
    const std::string own = count == 1 ? name : name + "_" + std::to_string(count);
    const bool is_named = result.name != "." && result.name != to_string(kind);
    collection.add(
        own, cells_figure(*cells, own, is_named ? title + ": " + result.name : title), "");
  }
  if (count == 0) {
    collection.add(name, std::nullopt, std::string("no result of 'tcert ") + command + "'");
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
  const table::BytesResult file = table::read_raw_file(path);
  if (!file.bytes) {
    return std::nullopt;
  }
  try {
    return world_from_json(file.bytes->view());
  } catch (const WorldFormatError& error) {
    throw MissingResult("'" + path.string() + "': " + error.what());
  }
}

/// When the time window of the features closes; as H1 has it if the manifest does not say.
double landmark_of(const Result& certificates) {
  double landmark_s = study::H1Options().landmark_s;
  for (const auto& [key, value] : certificates.manifest.parameters) {
    if (key == "early_time_s") {
      std::from_chars(value.data(), value.data() + value.size(), landmark_s);
    }
  }
  return landmark_s;
}

/// Figures of TC_early and the outcome, from features.csv.
void add_early_figures(const Results& results,
                       const std::optional<table::DataTable>& features,
                       Collection& all) {
  using Draw =
      std::optional<Figure> (*)(const study::EarlyTrials&, const std::optional<SyntheticLabel>&);
  const std::array<std::pair<const char*, Draw>, 4> figures = {
      {{"success_by_quantile", success_by_quantile_figure},
       {"early_by_outcome", early_by_outcome_figure},
       {"operating_point", operating_point_figure},
       {"auc_by_day", auc_by_day_figure}}};
  std::string reason = "no result of 'tcert certify', or without its features.csv";
  std::optional<study::EarlyTrials> trials;
  if (features) {
    reason = "no trial whose outcome and TC_early are both known";
    try {
      trials = study::early_trials(*features, landmark_of(*results.find(ResultKind::certificates)));
    } catch (const statistics::FormulaError& problem) {
      reason = problem.what();
    }
  }
  for (const auto& [name, figure] : figures) {
    all.add(name,
            trials ? figure(*trials, results.synthetic) : std::nullopt,
            !trials ? reason
            : figure == auc_by_day_figure
                ? "it needs both outcomes, and a column day of 80 days at most in features.csv"
                : "it needs both outcomes, and values that differ");
  }
}

}  // namespace

StudyFigures study_figures(const Results& results) {
  Collection all(results);
  const Result* const certificates = results.find(ResultKind::certificates);
  const std::optional<table::DataTable> features =
      certificates != nullptr ? result_data(*certificates, "features.csv") : std::nullopt;
  add_early_figures(results, features, all);
  const std::string no_h1 = all.without(ResultKind::h1, "hypotheses h1");
  const std::vector<std::string> predictors =
      distinct(all.table(ResultKind::h1, "h1"), "predictor");
  all.add("roc", roc_figure(all.table(ResultKind::h1, "h1_roc")), no_h1);
  all.add("within_strata",
          within_figure(all.table(ResultKind::h1, "h1"),
                        all.table(ResultKind::h1, "h1_within"),
                        all.table(ResultKind::h1, "h1_time"),
                        all.table(ResultKind::h1, "h1_time_within")),
          no_h1);
  all.add(
      "left_out",
      left_out_figure(all.table(ResultKind::h1, "h1"), all.table(ResultKind::h1, "h1_left_out")),
      no_h1);
  all.add("incidence",
          incidence_figure(all.table(ResultKind::h1, "h1_incidence_curve"),
                           predictors.empty() ? "" : predictors.front()),
          no_h1);
  all.add("calibration", calibration_figure(all.table(ResultKind::h1, "h1_calibration")), no_h1);
  all.add(
      "forest",
      forest_figure(all.table(ResultKind::h1, "h1_mixed"), all.table(ResultKind::h1, "h1_time")),
      no_h1);
  all.add("equivalence",
          equivalence_figure(all.table(ResultKind::h2, "h2_pairs"),
                             all.table(ResultKind::h2, "h2_equality")),
          all.without(ResultKind::h2, "hypotheses h2"));
  all.add("pareto",
          pareto_figure(all.table(ResultKind::h3, "h3")),
          all.without(ResultKind::h3, "hypotheses h3"));
  add_cells(results, ResultKind::ablation, "ablation", "Parts left out", "ablate", all);
  add_cells(results, ResultKind::sweep, "specification_curve", "Specification curve", "sweep", all);
  all.add("gate",
          gate_figure(all.table(ResultKind::gate, "gate"),
                      all.table(ResultKind::gate, "gate_passes"),
                      all.table(ResultKind::gate, "gate_curve"),
                      all.table(ResultKind::gate, "gate_calibration")),
          all.without(ResultKind::gate, "gate"));
  all.add("rules",
          rules_figure(all.table(ResultKind::assurance, "monitors")),
          all.without(ResultKind::assurance, "assure monitor"));
  all.add("guards",
          guards_figure(all.table(ResultKind::guards, "guard_choices"),
                        all.table(ResultKind::guards, "guard_front"),
                        all.table(ResultKind::guards, "guard_folds")),
          all.without(ResultKind::guards, "calibrate guards"));
  const Table speed = all.table(ResultKind::certificates, "speed");
  for (const char* const grouped_by : {"algorithm", "lighting"}) {
    all.add(std::string("speed_by_") + grouped_by,
            features ? speed_figure(speed, *features, grouped_by) : std::nullopt,
            features ? std::string("no commanded speed by ") + grouped_by
                     : "no result of 'tcert certify', or without its features.csv");
  }
  const bool has_truth = features && features->find("truth_upper_m") != nullptr;
  all.add("truth",
          has_truth ? truth_figure(*features, results.synthetic) : std::nullopt,
          has_truth ? ""
                    : "no columns truth_lower_m and truth_upper_m in features.csv: 'tcert certify "
                      "--truth' writes them");
  return std::move(all).figures();
}

std::optional<TrialPicture> trial_picture(const Results& results, const std::string& trial_id) {
  const Result* const certificates = results.find(ResultKind::certificates);
  if (certificates == nullptr || !table::is_file_name(trial_id)) {
    return std::nullopt;
  }
  std::optional<table::DataTable> series =
      result_data(*certificates, "series/" + trial_id + ".csv");
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
  const std::optional<table::DataTable> rows =
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
