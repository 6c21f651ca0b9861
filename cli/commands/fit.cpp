#include "cli/runs/fit/fit.hpp"

#include <algorithm>

#include "cli/commands/run_command.hpp"
#include "cli/runs/fit/kind_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kFitText =
    R"(Fit a model to any CSV table, with R's formulas and R's numbers.

KIND is one of
  glm          logistic regression           success ~ x1 + lighting, cbind(k, n - k) ~ x
  glmm         logistic mixed model          success ~ x1 + (1 | day), (1 + x1 | day), (1 | day/run)
  lmm          linear mixed model            log(time_s) ~ x1 + (1 | day): R2, Satterthwaite's t
  calibration  agreement of probabilities    success ~ x1 + lighting: fitted out of fold; with
                                             Surv() and --times of the risks of a Cox model
  cox          proportional hazards          Surv(time, success) ~ x1 + strata(algorithm)
  finegray     competing risks, Fine-Gray    Surv(time, ended) ~ x1 with --cause and --event
  km           Kaplan-Meier and log-rank     Surv(time, success) ~ lighting
  roc          AUC and ROC curve             success ~ x1 + x2: larger values speak for 1
  concordance  Harrell's C                   Surv(time, success) ~ x1: larger values, longer times

Formulas take a + b, a:b, a*b, I(x^2), log(x), scale(x), factor(d), offset(o), Surv(time, event),
Surv(start, stop, event), cbind(k, n - k), status == 2, strata(s), cluster(c), and for glmm
and lmm (1 | g), (1 + x | g), (1 + x || g), (1 | a/b). Factors are coded
against their first level in byte order; --ref changes it. Rows with a missing value are left out
and counted. offset() is for glm, glmm, lmm and cox; strata() for cox, for the pairs of concordance, and for km,
where it stratifies the log-rank test, or without other terms gives a curve a stratum.

A missing cell is empty, NA or nan. TRUE, True, true, T and their opposites are truth values. An outcome
of texts is 1 where it says success, s, ok, pass, yes or true, 0 where it says the opposite; any other two
texts are coded in byte order: write outcome == "text" for the one that counts as 1. A word for a missing
cell (N/A, null, -) among them is refused, also in such a comparison. In cox, + 0 and - 1 change nothing, as in coxph, and x * strata(g) gives an effect of x a stratum. Times that differ by
rounding are one time; --no-time-rounding keeps them apart. Stamps stay as far apart as they are; one
among durations is named.
For competing causes the status is 1 for every cause, and --cause names the column that tells them
apart: Surv(time_s, ended) ~ 1 with --cause end_reason; time_s > 0 if every row ends. km then gives
cumulative incidences and Gray's test of groups, finegray the effects on the incidence of --event,
with the cause-specific model beside them.

Text shows the main tables; json has every number at full precision, the conditions met and how the
fit ended, named as broom names them; csv has the main table, or that of --table.

Intervals of coefficients: conf.low and conf.high are always Wald's, estimate -+ z SE; profile.low and
profile.high are the profile likelihood's (broom's conf.low of a glm, R's confint), and profile.open
says of which end there is none. With --cluster t.low, t.high and t.p.value are made for few
clusters: of roc, concordance and calibration by Student's t with clusters - 1 degrees of freedom; of
glm and cox as --inference says, with t.std.error and t.df: jackknife leaves out whole clusters (CV3),
cr1 is the sandwich times G/(G - 1), both with clusters - 1 degrees of freedom, cr2 that of Bell and
McCaffrey with Satterthwaite's, wild a bootstrap of the clusters' scores. Each has its twin on the ratio's scale: odds.ratio.low,
odds.ratio.profile.low, hazard.ratio.t.high. glm makes profiles up to a second or two of work;
beyond, --profile asks for them.

--contrasts COLUMN compares all levels of a factor pair by pair, the first less the second: with Holm's p
and intervals for every pair at once beside those of a pair by itself, on the ratio's scale too; where the
factor is in a product, over the rows as they are.

--predict FILE gives probabilities (glm) or survival and risks (cox, at --times) for the rows of another
table, by the levels and means of the table of the fit. cox and calibration score risks at --times: AUC(t)
and Brier(t), weighted for censoring.

Usage: tcert fit KIND --data FILE --formula FORMULA [options]

Example:
  tcert fit glm --data features.csv --formula 'success ~ tc_early + lighting' --cluster day
  tcert fit glm --data features.csv --formula 'success ~ tc_early + lighting' --firth
  tcert fit glmm --data features.csv --formula 'success ~ tc_early + (1 | day)' --profile --drop1
  tcert fit lmm --data features.csv --formula 'log(ifelse(success, time_s, 0/0)) ~ tc_early + lighting + (1 | day)' --contrasts lighting
  tcert fit cox --data features.csv --formula 'Surv(time_s, success) ~ tc_early' --cluster day --left-out
  tcert fit cox --data features.csv --formula 'Surv(time_s, success) ~ tc_early + strata(algorithm)'
  tcert fit cox --data features.csv --formula 'Surv(time_s, success) ~ tc_early' --times 60 --predict new.csv
  tcert fit calibration --data features.csv --formula 'success ~ tc_early' --cluster day
  tcert fit calibration --data features.csv --formula 'Surv(time_s, success) ~ tc_early' --times 60,90
  tcert fit km --data features.csv --formula 'Surv(time_s, success) ~ lighting' --times 60,120
  tcert fit km --data features.csv --formula 'Surv(time_s, time_s > 0) ~ 1' --cause end_reason
  tcert fit km --data features.csv --formula 'Surv(time_s, success) ~ lighting' --rmst 120 --cluster day
  tcert fit finegray --data features.csv --formula 'Surv(time_s, time_s > 0) ~ tc_early' \\
    --cause end_reason --event goal --cluster day
  tcert fit roc --data features.csv --formula 'success ~ tc_early + I(-dwell)' --cluster day
  tcert fit concordance --data features.csv --formula 'Surv(time_s, success) ~ tc_early' --reverse

--table takes:
@TABLES@
Ends with 0 if there is an estimate, of one coefficient at least, with 65 if the data do not allow
any; what was met is said on stderr and in the result.

Cost: a pass over the table and a few over its rows; a million rows take seconds.
)";

/// The help of one kind, or of all.
std::string help_of(std::string_view kind) {
  std::string text(kFitText);
  const std::string mark = "@TABLES@\n";
  return text.replace(text.find(mark), mark.size(), tables_in_words(kind) + '\n');
}

/// With --help the options of the kind that stands before it.
bool prints_help_of_kind(Arguments arguments) {
  const std::vector<std::string> kinds = kind_names();
  if (arguments.empty() || std::ranges::find(kinds, arguments.front()) == kinds.end() ||
      std::ranges::find(arguments, "--help") == arguments.end()) {
    return false;
  }
  const std::string& kind = arguments.front();
  FitRequest request;
  OptionTable table = options_of(request);
  table.keep_own([&](const std::string& option) { return takes_option(kind, option); });
  table.set_heading("Options of '" + kind + "'");
  Manner manner;
  return !parse(help_of(kind), table, manner, arguments);
}

int run_fit(Arguments arguments) {
  return prints_help_of_kind(arguments) ? exit_done : run_command(help_of(""), arguments, fit);
}

std::vector<CommandForm> fit_forms() { return {form_for<FitRequest>(help_of(""))}; }

}  // namespace

const Command kFit = {
    "fit",
    "fit a model to any table: glm, glmm, lmm, calibration, cox, km, roc, concordance",
    run_fit,
    fit_forms};

}  // namespace tcert::cli
