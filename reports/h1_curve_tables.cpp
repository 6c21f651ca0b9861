#include <string>

#include "reports/h1_table.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

using statistics::ModelCalibration;

/// A part of a curve of a panel.
template <class Part>
struct Named : RowOf<Part> {
  std::string panel;
  std::string curve;
  std::size_t number = 0;  ///< Within its curve, from 1.
};

template <class Part>
ColumnsOf<Named<Part>> named_columns(const char* curve) {
  return ColumnsOf<Named<Part>>()
      .text("panel", "panel", &Named<Part>::panel)
      .text(curve, curve, &Named<Part>::curve);
}

}  // namespace

Table h1_roc_table(const study::H1Table& h1) {
  using RocRow = statistics::RocPoint;
  const auto columns = named_columns<RocRow>("predictor")
                           .number("threshold", "threshold", &RocRow::threshold)
                           .fixed("sensitivity", "sensitivity", &RocRow::sensitivity)
                           .fixed("specificity", "specificity", &RocRow::specificity);
  Table table = columns.table("h1_roc", "ROC curves");
  for (const auto& roc : rows_of(h1, &study::H1Panel::roc)) {
    for (const RocRow& point : roc->curve.points) {
      table.add_row(columns.row({{point}, roc.name, roc->name}));
    }
  }
  table.footnotes = {
      "Sensitivity: share of successes called success. Models are scored on the trials of their "
      "fit."};
  return table;
}

Table h1_calibration_table(const study::H1Table& h1) {
  using Bin = statistics::CalibrationBin;
  const auto columns = named_columns<Bin>("model")
                           .integer("bin", "bin", &Named<Bin>::number)
                           .integer("n", "n", &Bin::trials)
                           .integer("events", "successes", &Bin::events)
                           .integer("clusters", "clusters", &Bin::clusters)
                           .fixed("predicted", "predicted", &Bin::predicted)
                           .estimate("observed", "observed", [](auto& row) {
                             return Estimated(row.of.observed, row.of.wilson);
                           });
  Table table = columns.table("h1_calibration",
                              "Out-of-fold calibration: trials of like predicted probability");
  for (const auto& one : rows_of(h1, &study::H1Panel::calibration)) {
    std::size_t number = 0;
    for (const Bin& bin : one->calibration.bins) {
      table.add_row(columns.row({{bin}, one.name, one->name, ++number}));
    }
  }
  table.footnotes = {
      "Folds of whole clusters. observed: Wilson's interval, which takes trials as independent; "
      "withheld where the others are."};
  return table;
}

Table h1_recalibration_table(const study::H1Table& h1) {
  using Brier = statistics::BrierParts;
  const auto model = ColumnsOf<ModelCalibration>()
                         .integer("n", "n", &ModelCalibration::rows)
                         .integer("events", "successes", &ModelCalibration::events)
                         .integer("clusters", "clusters", &ModelCalibration::clusters)
                         .estimate("slope", "slope", &ModelCalibration::slope)
                         .estimate("intercept", "intercept", &ModelCalibration::intercept)
                         .estimate("in_the_large", "in the large", &ModelCalibration::in_the_large)
                         .part(ColumnsOf<Brier>().fixed("brier", "Brier", &Brier::score),
                               &ModelCalibration::brier);
  Table table = panel_columns<study::H1Calibration>()
                    .text("model", "model", &study::H1Calibration::name)
                    .part(model, [](auto& row) { return &row->calibration; })
                    .table("h1_recalibration",
                           "Out-of-fold calibration of success",
                           rows_of(h1, &study::H1Panel::calibration));
  table.footnotes = {
      "logit Pr(success) = intercept + slope logit p, p predicted by a fit to the other folds, of "
      "whole clusters. Ideal: slope 1, intercept 0; in the large: the intercept where the slope is "
      "1. Cluster-robust Wald intervals."};
  return table;
}

}  // namespace tcert
