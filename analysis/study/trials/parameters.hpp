#pragma once
/// \file
/// Every parameter of the way from a log to its features and replays, in one table: the same names
/// in config files, on the command line, in bundle.json and in the manifest.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tcert/fallback.hpp>
#include <tcert/guards.hpp>
#include <tcert/parameters.hpp>
#include <tcert/policy_parameters.hpp>
#include <tcert/risk_field.hpp>
#include <tcert/robot.hpp>
#include <tcert/route_planner.hpp>
#include <tcert/speed_law.hpp>
#include <witness/parameters.hpp>

#include "analysis/study/assurance/unsafe_rule.hpp"
#include "analysis/study/replay/replay_options.hpp"
#include "analysis/study/trials/features.hpp"
#include "datasets/driven/drive_parameters.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert::study {

/// Values that take the place of those in a bundle's robot.
struct RobotOverrides {
#define TCERT_NUMBER(type, member, ...) std::optional<type> member;
#include <tcert/parameters/robot.def>
};

/// Values that take the place of those that each policy was fitted to.
struct PolicyOverrides {
  std::optional<double> cruise_mps;
  std::optional<double> caution;
  std::optional<double> lookahead_m;
};

struct ParameterSet {
  ResampleOptions resample;
  RobotOverrides robot;
  CertificateParameters certificate;
  witness::WitnessParameters witness;
  SpeedLaw speed_law;
  EarlyWindowOptions early_window;
  GuardParameters guards;
  RiskParameters risk;
  FallbackParameters fallback;
  RouteParameters route;
  ReplayOptions replay;
  UnsafeRule unsafe;
  DriveParameters drive;
  policies::PolicyParameters policy;  ///< But for what is in policy_overrides.
  PolicyOverrides policy_overrides;
};

/// The first step of the way from log to result that another value changes. Features and control
/// both follow from the series, neither from the other.
enum class Stage {
  resample,  ///< Log to ticks.
  certify,   ///< Ticks to series.
  witness,   ///< Log to T_t, under clearance=witness.
  features,  ///< Series to features.
  control,   ///< Series to guarded speeds, routes and replays.
  drive,     ///< Nothing that is read: how trials are driven.
};

[[nodiscard]] std::string_view to_string(Stage stage) noexcept;

struct ParameterInfo {
  std::string_view key;
  std::string_view unit;  ///< Empty if it has none.
  std::string_view doc;   ///< One sentence that says when to change it.
  Stage stage = Stage::certify;
  std::string accepts;  ///< "a number above 0", "path, contact, contact_literal or none".
  /// Value as text that `set` reads back to the same bits; empty for an override that is not set.
  std::function<std::string(const ParameterSet&)> get;
  /// False, and nothing changed, if the text is not what the parameter accepts.
  std::function<bool(ParameterSet&, std::string_view)> set;
};

/// Sorted by stage and topic, as they are to be listed.
[[nodiscard]] std::span<const ParameterInfo> parameter_table();

/// Sets one parameter from text. \throws std::invalid_argument naming the nearest known key, or the
/// value found and what is accepted.
void set_parameter(ParameterSet& parameters, std::string_view key, std::string_view value);

/// Checks what one parameter alone cannot show. \throws std::invalid_argument naming the parameter.
void validate(const ParameterSet& parameters);

/// The bundle's robot with the overrides in place.
[[nodiscard]] Robot with_overrides(Robot robot, const RobotOverrides& overrides);

}  // namespace tcert::study
