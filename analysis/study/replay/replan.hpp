#pragma once
/// \file
/// The routes that a guarded robot would have asked for along a logged run (paper 5).

#include <cstddef>
#include <cstdint>
#include <span>
#include <tcert/certifier.hpp>
#include <tcert/route_planner.hpp>
#include <tcert/runtime.hpp>

#include "datasets/ticks.hpp"

namespace tcert::study {

struct ReplanSummary {
  std::size_t replans = 0;
  std::size_t without_route = 0;         ///< Replans that found every way closed.
  std::size_t route_changes = 0;         ///< Replans with another exit than the replan before.
  std::uint64_t expansions = 0;          ///< Of D* Lite, all replans together.
  std::uint64_t scratch_expansions = 0;  ///< Of the same search begun anew at each replan.
};

/// Certifies the run again tick by tick and replans whenever a guard begins to trip. `certifier`
/// and `planner` are cleared first. \throws std::invalid_argument if the lengths differ.
[[nodiscard]] ReplanSummary replan_trial(Certifier& certifier,
                                         RoutePlanner& planner,
                                         const TickTable& ticks,
                                         std::span<const ActedTick> acted);

/// The planner of a course, for a robot that drives routes at the law's least speed.
/// \pre the course has a goal.
[[nodiscard]] RoutePlanner route_planner(const Course& course,
                                         const CertificateParameters& certificate,
                                         const Guards& guards,
                                         const GuardParameters& guard_parameters,
                                         const RouteParameters& parameters);

}  // namespace tcert::study
