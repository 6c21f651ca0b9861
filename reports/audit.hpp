#pragma once
/// \file
/// The audit log: one row for every guard that begins or ceases to trip and every rule that begins
/// or ceases to alarm, with its cause.

#include <string>
#include <tcert/runtime.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert {

/// Header, ended by a newline: time_s, guard, event, value, limit, cause, x_m, y_m, yaw_rad,
/// speed_mps.
[[nodiscard]] std::string audit_header();

/// Appends a row for every trigger and rule that began or ended at this tick; most ticks have none.
/// `rules` are the names of the rules; in the column guard they stand as `rule_<name>`.
/// `prefix` are cells before the first, each ended by a comma.
void append_audit_rows(std::string& out,
                       const Tick& tick,
                       const CertifiedTick& certified,
                       const ActedTick& acted,
                       const GuardParameters& parameters,
                       const std::vector<std::string>& rules = {},
                       const std::string& prefix = {});

/// Words of GuardedTick::triggers, joined by '+'; empty if there are none.
[[nodiscard]] std::string trigger_words(std::uint32_t triggers);

/// Names of signals, 1 << signal, with a comma between.
[[nodiscard]] std::string words_of_signals(std::uint32_t signals);

/// Names of the rules that alarm, joined by '+'.
[[nodiscard]] std::string alarm_words(std::uint32_t alarms, const std::vector<std::string>& rules);

}  // namespace tcert
