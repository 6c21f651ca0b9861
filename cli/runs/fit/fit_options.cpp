#include <statistics/glmm/glmm.hpp>

#include "cli/runs/fit/fit.hpp"
#include "cli/runs/fit/kind_options.hpp"
#include "cli/runs/time_rounding_option.hpp"

namespace tcert::cli {

OptionTable options_of(FitRequest& request) {
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, kind_names()});
  table.add_input(
      "data", request.data, "FILE", "a CSV table, one row a trial; .gz and .zst are expanded");
  table.add("formula", request.formula, "F", "outcome ~ terms, quoted for the shell");
  table.add("cluster",
            request.cluster,
            "COLUMN",
            "rows of one value are not independent: robust variances");
  table.add("strata", request.strata, "COLUMN", "as strata() in the formula");
  table.add("weights", request.weights, "COLUMN", "case weights");
  table.add("ref",
            request.references,
            "COLUMN=LEVEL",
            "the level that the others are compared with, repeatable");
  table.add("level", request.level, "P", "of the intervals");
  table.add("table", request.table, "NAME", "print only this table; a wrong name lists them");
  table.add(
      "ties", request.ties, "WORD", "cox: efron, breslow or exact; exact for few distinct times");
  table.add("robust", request.robust, "glm, cox: sandwich variance, without clusters too");
  table.add("transform",
            request.transform,
            "WORD",
            "cox: time scale of the test of proportional hazards: km, rank, identity or log");
  table.add("residuals",
            request.residuals,
            "WORDS",
            "cox: martingale, deviance, score, dfbeta, dfbetas, schoenfeld, scaledsch; comma "
            "between; in json, or by --table");
  table.add("curves",
            request.curves,
            "ROWS",
            "cox: predicted survival of these rows of the table, counted from 1, comma between; "
            "in json, or by --table curves");
  add_time_rounding_option(table, request.no_time_rounding);
  table.add_input("predict",
                  request.predict,
                  "FILE",
                  "glm, cox: predictions for the rows of this table; cox at --times");
  table.add(
      "inference",
      request.inference,
      "WORD",
      "glm, cox with clusters: jackknife, cr1, cr2 or wild; jackknife up to 100 clusters, then "
      "cr1");
  table.add("left-out",
            request.left_out,
            "glm, cox with clusters: a table of the coefficients without each cluster in turn");
  table.add("contrasts",
            request.contrasts,
            "COLUMN",
            "glm, glmm, lmm, cox, finegray: all pairs of the column's levels, with Holm's p");
  table.add("no-profile", request.no_profile, "glm: leave out the profile limits");
  table.add("firth",
            request.firth,
            "glm: Firth's penalty: finite estimates under separation, less bias in small samples");
  table.add("folds", request.folds, "K", "calibration: of the cross-validation, of whole clusters")
      .within(2, 1000);
  table.add("predicted",
            request.predicted,
            "COLUMN",
            "calibration: a column of given probabilities, with the formula 'outcome ~ COLUMN'");
  table
      .add("quadrature",
           request.quadrature,
           "N",
           "glmm: points per group, 1 (Laplace) to 100; 15 for a single random intercept, else 1")
      .within(1, statistics::kMostQuadrature);
  table.add("profile", request.profile, "glmm: profile intervals too; glm: however long they take");
  table.add("drop1", request.drop1, "glmm: likelihood-ratio test of each fixed term");
  table.add("ml", request.ml, "lmm: maximum likelihood in the place of the restricted one");
  table.add("interval", request.interval, "WORD", "km: log, log-log, plain, logit or arcsin");
  table.add(
      "times",
      request.times,
      "LIST",
      "km: times at which the curves are shown; cox, calibration: at which risks are predicted and "
      "scored; comma between");
  table.add("rho", request.rho, "X", "km: weight S^rho of the log-rank test; 1 is Peto's");
  table.add("rmst",
            request.rmst,
            "T",
            "km: mean times within [0, T] and their differences between groups");
  table.add("cause",
            request.cause,
            "COLUMN",
            "km, finegray: a column that names the end of each row, where the status is 1 for "
            "every cause; gives "
            "cumulative incidences");
  table.add(
      "event",
      request.event,
      "CAUSE",
      "finegray: the cause whose cumulative incidence is modelled; the others compete with it");
  table.add("pair-weight",
            request.pair_weight,
            "WORD",
            "concordance: n, S, S/G, n/G2 or I, as survival's timewt");
  table.add("reverse", request.reverse, "concordance: larger values go with shorter times");
  table.add("partial",
            request.partial,
            "AXIS:LOW:HIGH",
            "roc: partial area, for instance specificity:0.9:1");
  table
      .add("bootstrap",
           request.replicates,
           "R",
           "roc, concordance: BCa intervals from R resamples of rows, or of clusters")
      .within(0, 1e6);
  add_common(table, request);
  table.config_file();
  return table;
}

}  // namespace tcert::cli
