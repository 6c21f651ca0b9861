#pragma once
/// \file
/// The rule sets under which ground is declared safe and the next sample is chosen.

#include <optional>
#include <string_view>

namespace tcert::terrain {

enum class RuleSet {
  thesis,     ///< Algorithm 1 as printed.
  published,  ///< What the published program does.
  certified,  ///< Ours: ground is certified by measurements and the Lipschitz constant alone.
  /// Ours: by the band of a Gaussian process with unknown mean, whose variance is bounded from
  /// above by FieldScale; without a Lipschitz constant. It believes that the terrain is such a
  /// field, of a length scale no shorter than that of the prior.
  band,
};

/// Which of the cells that could make the safe set grow is measured next.
enum class Selection {
  thesis,      ///< The widest interval of the n nearest to the goal.
  look_ahead,  ///< Where the ground is expected to reach nearest to the goal, the way counted.
  horizon,     ///< The same over a sequence of expected measurements.
  /// After PSANE: of the Pareto front of the probability that the safe set grows and the cost to
  /// the goal the best weighted sum.
  pareto,
};

[[nodiscard]] std::string_view to_string(RuleSet rules) noexcept;
[[nodiscard]] std::optional<RuleSet> rule_set_from(std::string_view word) noexcept;
[[nodiscard]] std::string_view to_string(Selection selection) noexcept;
[[nodiscard]] std::optional<Selection> selection_from(std::string_view word) noexcept;

/// Band of the model that may be trusted with certifying: 5 sd.
inline constexpr double kTrustedBeta = 25.0;

/// Of the model of `band`, as a share of the field's variance.
inline constexpr double kBandNugget = 1e-6;

/// Slopes this much above the Lipschitz constant, as a share of it, are rounding.
inline constexpr double kSlopeSlack = 1e-9;

struct Rules {
  RuleSet kind = RuleSet::certified;
  double threshold = 1000.0;  ///< h: ground is safe at f >= h.
  double lipschitz = 0.003;   ///< L > 0, per cell.
  double beta = 3.0;          ///< Band of the model: +-sqrt(beta) sd; `published`: +-beta sd.
  int expanders = 40;         ///< n: so many expanders nearest to the goal are considered. > 0.

  /// `thesis` only: Q_t on all cells instead of on S_t.
  bool model_everywhere = false;

  // `certified` only.
  double noise_bound = 0.0;  ///< Largest |y - f(x)| of a measurement, >= 0.
  /// The model's lower bound certifies too. Saves samples; no longer proven. Needs a wide band: of
  /// 300 random terrains unsafe cells were held safe in 145 at beta = 3, in 2 at kTrustedBeta.
  bool trust_model = false;
  // `certified` and `band`.
  Selection selection = Selection::thesis;
  double travel_weight = 0.1;  ///< Cells of the way that weigh one of gain, >= 0. Not of `thesis`.
  int horizon = 3;             ///< Measurements that `horizon` looks ahead, >= 1.
  double growth_weight = 0.5;  ///< Of the probability in `pareto`, 0 to 1; the rest is the cost's.

  /// `band`: of a measurement's Gaussian error, in the model.
  double noise_sd = 0.0;

  /// Half-width of the band in standard deviations.
  [[nodiscard]] double band() const noexcept;
};

/// \throws std::invalid_argument naming the first value that is not within its Limit.
void require_valid(const Rules& rules);

}  // namespace tcert::terrain
