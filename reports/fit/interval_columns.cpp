#include "reports/fit/interval_columns.hpp"

#include <algorithm>
#include <cmath>

#include "reports/fit/cells.hpp"

namespace tcert {
namespace {

std::string open_words(const statistics::ProfileLimits& limits) {
  if (limits.open_low && limits.open_high) {
    return "no limits";
  }
  return limits.open_low ? "no lower limit" : limits.open_high ? "no upper limit" : "";
}

}  // namespace

RatioName odds_ratio_name() { return {"odds.ratio", "odds ratio", "OR"}; }

RatioName hazard_ratio_name() { return {"hazard.ratio", "hazard ratio", "HR"}; }

std::vector<Column> ratio_columns(const RatioName& ratio, const std::vector<std::string>& others) {
  std::vector<Column> columns{number_column(ratio.name, ratio.heading),
                              number_column(ratio.name + ".low", ratio.abbreviation + " low"),
                              number_column(ratio.name + ".high", ratio.abbreviation + " high")};
  for (const std::string& other : others) {
    for (const char* const end : {"low", "high"}) {
      columns.push_back(number_column(ratio.name + '.' + other + '.' + end,
                                      ratio.abbreviation + ' ' + other + ' ' + end));
    }
  }
  return columns;
}

TableCell ratio_cell(const std::optional<double>& log_ratio) {
  return number_cell(log_ratio ? std::optional(std::exp(*log_ratio)) : std::nullopt);
}

void append_ratios(const std::optional<statistics::Interval>& log_ratio,
                   std::vector<TableCell>& cells) {
  cells.push_back(ratio_cell(log_ratio ? std::optional(log_ratio->low) : std::nullopt));
  cells.push_back(ratio_cell(log_ratio ? std::optional(log_ratio->high) : std::nullopt));
}

std::vector<Column> profile_columns() {
  return {number_column("profile.low", "profile low"),
          number_column("profile.high", "profile high"),
          text_column("profile.open", "open end")};
}

void append_profile(const statistics::ProfileLimits& limits, std::vector<TableCell>& cells) {
  cells.push_back(number_cell(limits.low));
  cells.push_back(number_cell(limits.high));
  cells.emplace_back(open_words(limits));
}

statistics::ProfileLimits limits_of(const std::optional<statistics::Interval>& profile) {
  statistics::ProfileLimits limits;
  if (profile) {
    limits.low = profile->low;
    limits.high = profile->high;
  }
  return limits;
}

std::vector<Column> t_columns(bool with_p) {
  std::vector<Column> columns{number_column("t.low", "t low"), number_column("t.high", "t high")};
  if (with_p) {
    columns.insert(columns.begin(), p_column("t.p.value", "t p"));
  }
  return columns;
}

void append_t(const statistics::ClusterT& by_t, std::vector<TableCell>& cells, bool with_p) {
  if (with_p) {
    cells.push_back(p_cell(by_t.p_value));
  }
  cells.push_back(low_cell(by_t.interval));
  cells.push_back(high_cell(by_t.interval));
}

statistics::ClusterT clipped(statistics::ClusterT by_t) {
  if (by_t.interval) {
    by_t.interval->low = std::max(0.0, by_t.interval->low);
    by_t.interval->high = std::min(1.0, by_t.interval->high);
  }
  return by_t;
}

std::string t_footnote(std::size_t clusters) {
  if (clusters < 2) {
    return "t: nothing, for there is a single cluster.";
  }
  return "t: by Student's t with clusters - 1 = " + std::to_string(clusters - 1) +
         " degrees of freedom; the other intervals and p are by the normal distribution, as R has "
         "them.";
}

void point_to_t(statistics::Conditions& conditions) {
  for (statistics::Condition& condition : conditions) {
    if (condition.kind == statistics::ConditionKind::few_clusters && condition.advice.empty()) {
      condition.advice =
          condition.severity == statistics::ConditionSeverity::note
              ? "intervals by the normal distribution tend to be too narrow; those by t stand "
                "beside them"
              : "intervals and p by the normal distribution are not to be believed; read those by "
                "t, with care";
    }
  }
}

void append_columns(const std::vector<Column>& more, std::vector<Column>& columns) {
  columns.insert(columns.end(), more.begin(), more.end());
}

}  // namespace tcert
