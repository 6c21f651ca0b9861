#include <statistics/model/cut_into.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <statistics/model/expression.hpp>

namespace tcert::statistics {
namespace {

/// As many intervals over the known numbers, the outer ones a thousandth wider.
std::vector<double> even_breaks(const std::vector<double>& known,
                                double count,
                                const std::string& text) {
  constexpr double kMost = 1000.0;
  if (count != std::floor(count) || count < 2.0 || count > kMost || known.empty()) {
    throw FormulaError("'" + text +
                       "': breaks are ends of intervals, or a number of them from 2 to 1000");
  }
  const auto [low, high] = std::minmax_element(known.begin(), known.end());
  const double width = *high - *low;
  std::vector<double> breaks;
  const auto intervals = static_cast<std::size_t>(count);
  for (std::size_t k = 0; k <= intervals; ++k) {
    breaks.push_back(*low + static_cast<double>(k) * width / count);
  }
  breaks.front() = *low - width / 1000.0;
  breaks.back() = *high + width / 1000.0;
  return breaks;
}

/// As few digits, from 3 on, as tell all breaks apart.
std::vector<std::string> break_texts(const std::vector<double>& breaks) {
  std::vector<std::string> texts;
  for (int digits = 3; digits <= 16; ++digits) {
    texts.clear();
    for (const double one : breaks) {
      texts.push_back(std::isinf(one) ? (one > 0.0 ? " Inf" : "-Inf")  // As formatC() has it.
                                      : fmt::format("{:.{}g}", one, digits));
    }
    if (std::set<std::string>(texts.begin(), texts.end()).size() == texts.size()) {
      break;
    }
  }
  return texts;
}

std::vector<std::string> interval_labels(const std::vector<double>& breaks,
                                         bool include_lowest,
                                         bool right) {
  const std::vector<std::string> ends = break_texts(breaks);
  std::vector<std::string> labels;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const bool closed_low = !right || (include_lowest && k == 0);
    const bool closed_high = right || (include_lowest && k + 2 == ends.size());
    labels.push_back((closed_low ? "[" : "(") + ends[k] + "," + ends[k + 1] +
                     (closed_high ? "]" : ")"));
  }
  return labels;
}

}  // namespace

table::Factor cut_into(const std::vector<double>& x,
                       const std::vector<double>& known,
                       std::vector<double> breaks,
                       const std::vector<std::string>& labels,
                       bool include_lowest,
                       bool right,
                       const std::string& text) {
  if (breaks.size() == 1) {
    breaks = even_breaks(known, breaks.front(), text);
  }
  std::sort(breaks.begin(), breaks.end());
  if (breaks.size() < 2 || std::adjacent_find(breaks.begin(), breaks.end()) != breaks.end()) {
    throw FormulaError("'" + text + "': needs two breaks or more that differ");
  }
  table::Factor factor;
  factor.levels = labels.empty() ? interval_labels(breaks, include_lowest, right) : labels;
  if (factor.levels.size() + 1 != breaks.size()) {
    throw FormulaError("'" + text + "': as many labels as intervals");
  }
  for (const double one : x) {
    std::uint32_t code = table::Factor::kMissing;
    if (!std::isnan(one)) {
      const auto next = right ? std::lower_bound(breaks.begin(), breaks.end(), one)
                              : std::upper_bound(breaks.begin(), breaks.end(), one);
      if (next != breaks.begin() && next != breaks.end()) {
        code = static_cast<std::uint32_t>(next - breaks.begin() - 1);
      } else if (include_lowest && one == (right ? breaks.front() : breaks.back())) {
        code = right ? 0U : static_cast<std::uint32_t>(breaks.size() - 2);
      }
    }
    factor.codes.push_back(code);
  }
  return factor;
}

}  // namespace tcert::statistics
