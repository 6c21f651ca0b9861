#pragma once
/// \file
/// The three rule sets under which ground is declared safe and the next sample is chosen.

#include <optional>
#include <string_view>

namespace tcert::terrain {

enum class RuleSet {
  thesis,     ///< Algorithm 1 as printed.
  published,  ///< What the published program does.
  certified,  ///< Ours: ground is certified by measurements and the Lipschitz constant alone.
};

[[nodiscard]] std::string_view to_string(RuleSet rules) noexcept;
[[nodiscard]] std::optional<RuleSet> rule_set_from(std::string_view word) noexcept;

/// Band of the model that may be trusted with certifying: 5 sd.
inline constexpr double kTrustedBeta = 25.0;

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
  /// Choose the expander whose expected disc comes nearest to the goal, the way to it counted,
  /// instead of the widest of the n nearest.
  bool look_ahead = false;
  double travel_weight = 0.1;  ///< Of look_ahead: cells of the way that weigh one of gain, >= 0.

  /// Half-width of the band in standard deviations.
  [[nodiscard]] double band() const noexcept;
};

/// \throws std::invalid_argument naming the first value that is not within its Limit.
void require_valid(const Rules& rules);

}  // namespace tcert::terrain
