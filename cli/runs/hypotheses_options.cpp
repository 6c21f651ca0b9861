#include "cli/runs/hypotheses.hpp"
#include "cli/runs/time_rounding_option.hpp"

namespace tcert::cli {

OptionTable options_of(HypothesesRequest& request) {
  OptionTable table(request.given);
  table.argument({"a hypothesis: h1, h2 or h3",
                  &request.hypothesis,
                  true,
                  OptionRole::shapes,
                  {"h1", "h2", "h3"}});
  table.argument({"BUNDLE", &request.bundle, false, OptionRole::input});
  table.add_input("features", request.features, "FILE", "a table of trials instead of a bundle");
  table.add("predictor",
            request.predictor,
            "COLUMN",
            "the predictor under test; tc_early unless given; ':smaller' turns its direction");
  table.add("baselines",
            request.baselines,
            "COLUMNS",
            "its rivals, comma between; those of the paper unless predictors are given");
  table.add(
      "success",
      request.success,
      "COLUMN[=WORDS]",
      "outcome: 0 or 1, true or false, success or failure, ok or fail; status=goal,done names the "
      "words that count as success, and all others are failures");
  table.add("time",
            request.time,
            "COLUMN",
            "time to egress, or to the end of a failed trial; without it there is no C");
  table.add("cluster",
            request.cluster,
            "COLUMN",
            "trials that share a value are not independent; '' for none");
  table.add("strata", request.strata, "COLUMN", "of the stratified hazard ratio; '' for none");
  table.add(
      "within",
      request.within,
      "COLUMNS",
      "AUC and C of pairs of trials that agree in these, comma between; --strata and lighting "
      "unless given, where the table has them; '' for none");
  table.add("landmark",
            request.landmark,
            "S",
            "start of the landmark panel; the time window of the features unless given");
  table.add(
      "limit",
      request.limit,
      "S",
      "trial limit: failures stay at risk to it, longer trials are censored there; the longest "
      "time unless given");
  add_time_rounding_option(table, request.no_time_rounding);
  table.add("replicates", request.replicates, "R", "of the bootstrap; more for stable third digits")
      .within(1, 1e6);
  table.add("folds", request.folds, "K", "of the cross-validation, of whole clusters")
      .within(2, 1000);
  table.add(
      "interval",
      request.interval,
      "METHOD",
      "of the bootstrap: expanded (percentiles that make up for few clusters), percentile or bca; "
      "the files hold all three");
  table.add("level", request.level, "P", "of the intervals");
  table.add("group", request.group, "COLUMN", "h2: the groups that are compared");
  table.add("margin",
            request.margin,
            "M",
            "h2: differences of AUC or C below it do not matter; state it before looking");
  table
      .add("permutations",
           request.permutations,
           "R",
           "h2: of the groups' names, for the expected max - min")
      .within(1, 1e6);
  table.add("table", request.table, "NAME", "print only this table; a wrong name lists them");
  table.add_input(
      "replays", request.replays, "FILE", "h3: replay.csv of 'tcert replay' instead of a bundle");
  table.add("gated", request.gated, "NAME", "h3: the algorithm that is gated");
  table.add("lead", request.lead, "NAME", "h3: the algorithm whose lead is to be recovered");
  table.add("loss-margin", request.loss_margin, "P", "h3: share of trials that may be lost")
      .within(1e-9, 1.0 - 1e-9);
  table
      .add("true-loss",
           request.true_loss,
           "P",
           "h3: share lost in truth, for the number of trials that has 80 % power; a fifth of the "
           "margin")
      .within(0.0, 1.0 - 1e-9);
  table.add("beta",
            request.beta,
            "WORD",
            "h3: the beta in 1/m that each law is judged at, chosen before looking, or folds: on "
            "other days than it is judged on, by --folds of them");
  table.add(
      "driven",
      request.driven,
      "h3: arms that drove the same worlds, compared in pairs, beside the replay; for a bundle "
      "of 'tcert drive'");
  add_replay_law_options(table, request.laws);
  add_common(table, request);
  return table;
}

}  // namespace tcert::cli
