#include <string>

#include "reports/fit/cells.hpp"
#include "reports/h1_table.hpp"

namespace tcert {
namespace {

TableCell coefficient(const statistics::CalibrationCoefficient& one) {
  return estimate_cell(one.estimate, one.interval);
}

}  // namespace

Table h1_roc_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1_roc";
  table.title = "ROC curves";
  table.columns = {text_column("panel", "panel"),
                   text_column("predictor", "predictor"),
                   number_column("threshold", "threshold"),
                   fixed_column("sensitivity", "sensitivity"),
                   fixed_column("specificity", "specificity")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Roc& roc : panel.roc) {
      for (const statistics::RocPoint& point : roc.curve.points) {
        table.add_row({panel_name(h1, panel),
                       roc.name,
                       Number{point.threshold},
                       Number{point.sensitivity},
                       Number{point.specificity}});
      }
    }
  }
  table.footnotes = {
      "Sensitivity: share of successes called success. Models are scored on the trials of their "
      "fit."};
  return table;
}

Table h1_calibration_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1_calibration";
  table.title = "Out-of-fold calibration: trials of like predicted probability";
  table.columns = {text_column("panel", "panel"),
                   text_column("model", "model"),
                   integer_column("bin", "bin"),
                   integer_column("n", "n"),
                   integer_column("events", "successes"),
                   integer_column("clusters", "clusters"),
                   fixed_column("predicted", "predicted"),
                   estimate_column("observed", "observed")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Calibration& one : panel.calibration) {
      std::size_t number = 0;
      for (const statistics::CalibrationBin& bin : one.calibration.bins) {
        table.add_row({panel_name(h1, panel),
                       one.name,
                       integer_cell(++number),
                       integer_cell(bin.trials),
                       integer_cell(bin.events),
                       integer_cell(bin.clusters),
                       Number{bin.predicted},
                       estimate_cell(bin.observed, bin.wilson)});
      }
    }
  }
  table.footnotes = {
      "Folds of whole clusters. observed: Wilson's interval, which takes trials as independent; "
      "withheld where the others are."};
  return table;
}

Table h1_recalibration_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1_recalibration";
  table.title = "Out-of-fold calibration of success";
  table.columns = {text_column("panel", "panel"),
                   text_column("model", "model"),
                   integer_column("n", "n"),
                   integer_column("events", "successes"),
                   integer_column("clusters", "clusters"),
                   estimate_column("slope", "slope"),
                   estimate_column("intercept", "intercept"),
                   estimate_column("in_the_large", "in the large"),
                   fixed_column("brier", "Brier")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Calibration& one : panel.calibration) {
      const statistics::ModelCalibration& c = one.calibration;
      table.add_row({panel_name(h1, panel),
                     one.name,
                     integer_cell(c.rows),
                     integer_cell(c.events),
                     integer_cell(c.clusters),
                     coefficient(c.slope),
                     coefficient(c.intercept),
                     coefficient(c.in_the_large),
                     c.brier ? TableCell{Number{c.brier->score}} : TableCell{}});
    }
  }
  table.footnotes = {
      "logit Pr(success) = intercept + slope logit p, p predicted by a fit to the other folds, of "
      "whole clusters. Ideal: slope 1, intercept 0; in the large: the intercept where the slope is "
      "1. Cluster-robust Wald intervals."};
  return table;
}

}  // namespace tcert
