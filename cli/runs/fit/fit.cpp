#include "cli/runs/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <statistics/basics/condition_groups.hpp>
#include <table/csv_write.hpp>

#include "cli/runs/data_file.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "cli/runs/fit/kind_options.hpp"
#include "cli/runs/fit/outcome_words.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/thread_limit.hpp"

namespace tcert::cli {
namespace {

using Fit = FitReport (*)(const FitInput&);

struct Kind {
  std::string_view name;
  Fit fit;
  statistics::RightSide right_side;
  bool allow_infinite;  ///< Only ranks count.
  bool has_coefficients;
};

constexpr std::array<Kind, 9> kKinds{
    {{"glm", fit_glm, statistics::RightSide::design, false, true},
     {"glmm", fit_mixed_model, statistics::RightSide::design, false, true},
     {"lmm", fit_linear_mixed_model, statistics::RightSide::design, false, true},
     {"calibration", fit_calibration, statistics::RightSide::design, false, false},
     {"cox", fit_cox_model, statistics::RightSide::design, false, true},
     {"finegray", fit_fine_gray, statistics::RightSide::design, false, true},
     {"km", fit_km, statistics::RightSide::groups, false, false},
     {"roc", fit_roc, statistics::RightSide::design, true, false},
     {"concordance", fit_concordance, statistics::RightSide::design, true, false}}};

const Kind& kind_of(const std::string& name) {
  for (const Kind& kind : kKinds) {
    if (kind.name == name) {
      return kind;
    }
  }
  throw UsageError(
      "unknown kind '" + name +
      "', expected glm, glmm, lmm, calibration, cox, finegray, km, roc or concordance" +
      did_you_mean(name, kind_names()));
}

statistics::FrameOptions frame_options(const FitRequest& request, const Kind& kind) {
  statistics::FrameOptions frame;
  for (const std::string& text : request.references) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw UsageError("--ref: found '" + text + "', expected COLUMN=LEVEL");
    }
    frame.reference[text.substr(0, equals)] = text.substr(equals + 1);
  }
  frame.weights = request.weights;
  frame.cluster = request.cluster;
  frame.strata = request.strata;
  frame.right_side = kind.right_side;
  frame.allow_infinite = kind.allow_infinite;
  frame.round_times = !request.no_time_rounding;
  return frame;
}

/// The report of a frame that no model can be fitted to.
FitReport without_estimate(const FitRequest& request) {
  FitReport report;
  report.model = request.kind;
  report.summary.name = "summary";
  report.summary.title = "Fit";
  return report;
}

std::string plain_number(double value) {
  std::string text;
  table::append_number(text, value);
  return text;
}

void add_settings(const FitRequest& request,
                  const statistics::ModelFrame& frame,
                  FitReport& report) {
  report.settings = {{"formula", frame.formula},
                     {"data", name_of(request.data)},
                     {"response", frame.response},
                     {"n", std::to_string(frame.size())},
                     {"n_dropped", std::to_string(frame.dropped)},
                     {"level", plain_number(request.level)}};
}

void check(const FitRequest& request) {
  if (request.data.empty() || request.formula.empty()) {
    throw UsageError("needs --data FILE and --formula FORMULA");
  }
  if (!(request.level > 0.0 && request.level < 1.0)) {
    throw UsageError("--level: expected a value between 0 and 1");
  }
}

