#pragma once
/// \file
/// Who drives in an experiment: a policy, and what its speed is gated by.

#include <optional>
#include <string>
#include <string_view>
#include <tcert/policy.hpp>
#include <tcert/speed_law.hpp>
#include <vector>

namespace tcert::study {

/// A policy under a speed law, under guards or rules, with a risk field, or without its memory of
/// contacts (ablation A1).
struct Arm {
  std::string name;  ///< "M3", "M3+squash20", "M3+clip10+guards", "M3+A1"; of one bundle, unique.
  policies::PolicyKind policy = policies::PolicyKind::m3;
  std::optional<SpeedLaw> law;            ///< Gates the speed in the loop.
  bool guards = false;                    ///< They act: halts and retreats.
  bool monitor = false;                   ///< Rules are watched, and alarms back the robot out.
  std::optional<double> lambda_weight{};  ///< Of the risk field; else the parameter's.
  bool without_memory = false;
};

/// POLICY, then any of a law (+squash[BETA], +clip[BETA], +barrier[GAIN], +profile[BETA]), +guards,
/// +monitor, +risk[WEIGHT] and +A1, in this order; `law` gives what the text does not. Guards
/// without a law act on the given one. TVFH and TD*Lite, which choose no heading, take no risk.
/// \throws std::invalid_argument naming what is not known, and what would be.
[[nodiscard]] Arm parse_arm(std::string_view text, const SpeedLaw& law);

/// Arms with a comma between. \throws std::invalid_argument as above, or if one is named twice.
[[nodiscard]] std::vector<Arm> parse_arms(std::string_view text, const SpeedLaw& law);

}  // namespace tcert::study
