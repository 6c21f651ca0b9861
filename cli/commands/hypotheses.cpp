#include "cli/runs/hypotheses.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kHypothesesText =
    R"(Test a hypothesis of the paper on a bundle or on any table of trials.

h1: does the early certificate margin tell successes from failures, and fast trials from slow ones,
and better than contacts, dwell and bend variance do? AUC, C and hazard ratios of each, of the rivals
together and with the margin added, with bootstrap intervals and tests by whole clusters (days);
AUC and C also of pairs of trials of one algorithm and lighting alone (--within), which shows how much
of a gain is between groups. Twice: with the early window as the paper has it, and with the time window alone (landmark), from
which conclusions are to be drawn.

h2: is it as good in every lighting (or other --group)? AUC, C, odds and hazard ratios of each group,
whether they are equivalent at a margin (two one-sided tests of all pairs, clusters shared between
groups), the smallest margin that would do, the margin that had 80 % power, tests of difference and
interaction. Panels and clusters as in h1.

A table needs the columns of --success and of the predictors; others that are named must be there, and
those that are usual may be absent or empty. 'column:smaller' after --predictor or in
--baselines means that smaller values speak for success. Without --features' own landmark columns
(tc_landmark, ...) there is one panel, unless --landmark is given, which needs times.

Intervals are expanded percentiles of the bootstrap: with 22 days the paper's BCa covers less than it
says (--interval bca; the files hold both, and plain percentiles). With fewer than 6 clusters, or 10
outcomes of a class, p-values and intervals are withheld: NA; the estimates stand.

h3: does gating the speed by the margin recover the lead of the camera baseline without losing
successes? Every trial is replayed at each speed law and beta; rates of advance, gain, share of the
gap (the baseline's lead at one mix of lightings), successes lost and retained, stalls, the Pareto
front; by lighting. Verdicts are of one beta a law, chosen beforehand (--beta) or on other days than
it is judged on (--beta folds), and of all laws and lightings at once; losses by whole clusters, with
the number of trials that has 80 % power.

With --output DIR/ (it ends with /, or is a folder): every table as CSV, JSON, text, Markdown and
LaTeX, the curves behind the figures as CSV and JSON, report.json, manifest.json. Another PATH, though it
had no ending, is one file of what would be printed, in --format.
text and md have the main tables, json every number; csv has the first table, or that of --table: h1, h1_within,
h1_time, h1_time_within, h1_mixed, h1_log_time, h1_intervals, h1_case_level, h1_incidence, h1_incidence_curve, h1_roc,
h1_calibration, h1_recalibration, h1_closed_form, h1_within_closed_form, h1_folds; h2, h2_within,
h2_equality, h2_pairs, h2_interaction, h2_intervals, h2_closed_form, h2_covariance; h3, h3_chosen,
h3_baseline, h3_intervals.

Usage: tcert hypotheses (h1 | h2) (BUNDLE | --features FILE) [options]
       tcert hypotheses h3 (BUNDLE | --replays FILE) [options]

Example:
  tcert hypotheses h1 corpus
  tcert hypotheses h1 --features results/features.csv --format md --output tables/h1.md
  tcert hypotheses h1 --features barn.csv --predictor m1 --baselines m2,m3:smaller --cluster world \
    --strata planner --time time_s
  tcert hypotheses h1 --features runs.csv --success 'status=goal,done' --predictor margin_m --strata ''
  tcert hypotheses h2 corpus --margin 0.05 --output h2/
  tcert hypotheses h2 --features barn.csv --predictor m1 --group planner --cluster world --strata ''
  tcert hypotheses h3 corpus --betas 5,10,20 --beta folds

Cost: that of 'tcert certify' for a bundle; some seconds per 1,000 trials and 2,000 resamples.
)";

int run_hypotheses(Arguments arguments) {
  return run_command(kHypothesesText, arguments, hypotheses);
}

std::vector<CommandForm> hypotheses_forms() {
  return {form_for<HypothesesRequest>(kHypothesesText)};
}

}  // namespace

const Command kHypotheses = {
    "hypotheses", "test a hypothesis of the paper: h1, h2, h3", run_hypotheses, hypotheses_forms};

}  // namespace tcert::cli
