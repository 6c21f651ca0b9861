#include "reports/fit/contrast_table.hpp"

#include <cmath>

namespace tcert {
namespace {

std::optional<statistics::Interval> exp_of(const std::optional<statistics::Interval>& interval) {
  return interval ? std::optional(statistics::Interval{
                        std::exp(interval->low), std::exp(interval->high), interval->level})
                  : std::nullopt;
}

}  // namespace

Table contrast_table(const std::vector<statistics::PairContrast>& pairs,
                     const std::string& column,
                     const std::optional<RatioName>& ratio,
                     const std::string& by) {
  using Pair = statistics::PairContrast;
  ColumnsOf<Pair> columns;
  columns.text("first", "first", &Pair::first).text("second", "second", &Pair::second);
  if (ratio) {
    columns
        .number(ratio->name,
                ratio->abbreviation,
                [](auto& r) {
                  return r.estimate ? std::optional(std::exp(*r.estimate)) : std::nullopt;
                })
        .ends({ratio->name + ".low", ratio->abbreviation + " low"},
              {ratio->name + ".high", ratio->abbreviation + " high"},
              [](auto& r) { return exp_of(r.interval); });
  }
  columns.p("p.value", "p", &Pair::p_value)
      .p("adj.p.value", "Holm p", &Pair::holm)
      .number("df", "df", &Pair::df)
      .number("estimate", "difference", &Pair::estimate)
      .number("std.error", "SE", &Pair::standard_error)
      .number("statistic", "statistic", &Pair::statistic)
      .ends({"conf.low", "low"}, {"conf.high", "high"}, &Pair::interval)
      .ends(
          {"simultaneous.low", "all low"}, {"simultaneous.high", "all high"}, &Pair::simultaneous);
  if (ratio) {
    columns.ends({ratio->name + ".simultaneous.low", ratio->abbreviation + " all low"},
                 {ratio->name + ".simultaneous.high", ratio->abbreviation + " all high"},
                 [](auto& r) { return exp_of(r.simultaneous); });
  }
  Table table = columns.table("contrasts", "Levels of " + column + ", all pairs", pairs);
  table.footnotes = {"The first level less the second" +
                         std::string(ratio ? ", as a ratio the first by the second" : "") +
                         ", all other columns as the rows have them. Holm: p of " +
                         std::to_string(pairs.size()) +
                         " pairs together. Low and high are of a pair by itself; 'all' hold for "
                         "every pair at once "
                         "(Bonferroni).",
                     by};
  return table;
}

}  // namespace tcert
