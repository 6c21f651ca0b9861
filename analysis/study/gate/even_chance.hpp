#pragma once
/// \file
/// The 50 % point -alpha / beta of Pr(success) = logistic(alpha + beta x), with sets that cover it.
/// The point and the slope are checked against R's `glm`, Fieller's set against `MASS::dose.p`'s
/// covariance by the algebra of Finney (1978).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <string_view>

namespace tcert::study {

/// The shape of a confidence set of a ratio.
enum class ConfidenceSetKind : std::uint8_t {
  unknown,     ///< There is none.
  bounded,     ///< [low, high].
  two_rays,    ///< Everything but (low, high): the slope is not told from 0.
  whole_line,  ///< Everything: nothing is known.
};

[[nodiscard]] std::string_view to_string(ConfidenceSetKind kind) noexcept;
constexpr ConfidenceSetKind row_last(ConfidenceSetKind /*any*/) noexcept {
  return ConfidenceSetKind::whole_line;
}

struct ConfidenceSet {
  ConfidenceSetKind kind = ConfidenceSetKind::unknown;
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] bool covers(double x) const noexcept;
};

struct EvenChanceOptions {
  double level = 0.95;
  std::size_t replicates = 1999;  ///< Of the bootstrap; 0 leaves it out.
  std::uint64_t seed = 1;
  std::uint32_t analysis = 0;  ///< Stream of the seed.
};

struct EvenChance {
  std::size_t rows = 0;
  std::size_t successes = 0;
  std::optional<double> intercept;
  std::optional<double> intercept_std_error;
  std::optional<double> slope;
  std::optional<double> slope_std_error;
  std::optional<double> covariance;  ///< Of intercept and slope.
  std::optional<double> slope_p;
  std::optional<statistics::Interval> slope_wald;
  std::optional<statistics::Interval> slope_profile;
  std::optional<double> point;  ///< -alpha / beta.
  ConfidenceSet fieller;        ///< (alpha + beta x)^2 <= z^2 Var: of a Wald test.
  ConfidenceSet profile;        ///< Of the likelihood-ratio test of logistic(beta (x - point)).
  /// Of rows: percentile and BCa. Not bounded if more replicates than the tail holds have no rising
  /// slope; separated replicates have no point and are left out.
  ConfidenceSet percentile;
  ConfidenceSet bca;
  std::size_t failed_replicates = 0;
  statistics::Conditions conditions;
};

/// Without a finite estimate (separation, one class, constant x) everything is empty but the
/// condition. \throws std::invalid_argument if the lengths differ, x is not finite or the level is
/// not in (0, 1). O(replicates rows).
[[nodiscard]] EvenChance even_chance(std::span<const double> x,
                                     std::span<const std::uint8_t> success,
                                     const EvenChanceOptions& options = {});

/// Fieller's set from an estimate and its covariance.
[[nodiscard]] ConfidenceSet fieller_set(double intercept,
                                        double slope,
                                        double intercept_variance,
                                        double covariance,
                                        double slope_variance,
                                        double level);

}  // namespace tcert::study
