#include "analysis/study/verdict.hpp"

#include <algorithm>
#include <utility>

namespace tcert::study {
namespace {

/// Where a gain could lie at least.
std::optional<double> reach_of(const H1Score& gain) {
  return gain.interval ? std::optional(gain.interval->low) : gain.value;
}

}  // namespace

std::string_view to_string(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::supported:
      return "supported";
    case Verdict::contradicted:
      return "contradicted";
    case Verdict::not_decided:
      break;
  }
  return "not decided";
}

H1Verdict h1_verdict(const H1Panel& panel, const H1Score& (*gain)(const H1Row&)) {
  H1Verdict found;
  H1Verdict worst;  // Of the gains below 0, the one that is so most surely.
  std::size_t rivals = 0;
  std::size_t above = 0;
  for (const H1Row& row : panel.rows) {
    if (row.kind != H1RowKind::rival) {
      continue;
    }
    ++rivals;
    const H1Score& one = gain(row);
    const auto reach = reach_of(one);
    if (!reach) {
      continue;
    }
    if (found.gain == nullptr || *reach < *reach_of(*found.gain)) {
      found = {Verdict::not_decided, &row, &one};
    }
    above += one.interval && one.interval->low > 0.0 ? 1 : 0;
    const bool below = one.interval && one.interval->high < 0.0;
    if (below && (worst.gain == nullptr || one.interval->high < worst.gain->interval->high)) {
      worst = {Verdict::contradicted, &row, &one};
    }
  }
  if (worst.gain != nullptr) {
    return worst;
  }
  if (rivals > 0 && above == rivals) {
    found.verdict = Verdict::supported;
  }
  return found;
}

const statistics::EquivalencePair* deciding_pair(const H2Panel& panel, const H2Equality& equality) {
  const double margin = equality.tests.options.margin;
  const statistics::EquivalencePair* farthest = nullptr;
  // How far the interval lies outside of the margin; within it, how far it reaches.
  const auto key = [&](const statistics::EquivalencePair& pair) {
    const double outside = std::max(pair.interval.low, -pair.interval.high) - margin;
    return std::pair(std::max(outside, 0.0), pair.smallest_margin);
  };
  for (const statistics::EquivalencePair& pair : equality.tests.pairs) {
    const bool known =
        panel.levels[pair.first].withheld.empty() && panel.levels[pair.second].withheld.empty();
    if (known && (farthest == nullptr || key(pair) > key(*farthest))) {
      farthest = &pair;
    }
  }
  return farthest;
}

Verdict h2_verdict(const H2Panel& panel, const H2Equality& equality) {
  const double margin = equality.tests.options.margin;
  const statistics::EquivalencePair* const pair = deciding_pair(panel, equality);
  if (pair != nullptr && (pair->interval.low > margin || pair->interval.high < -margin)) {
    return Verdict::contradicted;
  }
  const bool has_variances =
      std::all_of(equality.tests.pairs.begin(),
                  equality.tests.pairs.end(),
                  [](const statistics::EquivalencePair& one) { return one.standard_error > 0.0; });
  return has_variances && equality.tests.equivalent.value_or(false) ? Verdict::supported
                                                                    : Verdict::not_decided;
}

Verdict h3_verdict(const H3Chosen& one, double loss_margin) {
  const auto& gain = one.gain.interval;
  const bool lost_too_many = one.lost_lower && *one.lost_lower >= loss_margin;
  if ((gain && gain->high < 0.0) || lost_too_many) {
    return Verdict::contradicted;
  }
  const bool keeps = one.lost_upper && *one.lost_upper < loss_margin;
  return gain && gain->low > 0.0 && keeps ? Verdict::supported : Verdict::not_decided;
}

}  // namespace tcert::study
