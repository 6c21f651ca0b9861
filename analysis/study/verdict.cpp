#include "analysis/study/verdict.hpp"

#include <algorithm>

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
  std::size_t rivals = 0;
  std::size_t above = 0;
  bool below = false;
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
      found.rival = &row;
      found.gain = &one;
    }
    above += one.interval && one.interval->low > 0.0 ? 1 : 0;
    below = below || (one.interval && one.interval->high < 0.0);
  }
  if (below) {
    found.verdict = Verdict::contradicted;
  } else if (rivals > 0 && above == rivals) {
    found.verdict = Verdict::supported;
  }
  return found;
}

Verdict h2_verdict(const H2Panel& panel, const H2Equality& equality) {
  const auto known = [&](std::size_t group) { return panel.levels[group].withheld.empty(); };
  const double margin = equality.tests.options.margin;
  const bool outside =
      std::any_of(equality.tests.pairs.begin(),
                  equality.tests.pairs.end(),
                  [&](const statistics::EquivalencePair& pair) {
                    return known(pair.first) && known(pair.second) &&
                           (pair.interval.low > margin || pair.interval.high < -margin);
                  });
  if (outside) {
    return Verdict::contradicted;
  }
  return equality.tests.equivalent.value_or(false) ? Verdict::supported : Verdict::not_decided;
}

Verdict h3_verdict(const H3Case& one, double loss_margin) {
  const auto& gain = one.gain.interval;
  const bool lost_too_many = one.lost_lower && *one.lost_lower >= loss_margin;
  if ((gain && gain->high < 0.0) || lost_too_many) {
    return Verdict::contradicted;
  }
  return gain && gain->low > 0.0 && one.non_inferior.value_or(false) ? Verdict::supported
                                                                     : Verdict::not_decided;
}

}  // namespace tcert::study