std::vector<std::string> wanted_columns(const statistics::Formula& formula,
                                        const FitRequest& request,
                                        const Kind& kind) {
  std::vector<std::string> columns = statistics::columns_of(formula, frame_options(request, kind));
  if (!request.cause.empty()) {
    columns.push_back(request.cause);
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

FitReport report_of(const FitRequest& request,
                    const Kind& kind,
                    const DataFile& file,
                    Progress& progress) {
  const statistics::Formula formula = statistics::parse_formula(request.formula);
  const statistics::FrameOptions frame_option = frame_options(request, kind);
  statistics::ModelFrame frame = statistics::model_frame(formula, file.table, frame_option);
  FitReport report = statistics::has_error(frame.conditions)
                         ? without_estimate(request)
                         : kind.fit({request, formula, file.table, frame, progress, frame_option});
  for (const statistics::Condition& condition : frame.conditions) {
    const bool known = std::find(report.conditions.begin(), report.conditions.end(), condition) !=
                       report.conditions.end();
    if (!known) {
      report.conditions.push_back(condition);
    }
  }
  report.conditions = statistics::one_per_factor(
      report.conditions, [&](const std::string& column) { return factor_of(frame, column); });
  add_settings(request, frame, report);
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

/// \throws UsageError unless the formula has the column as a factor.
void require_factor(const std::string& option,
                    const std::string& column,
                    const statistics::Formula& formula,
                    const table::DataTable& table) {
  const std::vector<std::string> used = formula.columns();
  if (std::find(used.begin(), used.end(), column) == used.end()) {
    throw UsageError("--" + option + ": the formula has no column '" + column + "'" +
                     did_you_mean(column, used));
  }
  const table::DataColumn* const data = table.find(column);
  bool is_factor = data == nullptr || data->is_text || data->is_truth;
  for (const statistics::Term& term : formula.terms) {
    for (const statistics::Expression& variable : term.variables) {
      is_factor = is_factor ||
                  has_factor_of({statistics::Expression::Kind::call, 0.0, "I", {variable}}, column);
    }
  }
  if (!is_factor) {
    throw UsageError(fmt::format(
        "--{0}: column '{1}' holds numbers; write factor({1}) in the formula", option, column));
  }
}

/// \throws UsageError for a reference level that no factor of the formula would take, and for
/// contrasts of what is no factor.
void require_factors(const FitRequest& request,
                     const Kind& kind,
                     const statistics::Formula& formula,
                     const table::DataTable& table) {
  for (const auto& [column, level] : frame_options(request, kind).reference) {
    require_factor("ref", column, formula, table);
  }
  if (!request.contrasts.empty()) {
    require_factor("contrasts", request.contrasts, formula, table);
    for (const statistics::Expression& strata : formula.strata) {
      std::vector<std::string> columns;
      statistics::collect_columns(strata, columns);
      if (std::find(columns.begin(), columns.end(), request.contrasts) != columns.end()) {
        throw UsageError("--contrasts: column '" + request.contrasts +
                         "' makes the strata, which have no ratio of hazards");
      }
    }
  }
}

}  // namespace

ExitCode fit(const FitRequest& request, Progress& progress) {
  const Kind& kind = kind_of(request.kind);
  check(request);
  if (!request.output.path.empty()) {
    require_apart(request.data, request.output.path);
  }
  const ThreadLimit limit(request.threads);
  try {
    const statistics::Formula formula = statistics::parse_formula(request.formula);
    require_taken(request.kind, request.given, formula);
    const DataFile file = read_data_file(
        request.data, wanted_columns(formula, request, kind), request.decimal_comma, progress);
    require_factors(request, kind, formula, file.table);
    const FitReport report = report_of(request, kind, file, progress);
    const bool is_read = shows_whole_report(request.output, request.table);
    for (const statistics::Condition& condition : report.conditions) {
      if (!is_read || condition.severity == statistics::ConditionSeverity::error) {
        progress.say("tcert fit: " + statistics::to_string(condition));
      }
    }
    const bool failed = statistics::has_error(report.conditions);
    if (failed && !request.table.empty() && report.find(request.table) == nullptr) {
      return exit_bad_data;  // what was asked for is missing because of the error
    }
    require_table(report, request.table);
    const bool is_file = !request.output.path.empty();
    const std::string text = render(report,
                                    request.output.table_format(),
                                    request.table,
                                    is_file ? 0 : width_of(request.output, progress));
    if (is_file) {
      write_with_manifest(request.output.path, text, manifest_of("fit", file, written(request)));
    } else {
      progress.show(text);
    }
    if (!failed && !has_estimate(report)) {
      progress.say(kind.has_coefficients ? "tcert fit: no coefficient has an estimate"
                                         : "tcert fit: nothing has an estimate");
    }
    return failed || !has_estimate(report) ? exit_bad_data : exit_done;
  } catch (const statistics::FormulaError& error) {
    throw UnfitData(error.what());
  }
}

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

}  // namespace tcert::cli
