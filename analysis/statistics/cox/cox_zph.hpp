#pragma once
/// \file
/// The score test of proportional hazards, as R's `cox.zph` has it since survival 3.0: does adding
/// x g(t) to the model help? (Grambsch and Therneau 1994; exact information, not its average.)

#include <cstdint>
#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/cox/cox.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::statistics {

/// g(t).
enum class TimeTransform : std::uint8_t {
  km,    ///< 1 - Kaplan-Meier's estimate just before t, over all strata.
  rank,  ///< Mean rank of t among all rows' times.
  identity,
  log,
};

/// "km", "rank", "identity", "log".
[[nodiscard]] std::string_view to_string(TimeTransform transform) noexcept;

struct ProportionalityTest {
  std::string name;                   ///< A term or a column.
  std::optional<ChiSquareTest> test;  ///< Empty if no coefficient of it is finite, or the
                                      ///< information is singular.
};

struct ProportionalityTests {
  TimeTransform transform = TimeTransform::km;
  std::vector<ProportionalityTest> parts;  ///< All but those constant or collinear.
  std::optional<ChiSquareTest> global;     ///< Of all of them.
  Conditions conditions;  ///< not_proportional for each part, and without a column for the global
                          ///< test, with p below 0.05; singular_information for those whose
                          ///< information is singular; the fit's if it has no estimate.
};

/// `by_term`: one test a term, else one a column. \pre `fit` is the fit to `data`, without an
/// error, with Efron or Breslow ties. Constant and collinear columns are left out. One that runs to
/// infinity adds nothing to a statistic, and one to its degrees of freedom; one that has run away
/// is tested as any other; both as in R. O(n (log n + p^2)). \throws std::invalid_argument with
/// exact ties.
[[nodiscard]] ProportionalityTests cox_zph(const CoxData& data,
                                           const CoxFit& fit,
                                           TimeTransform transform = TimeTransform::km,
                                           bool by_term = true);

}  // namespace tcert::statistics
