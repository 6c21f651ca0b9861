#pragma once
/// \file
/// What may be said of a hypothesis: one written rule each, which reads intervals alone.

#include <cstdint>
#include <string_view>

#include "analysis/study/h2/hypothesis_h2.hpp"
#include "analysis/study/h3/hypothesis_h3.hpp"

namespace tcert::study {

enum class Verdict : std::uint8_t {
  supported,
  contradicted,
  not_decided,  ///< Also where intervals are withheld or are not there.
};

/// "supported", "contradicted", "not decided".
[[nodiscard]] std::string_view to_string(Verdict verdict) noexcept;

/// Gains over the rivals of a panel, by one of its scores.
struct H1Verdict {
  Verdict verdict = Verdict::not_decided;
  /// Contradicted: the one whose interval lies furthest below 0. Else the one whose gain's interval
  /// reaches lowest, or whose gain is least where there are no intervals. Null without a gain.
  const H1Row* rival = nullptr;
  const H1Score* gain = nullptr;  ///< Over it.
};

/// Supported if the interval of the gain over every single rival lies above 0, contradicted if that
/// over one lies below 0. `gain` gives a row's.
[[nodiscard]] H1Verdict h1_verdict(const H1Panel& panel, const H1Score& (*gain)(const H1Row&));

/// The pair whose interval lies furthest outside of the margin, or if none does reaches furthest;
/// null if a group of every pair has its intervals withheld.
[[nodiscard]] const statistics::EquivalencePair* deciding_pair(const H2Panel& panel,
                                                               const H2Equality& equality);

/// Supported if all pairs of groups are equivalent at the margin (two one-sided tests),
/// contradicted if the interval of one pair's difference lies outside of it. A pair with a group
/// whose intervals are withheld decides nothing, and without a variance nothing is equivalent.
[[nodiscard]] Verdict h2_verdict(const H2Panel& panel, const H2Equality& equality);

/// Supported if the interval of the gain lies above 0 and the bound of the loss is below the
/// margin; contradicted if the interval lies below 0, or the lower bound of the loss, one-sided at
/// the same level, is not below the margin.
[[nodiscard]] Verdict h3_verdict(const H3Chosen& one, double loss_margin);

}  // namespace tcert::study
