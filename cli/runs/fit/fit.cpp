#include "cli/fit/fit.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <statistics/basics/condition_groups.hpp>
#include <table/csv_write.hpp>

#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/fit/kind_options.hpp"
#include "cli/fit/outcome_words.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "cli/time_rounding_option.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Fit a model to any CSV table, with R's formulas and R's numbers.

KIND is one of
  glm          logistic regression           success ~ x1 + lighting, cbind(k, n - k) ~ x
  glmm         logistic mixed model          success ~ x1 + (1 | day), (1 + x1 | day), (1 | day/run)
  calibration  agreement of probabilities    success ~ x1 + lighting: fitted out of fold
  cox          proportional hazards          Surv(time, success) ~ x1 + strata(algorithm)
  km           Kaplan-Meier and log-rank     Surv(time, success) ~ lighting
  roc          AUC and ROC curve             success ~ x1 + x2: larger values speak for 1
  concordance  Harrell's C                   Surv(time, success) ~ x1: larger values, longer times

Formulas take a + b, a:b, a*b, I(x^2), log(x), scale(x), factor(d), offset(o), Surv(time, event),
Surv(start, stop, event), cbind(k, n - k), status == 2, strata(s), cluster(c), and for glmm
(1 | g), (1 + x | g), (1 + x || g), (1 | a/b). Factors are coded
against their first level in byte order; --ref changes it. Rows with a missing value are left out
and counted. offset() is for glm and cox; strata() for cox, for the pairs of concordance, and for km,
where it stratifies the log-rank test, or without other terms gives a curve a stratum.

A missing cell is empty, NA or nan. TRUE, True, true, T and their opposites are truth values. An outcome
of texts is 1 where it says success, s, ok, pass, yes or true, 0 where it says the opposite; any other two
texts are coded in byte order: write outcome == "text" for the one that counts as 1. A word for a missing
cell (N/A, null, -) among them is refused, also in such a comparison. In cox, + 0 and - 1 change nothing, as in coxph, and x * strata(g) gives an effect of x a stratum. Times that differ by
rounding are one time; --no-time-rounding keeps them apart. Stamps stay as far apart as they are; one
among durations is named.
For competing causes the status is 1 for every cause, and --cause names the column that tells them
apart: Surv(time_s, ended) ~ 1 with --cause end_reason; time_s > 0 if every row ends.

Text shows the main tables; json has every number at full precision, the conditions met and how the
fit ended, named as broom names them; csv has the main table, or that of --table.

Intervals of coefficients: conf.low and conf.high are always Wald's, estimate -+ z SE; profile.low and
profile.high are the profile likelihood's (broom's conf.low of a glm, R's confint), and profile.open
says of which end there is none. With --cluster t.low, t.high and t.p.value take Student's t with
clusters - 1 degrees of freedom. Each has its twin on the ratio's scale: odds.ratio.low,
odds.ratio.profile.low, hazard.ratio.t.high. glm makes profiles up to a second or two of work;
beyond, --profile asks for them.

Usage: tcert fit KIND --data FILE --formula FORMULA [options]

Example:
  tcert fit glm --data features.csv --formula 'success ~ tc_early + lighting' --cluster day
  tcert fit glm --data features.csv --formula 'success ~ tc_early + lighting' --firth
  tcert fit glmm --data features.csv --formula 'success ~ tc_early + (1 | day)' --profile --drop1
  tcert fit cox --data features.csv --formula 'Surv(time_s, success) ~ tc_early + strata(algorithm)'
  tcert fit calibration --data features.csv --formula 'success ~ tc_early' --cluster day
  tcert fit km --data features.csv --formula 'Surv(time_s, success) ~ lighting' --times 60,120
  tcert fit km --data features.csv --formula 'Surv(time_s, time_s > 0) ~ 1' --cause end_reason
  tcert fit roc --data features.csv --formula 'success ~ tc_early + I(-dwell)' --cluster day
  tcert fit concordance --data features.csv --formula 'Surv(time_s, success) ~ tc_early' --reverse

--table takes:
@TABLES@
Ends with 0 if there is an estimate, of one coefficient at least, with 65 if the data do not allow
any; what was met is said on stderr and in the result.

Cost: a pass over the table and a few over its rows; a million rows take seconds.
)";

using Fit = FitReport (*)(const FitRequest&);

struct Kind {
  std::string_view name;
  Fit fit;
  statistics::RightSide right_side;
  bool allow_infinite;  ///< Only ranks count.
  bool has_coefficients;
};

