#pragma once
/// \file
/// The audit log: one row for every guard that begins or ceases to trip, with its cause.

#include <string>
#include <tcert/guards.hpp>
#include <tcert/tick.hpp>

namespace tcert {

/// Header, ended by a newline: time_s, guard, event, value, limit, cause, x_m, y_m, yaw_rad,
/// speed_mps.
[[nodiscard]] std::string audit_header();

/// Appends a row for every trigger that began or ended at this tick; most ticks have none.
/// `prefix` are cells before the first, each ended by a comma.
void append_audit_rows(std::string& out,
                       const Tick& tick,
                       const CertifiedTick& certified,
                       const GuardedTick& guarded,
                       const GuardParameters& parameters,
                       const std::string& prefix = {});

/// Words of GuardedTick::triggers, joined by '+'; empty if there are none.
[[nodiscard]] std::string trigger_words(std::uint32_t triggers);

}  // namespace tcert
