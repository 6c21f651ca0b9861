#pragma once
/// \file
/// Rays that say what no working ray would: a contact that outlives its wall, a reading that never
/// moves, two rays that are one, none at all.

#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <vector>

#include "datasets/ticks.hpp"
#include "datasets/values/ray_scan.hpp"
#include "datasets/values/value_finding.hpp"

namespace tcert {

/// A finding per ray and fault, in the order of the rays. Fresh ticks alone count, and a trial with
/// fewer than 50 of them or less than 1 m of way says nothing.
///
/// - *Never releases*: a tip force that, once at contact_on_n, does not fall below contact_off_n
///   before the log ends, while the ray's own reading is free (within contact_slack_m of the
///   longest clearance that it can state) at half or more of the ticks since, and on 1 m and a
///   third of the trial's way. A robot that is held in a gate, or drives along a wall, reads the
///   wall; one that grazes a wall at the end of its reach does not do so for long.
/// - *Never moves*: one reading at all ticks. A `range` ray may state its reach all along: nothing
///   is there. A tentacle's sensor is never that still, bent or not.
/// - *Identical*: a ray whose readings are those of an earlier ray at every tick, the missing ones
///   too. Rays that never move are left out.
/// - *Silent*: readings at less than a tenth of the ticks, while another ray has them at half of
///   them. A ray of a lower rate has them at all: its last ones are held.
///
/// O(rays) after the scan, but for rays that are suspect. \pre `scan` is that of `ticks`.
[[nodiscard]] std::vector<ValueFinding> check_rays(const Robot& robot,
                                                   const CertificateParameters& parameters,
                                                   const TickTable& ticks,
                                                   const TrialScan& scan);

}  // namespace tcert