constexpr std::array<Kind, 7> kKinds{
    {{"glm", fit_glm, statistics::RightSide::design, false, true},
     {"glmm", fit_mixed_model, statistics::RightSide::design, false, true},
     {"calibration", fit_calibration, statistics::RightSide::design, false, false},
     {"cox", fit_cox_model, statistics::RightSide::design, false, true},
     {"km", fit_km, statistics::RightSide::groups, false, false},
     {"roc", fit_roc, statistics::RightSide::design, true, false},
     {"concordance", fit_concordance, statistics::RightSide::design, true, false}}};

CommandLine command_line(FitOptions& o, std::string_view help) {
  CommandLine line{
      "fit",
      help,
      uses_config | uses_output | uses_format | uses_seed | uses_threads | uses_decimal_comma,
      po::options_description("Options"),
      {{"KIND", &o.kind}}};
  auto add = line.own.add_options();
  const auto text = [](std::string& value, const char* name) {
    return po::value(&value)->value_name(name);
  };
  add("data", input(o.data, "FILE"), "a CSV table, one row a trial; .gz and .zst are expanded");
  add("formula", text(o.formula, "F"), "outcome ~ terms, quoted for the shell");
  add("cluster",
      text(o.cluster, "COLUMN"),
      "rows of one value are not independent: robust variances");
  add("strata", text(o.strata, "COLUMN"), "as strata() in the formula");
  add("weights", text(o.weights, "COLUMN"), "case weights");
  add("ref",
      po::value(&o.references)->composing()->value_name("COLUMN=LEVEL"),
      "the level that the others are compared with, repeatable");
  add("level",
      po::value(&o.level)->value_name("P")->default_value(o.level, "0.95"),
      "of the intervals");
  add("table", text(o.table, "NAME"), "print only this table; a wrong name lists them");
  add("ties",
      text(o.ties, "WORD")->default_value(o.ties),
      "cox: efron, breslow or exact; exact for few distinct times");
  add("robust", po::bool_switch(&o.robust), "glm, cox: sandwich variance, without clusters too");
  add("transform",
      text(o.transform, "WORD")->default_value(o.transform),
      "cox: time scale of the test of proportional hazards: km, rank, identity or log");
  add("residuals",
      text(o.residuals, "WORDS"),
      "cox: martingale, deviance, score, dfbeta, dfbetas, schoenfeld, scaledsch; comma "
      "between; in json, or by --table");
  add("curves",
      text(o.curves, "ROWS"),
      "cox: predicted survival of these rows of the table, counted from 1, comma between; "
      "in json, or by --table curves");
  add_time_rounding_option(line.own, o.no_time_rounding);
  add("no-profile", po::bool_switch(&o.no_profile), "glm: leave out the profile limits");
  add("firth",
      po::bool_switch(&o.firth),
      "glm: Firth's penalty: finite estimates under separation, less bias in small samples");
  add("folds",
      po::value(&o.folds)->value_name("K")->default_value(o.folds),
      "calibration: of the cross-validation, of whole clusters");
  add("predicted",
      text(o.predicted, "COLUMN"),
      "calibration: a column of given probabilities, with the formula 'outcome ~ COLUMN'");
  add("quadrature",
      po::value(&o.quadrature)->value_name("N"),
      "glmm: points per group, 1 (Laplace) to 100; 15 for a single random intercept, else 1");
  add("profile",
      po::bool_switch(&o.profile),
      "glmm: profile intervals too; glm: however long they take");
  add("drop1", po::bool_switch(&o.drop1), "glmm: likelihood-ratio test of each fixed term");
  add("interval",
      text(o.interval, "WORD")->default_value(o.interval),
      "km: log, log-log, plain, logit or arcsin");
  add("times",
      po::value<std::string>()->value_name("LIST")->notifier(
          [&o](const std::string& list) { o.times = numbers_of("times", list); }),
      "km: times at which the curves are shown, comma between");
  add("rho",
      po::value(&o.rho)->value_name("X")->default_value(o.rho),
      "km: weight S^rho of the log-rank test; 1 is Peto's");
  add("cause",
      text(o.cause, "COLUMN"),
      "km: a column that names the end of each row, where the status is 1 for every cause; gives "
      "cumulative incidences");
  add("pair-weight",
      text(o.pair_weight, "WORD")->default_value(o.pair_weight),
      "concordance: n, S, S/G, n/G2 or I, as survival's timewt");
  add("reverse", po::bool_switch(&o.reverse), "concordance: larger values go with shorter times");
  add("partial",
      text(o.partial, "AXIS:LOW:HIGH"),
      "roc: partial area, for instance specificity:0.9:1");
  add("bootstrap",
      po::value(&o.replicates)->value_name("R")->default_value(o.replicates),
      "roc, concordance: BCa intervals from R resamples of rows, or of clusters");
  return line;
}

