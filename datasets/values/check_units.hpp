#pragma once
/// \file
/// Readings and forces of a size that the unit in their column's name does not give.

#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <vector>

#include "datasets/ticks.hpp"
#include "datasets/values/ray_scan.hpp"
#include "datasets/values/value_finding.hpp"

namespace tcert {

/// A finding per ray and sign, in the order of the rays. Fresh ticks alone count; a ray of which
/// fewer than 20 are known says nothing.
///
/// - *Bend*: over 20 % outside the calibration (a tenth of its span more on both sides, for noise),
///   or 1 % beyond a whole turn, which no tentacle bends: degrees.
/// - *Range*: over 20 % beyond twice the reach. Centimetres if a tenth of the readings at most
/// would
///   then still lie beyond the reach, else millimetres; a reach that is too short if they are
///   within ten times the reach.
/// - *Force*: half of all, or while the tip seems to press for half of the time 1 %, above 50 N:
///   grams, of which an idle sensor's noise is a contact already.
///
/// \pre `scan` is that of `ticks`.
[[nodiscard]] std::vector<ValueFinding> check_units(const Robot& robot,
                                                    const CertificateParameters& parameters,
                                                    const TickTable& ticks,
                                                    const TrialScan& scan);

}  // namespace tcert
