#include "cli/runs/fit/kind_options.hpp"

#include <algorithm>
#include <array>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"

namespace tcert::cli {
namespace {

struct KindTakes {
  std::string_view kind;
  std::string_view options;  ///< Beside those that every kind takes; blank between.
  bool offset = false;
  bool strata = false;
  std::string_view tables;
};

constexpr std::array kTakes{
    KindTakes{
        "glm",
        "cluster weights ref robust inference left-out predict contrasts profile no-profile firth",
        true,
        false,
        "summary, coefficients, drop1 (not with robust variances), left_out (with "
        "--left-out), predictions (with --predict), contrasts (with --contrasts), vcov"},
    KindTakes{"glmm",
              "weights ref quadrature profile drop1 contrasts",
              true,
              false,
              "summary, coefficients, random, drop1 (with --drop1), contrasts (with --contrasts), "
              "ran_vals, vcov"},
    KindTakes{"lmm",
              "weights ref ml contrasts",
              true,
              false,
              "summary, coefficients, random, contrasts (with --contrasts), ran_vals, vcov"},
    KindTakes{"calibration",
              "cluster strata ref folds predicted times no-time-rounding",
              true,
              true,
              "summary, calibration, bins, predictions; of Surv(): scores, calibration, bins"},
    KindTakes{"cox",
              "cluster strata weights ref ties robust inference left-out predict contrasts times "
              "transform "
              "residuals curves "
              "no-time-rounding",
              true,
              true,
              "summary, coefficients, zph, zph_columns, drop1 and anova (not with robust "
              "variances), left_out (with --left-out), predictions (with --predict), scores (with "
              "--times), contrasts (with --contrasts), "
              "vcov, model_vcov, basehaz, curves, the names of "
              "--residuals"},
    KindTakes{"finegray",
              "cluster strata ref ties inference left-out contrasts cause event no-time-rounding",
              true,
              true,
              "summary, coefficients, cause_specific, left_out (with --left-out), contrasts (with "
              "--contrasts), vcov, model_vcov"},
    KindTakes{
        "km",
        "cluster strata weights interval times rho rmst cause no-time-rounding",
        false,
        true,
        "summary, groups, times, curve, logrank, logrank_vcov, rmst (with --rmst), gray, incidence "
        "and incidence_curve (with --cause)"},
    KindTakes{"roc",
              "cluster ref partial bootstrap",
              false,
              false,
              "summary, auc, differences, thresholds, bootstrap, vcov, points"},
    KindTakes{"concordance",
              "cluster strata weights ref pair-weight reverse bootstrap no-time-rounding",
              false,
              true,
              "summary, concordance, differences, bootstrap, vcov"}};

const KindTakes* row_of(std::string_view kind) {
  const auto* const found = std::find_if(
      kTakes.begin(), kTakes.end(), [&](const KindTakes& one) { return one.kind == kind; });
  return found == kTakes.end() ? nullptr : found;
}

bool lists(const KindTakes& row, std::string_view option) {
  const std::string words = ' ' + std::string(row.options) + ' ';
  return words.find(' ' + std::string(option) + ' ') != std::string::npos;
}

/// "cox, km and concordance"; empty if no row is `taken`.
template <class Taken>
std::string kinds_where(const Taken& taken) {
  std::vector<std::string> kinds;
  for (const KindTakes& row : kTakes) {
    if (taken(row)) {
      kinds.emplace_back(row.kind);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    text += i == 0 ? "" : i + 1 == kinds.size() ? " and " : ", ";
    text += kinds[i];
  }
  return text;
}

[[noreturn]] void refuse(const std::string& what, const std::string& kinds) {
  throw UsageError(what + " is for " + kinds);
}

bool has_product_with_strata(const statistics::Formula& formula) {
  return std::any_of(formula.terms.begin(), formula.terms.end(), [](const statistics::Term& term) {
    return std::any_of(
        term.variables.begin(), term.variables.end(), [](const statistics::Expression& variable) {
          return variable.is_call("strata");
        });
  });
}

}  // namespace

bool takes_option(std::string_view kind, std::string_view option) {
  const KindTakes* const row = row_of(kind);
  const bool claimed = std::any_of(
      kTakes.begin(), kTakes.end(), [&](const KindTakes& one) { return lists(one, option); });
  return row == nullptr || !claimed || lists(*row, option);
}

void require_taken(const std::string& kind,
                   const std::vector<std::string>& given,
                   const statistics::Formula& formula) {
  for (const std::string& option : given) {
    if (!takes_option(kind, option)) {
      refuse("--" + option, kinds_where([&](const KindTakes& one) { return lists(one, option); }));
    }
  }
  const KindTakes* const row = row_of(kind);
  if (row == nullptr) {
    return;
  }
  if (kind != "glmm" && kind != "lmm" && !formula.random_terms.empty()) {
    throw UsageError(
        "'(... | " + statistics::to_string(formula.random_terms.front().group) + ")': 'fit " +
        kind +
        "' fits no random effects; they are fitted by 'fit glmm' and 'fit lmm'; for robust "
        "variances use --cluster");
  }
  if (!row->offset && !formula.offsets.empty()) {
    refuse("offset()", kinds_where([](const KindTakes& one) { return one.offset; }));
  }
  if (!row->strata && !formula.strata.empty()) {
    refuse("strata()", kinds_where([](const KindTakes& one) { return one.strata; }));
  }
  if (kind != "cox" && has_product_with_strata(formula)) {
    throw UsageError("'fit " + kind +
                     "': a product with strata() is for cox; here write + strata()");
  }
}

std::string tables_in_words(std::string_view kind) {
  std::string text;
  for (const KindTakes& row : kTakes) {
    if (kind.empty() || row.kind == kind) {
      text += "  " + std::string(row.kind) + ": " + std::string(row.tables) + '\n';
    }
  }
  return text;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  names.reserve(kTakes.size());
  for (const KindTakes& one : kTakes) {
    names.emplace_back(one.kind);
  }
  return names;
}

}  // namespace tcert::cli