const Kind& kind_of(const std::string& name) {
  std::vector<std::string> known;
  for (const Kind& kind : kKinds) {
    if (kind.name == name) {
      return kind;
    }
    known.emplace_back(kind.name);
  }
  throw UsageError("unknown kind '" + name +
                   "', expected glm, glmm, calibration, cox, km, roc or concordance" +
                   did_you_mean(name, known));
}

statistics::FrameOptions frame_options(const FitOptions& options, const Kind& kind) {
  statistics::FrameOptions frame;
  for (const std::string& text : options.references) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw UsageError("--ref: found '" + text + "', expected COLUMN=LEVEL");
    }
    frame.reference[text.substr(0, equals)] = text.substr(equals + 1);
  }
  frame.weights = options.weights;
  frame.cluster = options.cluster;
  frame.strata = options.strata;
  frame.right_side = kind.right_side;
  frame.allow_infinite = kind.allow_infinite;
  frame.round_times = !options.no_time_rounding;
  return frame;
}

/// The report of a frame that no model can be fitted to.
FitReport without_estimate(const FitOptions& options) {
  FitReport report;
  report.model = options.kind;
  report.summary.name = "summary";
  report.summary.title = "Fit";
  return report;
}

std::string plain_number(double value) {
  std::string text;
  table::append_number(text, value);
  return text;
}

void add_settings(const FitOptions& options,
                  const statistics::ModelFrame& frame,
                  FitReport& report) {
  report.settings = {{"formula", frame.formula},
                     {"data", name_of(options.data)},
                     {"response", frame.response},
                     {"n", std::to_string(frame.size())},
                     {"n_dropped", std::to_string(frame.dropped)},
                     {"level", plain_number(options.level)}};
}

void check(const FitOptions& options) {
  if (options.data.empty() || options.formula.empty()) {
    throw UsageError("needs --data FILE and --formula FORMULA");
  }
  if (!(options.level > 0.0 && options.level < 1.0)) {
    throw UsageError("--level: expected a value between 0 and 1");
  }
  require_range("folds", static_cast<double>(options.folds), 2, 1000);
  require_range("bootstrap", static_cast<double>(options.replicates), 0, 1e6);
}

std::vector<std::string> wanted_columns(const statistics::Formula& formula,
                                        const FitOptions& options,
                                        const Kind& kind) {
  std::vector<std::string> columns = statistics::columns_of(formula, frame_options(options, kind));
  if (!options.cause.empty()) {
    columns.push_back(options.cause);
  }
  return columns;
}

/// The term whose column this is, if it has several.
std::string factor_of(const statistics::ModelFrame& frame, const std::string& column) {
  const auto found = std::find(frame.columns.begin(), frame.columns.end(), column);
  if (found == frame.columns.end()) {
    return "";
  }
  const std::size_t term = frame.term_of[static_cast<std::size_t>(found - frame.columns.begin())];
  const bool several = term > 0 && std::count(frame.term_of.begin(), frame.term_of.end(), term) > 1;
  return several ? frame.terms[term - 1] : "";
}

FitReport report_of(const FitOptions& options, const Kind& kind, const DataFile& file) {
  const statistics::Formula formula = statistics::parse_formula(options.formula);
  const statistics::FrameOptions frame_option = frame_options(options, kind);
  statistics::ModelFrame frame = statistics::model_frame(formula, file.table, frame_option);
  FitReport report = statistics::has_error(frame.conditions)
                         ? without_estimate(options)
                         : kind.fit({options, formula, file.table, frame});
  for (const statistics::Condition& condition : frame.conditions) {
    const bool known = std::find(report.conditions.begin(), report.conditions.end(), condition) !=
                       report.conditions.end();
    if (!known) {
      report.conditions.push_back(condition);
    }
  }
  report.conditions = statistics::one_per_factor(
      report.conditions, [&](const std::string& column) { return factor_of(frame, column); });
  add_settings(options, frame, report);
  name_outcome(formula, frame, report);
  report.synthetic = file.synthetic;
  return report;
}

