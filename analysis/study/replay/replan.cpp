#include "analysis/study/replay/replan.hpp"

#include <optional>
#include <stdexcept>

namespace tcert::study {
namespace {

constexpr std::uint32_t kAsksForRoute =
    guard_margin | guard_force | guard_replan | guard_no_bound | guard_barrier;

std::uint64_t expansions_from_scratch(const DStarLite& search, std::optional<DStarLite>& fresh) {
  fresh = search;
  fresh->forget();
  const std::uint64_t before = fresh->expansions();
  fresh->plan();
  return fresh->expansions() - before;
}

}  // namespace

RoutePlanner route_planner(const Course& course,
                           const CertificateParameters& certificate,
                           const Guards& guards,
                           const GuardParameters& guard_parameters,
                           const RouteParameters& parameters) {
  const double tracking_error_m = guards.shares_of_error_m(guards.law().min_speed_mps);
  return RoutePlanner(certificate.max_nodes,
                      certificate.max_edges,
                      course.goal.value(),
                      {tracking_error_m, guard_parameters.replan_margin_m},
                      parameters);
}

ReplanSummary replan_trial(Certifier& certifier,
                           RoutePlanner& planner,
                           const TickTable& ticks,
                           std::span<const ActedTick> acted) {
  if (acted.size() != ticks.size()) {
    throw std::invalid_argument("replan: actions and ticks differ in length");
  }
  certifier.reset();
  planner.clear();
  ReplanSummary summary;
  std::optional<DStarLite> fresh;
  std::uint32_t last_exit = kNone;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const CertifiedTick certified = certifier.update(ticks[i]);
    if ((certified.flags & (flag_stale | flag_bad_input)) != 0) {
      continue;
    }
    planner.follow(
        certifier.graph(), certifier.last_node(), ticks.time_ns[i], certifier.since_start_m());
    if ((acted[i].guarded.began & kAsksForRoute) == 0 || certifier.last_node() == kNone) {
      continue;
    }
    planner.block_ahead((acted[i].guarded.began & guard_force) != 0);
    const std::uint64_t before = planner.search().expansions();
    const Route route = planner.replan();
    ++summary.replans;
    summary.expansions += planner.search().expansions() - before;
    summary.scratch_expansions += expansions_from_scratch(planner.search(), fresh);
    summary.without_route += route.cost == kBlocked ? 1 : 0;
    summary.route_changes += route.exit != last_exit ? 1 : 0;
    last_exit = route.exit;
  }
  return summary;
}

}  // namespace tcert::study