bool has_factor_of(const statistics::Expression& expression, const std::string& column) {
  const bool makes_factor =
      expression.is_call("factor") || expression.is_call("as.factor") || expression.is_call(":");
  return std::any_of(expression.arguments.begin(),
                     expression.arguments.end(),
                     [&](const statistics::Expression& argument) {
                       const bool is_column =
                           argument.kind == statistics::Expression::Kind::column &&
                           argument.name == column;
                       return (makes_factor && is_column) || has_factor_of(argument, column);
                     });
}

/// \throws UsageError for a reference level that no factor of the formula would take.
void require_references(const statistics::FrameOptions& frame,
                        const statistics::Formula& formula,
                        const table::DataTable& table) {
  const std::vector<std::string> used = formula.columns();
  for (const auto& [column, level] : frame.reference) {
    if (std::find(used.begin(), used.end(), column) == used.end()) {
      throw UsageError("--ref: the formula has no column '" + column + "'" +
                       did_you_mean(column, used));
    }
    const table::DataColumn* const data = table.find(column);
    bool is_factor = data == nullptr || data->is_text || data->is_truth;
    for (const statistics::Term& term : formula.terms) {
      for (const statistics::Expression& variable : term.variables) {
        is_factor =
            is_factor ||
            has_factor_of({statistics::Expression::Kind::call, 0.0, "I", {variable}}, column);
      }
    }
    if (!is_factor) {
      throw UsageError("--ref: column '" + column + "' holds numbers; write factor(" + column +
                       ") in the formula");
    }
  }
}

/// The help of one kind, or of all.
std::string help_of(std::string_view kind) {
  std::string text(kText);
  const std::string mark = "@TABLES@\n";
  return text.replace(text.find(mark), mark.size(), tables_in_words(kind) + '\n');
}

/// With --help the options of the kind that stands before it.
bool parse_fit(FitOptions& options, CommonOptions& common, Arguments arguments) {
  std::string_view kind;
  for (const Kind& one : kKinds) {
    if (!arguments.empty() && arguments.front() == one.name) {
      kind = one.name;
    }
  }
  const std::string help = help_of(kind);
  CommandLine line = command_line(options, help);
  const bool asks = std::find(arguments.begin(), arguments.end(), "--help") != arguments.end();
  if (asks && !kind.empty()) {
    const po::options_description own = options_of(kind, line.own);
    return parse({line.name, line.help, line.common, own, line.positional}, common, arguments);
  }
  return parse(line, common, arguments);
}

int run(Arguments arguments) {
  FitOptions options;
  CommonOptions common;
  if (!parse_fit(options, common, arguments)) {
    return exit_done;
  }
  options.seed = static_cast<std::uint64_t>(common.seed);
  options.quiet = common.quiet;
  const Kind& kind = kind_of(options.kind);
  check(options);
  const ThreadLimit threads(common.threads);
  try {
    const statistics::Formula formula = statistics::parse_formula(options.formula);
    require_taken(options.kind, common.given, formula);
    const DataFile file =
        read_data_file(options.data, wanted_columns(formula, options, kind), common);
    require_references(frame_options(options, kind), formula, file.table);
    const FitReport report = report_of(options, kind, file);
    for (const statistics::Condition& condition : report.conditions) {
      say("tcert fit: " + statistics::to_string(condition));
    }
    const bool is_table = options.table.empty() || report.find(options.table) != nullptr;
    if (statistics::has_error(report.conditions) && !is_table) {
      return exit_bad_data;  // what was asked for is missing because of the error
    }
    require_table(report, options.table);
    const std::string text = render(report, common.table_format(), options.table);
    write_or_print(text, "fit", file, common);
    if (statistics::has_error(report.conditions)) {
      return exit_bad_data;
    }
    if (!has_estimate(report)) {
      say(kind.has_coefficients ? "tcert fit: no coefficient has an estimate"
                                : "tcert fit: nothing has an estimate");
      return exit_bad_data;
    }
    return exit_done;
  } catch (const statistics::FormulaError& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

std::size_t choice(const std::string& option,
                   const std::string& word,
                   const std::vector<std::string>& words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) {
    return static_cast<std::size_t>(found - words.begin());
  }
  std::string known;
  for (const std::string& one : words) {
    known += (known.empty() ? "" : ", ") + one;
  }
  throw UsageError("--" + option + ": found '" + word + "', expected one of " + known);
}

const Command kFit = {
    "fit", "fit a model to any table: glm, glmm, calibration, cox, km, roc, concordance", run};

}  // namespace tcert::cli
