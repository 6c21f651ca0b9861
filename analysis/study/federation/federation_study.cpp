#include "analysis/study/federation/federation_study.hpp"

#include <algorithm>
#include <cmath>
#include <federation/federate.hpp>
#include <federation/submap_text.hpp>
#include <table/random.hpp>
#include <tcert/certifier.hpp>
#include <witness/free_space.hpp>

#include "analysis/study/federation/trial_submap.hpp"
#include "analysis/study/soundness/soundness.hpp"
#include "analysis/study/witness/felt_samples.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/random_run.hpp"

namespace tcert::study {
namespace {

constexpr std::uint32_t kFrames = 0x6665'6401;
constexpr double kTick = 0.1;       // s
constexpr double kNearNode = 0.25;  // m, from a place to a node that tells of it
constexpr std::uint64_t kSeedOfRobot = 1U << 20U;

/// What a robot of a team did and knows in the end.
struct TeamMate {
  std::vector<Point> places;                            // by tick
  std::array<federation::Source, 2> told;               // proved, felt
  std::array<std::vector<std::uint32_t>, 2> closed_at;  // by edge: tick
};

TickTable between(const TickTable& ticks, std::size_t first, std::size_t last) {
  const auto at = [](auto& values, std::size_t i) {
    return values.begin() + static_cast<std::ptrdiff_t>(std::min(i, values.size()));
  };
  const auto cut = [&](const auto& values, std::size_t width) {
    return std::decay_t<decltype(values)>(at(values, first * width), at(values, last * width));
  };
  TickTable part;
  part.rays = ticks.rays;
  part.time_ns = cut(ticks.time_ns, 1);
  part.poses = cut(ticks.poses, 1);
  part.readings = cut(ticks.readings, ticks.rays);
  part.stale = cut(ticks.stale, 1);
  part.segment_start = cut(ticks.segment_start, 1);
  part.speed_cmd_mps = cut(ticks.speed_cmd_mps, 1);
  part.yaw_rate_cmd_rps = cut(ticks.yaw_rate_cmd_rps, 1);
  part.footing = cut(ticks.footing, 1);
  return part;
}

/// By edge the tick at which it closed: edges are numbered as they close.
std::vector<std::uint32_t> closing_ticks(const TrialSeries& series) {
  std::vector<std::uint32_t> closed(series.edges.size(), 0);
  std::uint32_t known = 0;
  for (std::uint32_t t = 0; t < series.ticks.size(); ++t) {
    for (; known < series.ticks[t].edges; ++known) {
      closed[known] = t;
    }
  }
  return closed;
}

/// Those of the edges that source_of() keeps.
std::vector<std::uint32_t> kept(const std::vector<std::uint32_t>& closed, const auto& margin_of) {
  std::vector<std::uint32_t> some;
  for (std::size_t e = 0; e < closed.size(); ++e) {
    if (margin_of(e) > 0.0) {
      some.push_back(closed[e]);
    }
  }
  return some;
}

TeamMate explore(const TickTable& ticks,
                 const Course& course,
                 const CertificateParameters& certificate) {
  const Robot& robot = corpus_robot();
  Certifier certifier(robot, course, certificate);
  const TrialSeries series = certify_trial(certifier, ticks);
  const std::vector<std::uint32_t> closed = closing_ticks(series);
  TeamMate one;
  for (const Pose& pose : ticks.poses) {
    one.places.push_back(pose.position);
  }
  one.told[1] =
      source_of_trial(series.nodes, series.edges, nullptr, course, robot, ClearanceReading::width);
  one.closed_at[1] =
      kept(closed, [&](std::size_t e) { return series.edges[e].certified.margin_m; });
  const witness::WitnessParameters parameters;
  const witness::Samples samples = felt_samples(ticks, robot);
  const witness::FreeCells cells = witness::free_space(
      robot, course, samples, witness::free_space_options(parameters, certificate));
  const EdgeProofs proofs = prove_edges(
      witness::SearchSpace(cells), series, samples, robot, course, parameters, certificate);
  one.told[0] =
      source_of_trial(series.nodes, series.edges, &proofs, course, robot, ClearanceReading::width);
  one.closed_at[0] = kept(closed, [&](std::size_t e) {
    return proofs.found.paths[e] ? proofs.found.paths[e]->checked.margin_m : -1.0;
  });
  return one;
}

/// The frame is turned about the middle of what is known and shifted, within the stated errors.
void put_off(federation::Source& source, table::RandomStream random) {
  Point middle;
  for (const federation::SubmapNode& node : source.nodes) {
    middle = middle + 1.0 / static_cast<double>(source.nodes.size()) * node.pose.position;
  }
  double radius_m = 1e-3;
  for (const federation::SubmapNode& node : source.nodes) {
    radius_m = std::max(radius_m, distance(node.pose.position, middle));
  }
  const double turn = std::min(kFrameErrorRad, 0.5 * kFrameErrorM / radius_m);
  const double by_rad = random.uniform(-turn, turn);
  const double shift_m = random.uniform(0.0, 0.5 * kFrameErrorM);
  const Point to = middle + shift_m * direction(random.uniform(-3.14, 3.14));
  for (federation::SubmapNode& node : source.nodes) {
    node.pose = {transform({to, by_rad}, node.pose.position - middle), node.pose.yaw_rad + by_rad};
  }
}

federation::Submap submap_by(const std::vector<federation::Source>& told,
                             const std::vector<std::vector<std::uint32_t>>& closed_at,
                             std::uint32_t tick) {
  federation::Submap all{federation::agent_of(corpus_robot()), "", {}};
  for (std::size_t r = 0; r < told.size(); ++r) {
    federation::Source some = told[r];
    some.edges.clear();
    for (std::size_t e = 0; e < told[r].edges.size(); ++e) {
      if (closed_at[r][e] <= tick) {
        some.edges.push_back(told[r].edges[e]);
      }
    }
    all.sources.push_back(std::move(some));
  }
  return federation::in_order(std::move(all));
}

/// Ticks that a robot has spent by `last` where no other had closed an edge at a node nearby.
std::uint32_t unknown_ticks(const std::vector<TeamMate>& team,
                            const std::vector<federation::Source>& told,
                            const std::vector<std::vector<std::uint32_t>>& closed_at,
                            std::size_t robot,
                            std::uint32_t last) {
  const std::vector<Point>& places = team[robot].places;
  const std::size_t end = std::min<std::size_t>(places.size(), last + std::size_t{1});
  std::vector<std::uint8_t> known(end, 0);
  for (std::size_t other = 0; other < told.size(); ++other) {
    for (std::size_t e = 0; other != robot && e < told[other].edges.size(); ++e) {
      for (std::size_t t = closed_at[other][e]; t < end; ++t) {
        for (const EdgeEnd& edge_end : told[other].edges[e].ends) {
          const Point node = told[other].nodes[edge_end.node].pose.position;
          known[t] = known[t] != 0 || distance(node, places[t]) <= kNearNode ? 1 : 0;
        }
      }
    }
  }
  return static_cast<std::uint32_t>(std::ranges::count(known, 0));
}

TeamOutcome outcome_of(const std::vector<TeamMate>& team,
                       FederationMethod method,
                       std::uint64_t seed,
                       std::uint64_t index) {
  const std::size_t reading = method == FederationMethod::width ? 1 : 0;
  const bool is_off = method == FederationMethod::witness_frames;
  TeamOutcome outcome;
  std::vector<federation::Source> told;
  std::vector<std::vector<std::uint32_t>> closed_at;
  std::uint32_t last = 0;
  for (std::size_t r = 0; r < team.size(); ++r) {
    told.push_back(team[r].told[reading]);
    closed_at.push_back(team[r].closed_at[reading]);
    federation::Source& source = told.back();
    source.name = "robot" + std::to_string(r);
    source.frame_error_m = is_off ? kFrameErrorM : 0.0;
    source.frame_error_rad = is_off ? kFrameErrorRad : 0.0;
    if (is_off) {
      put_off(source, table::RandomStream(seed, kFrames, 256 * index + 16 * team.size() + r));
    }
    last = std::max(last, static_cast<std::uint32_t>(team[r].places.size()));
    outcome.bytes += static_cast<std::uint32_t>(
        federation::to_text(
            federation::in_order({federation::agent_of(corpus_robot()), "", {source}}))
            .size());
  }
  const federation::Federation whole = federation::federate(submap_by(told, closed_at, last));
  outcome.certificate_m = whole.way.margin_m;
  outcome.best_alone_m = *std::ranges::max_element(whole.own);
  outcome.joins = static_cast<std::uint32_t>(whole.known.joins);
  outcome.edges = static_cast<std::uint32_t>(whole.known.edges.size()) - outcome.joins;
  std::uint32_t by = last;
  if (outcome.certificate_m > 0.0) {
    // What is known only grows, and T_H with it.
    std::uint32_t low = 0;
    while (low < by) {
      const std::uint32_t middle = low + (by - low) / 2;
      const bool issued =
          federation::federate(submap_by(told, closed_at, middle)).way.margin_m > 0.0;
      (issued ? by : low) = issued ? middle : middle + 1;
    }
    outcome.time_s = kTick * by;
  }
  std::uint32_t longest = 0;
  for (std::size_t r = 0; r < team.size(); ++r) {
    longest = std::max(longest, unknown_ticks(team, told, closed_at, r, by));
  }
  outcome.dwell_s = kTick * longest;
  return outcome;
}

CertificateParameters small_width() {
  CertificateParameters parameters = mixed_methods().front().parameters;
  parameters.clearance = ClearanceReading::width;
  return parameters;
}

}  // namespace

std::string_view name_of(FederationMethod method) noexcept {
  switch (method) {
    case FederationMethod::witness:
      return "witness";
    case FederationMethod::witness_frames:
      return "witness, frames off";
    case FederationMethod::width:
      break;
  }
  return "width";
}

FederationOutcome federate_world(std::uint64_t seed, std::uint64_t index) {
  const WorldFamily family = index % 2 == 0 ? mixed_family(index / 2) : hard_family(index / 2);
  const RandomWorld drawn = draw_random_world(family, seed, index);
  const WallIndex walls = feelable_walls(drawn);
  const Course course{drawn.world.start, drawn.world.goal};
  const CertificateParameters certificate = small_width();
  FederationOutcome world{drawn.family, upper_value(drawn, corpus_robot()), {}};
  for (const std::size_t robots : kTeams) {
    std::vector<TeamMate> team;
    for (std::size_t k = 0; k < robots; ++k) {
      const TickTable whole =
          true_ticks(follow_legs(drawn, walls, seed + k * kSeedOfRobot, index), walls);
      const std::size_t first = k * whole.size() / robots;
      const std::size_t last = std::min((k + 2) * whole.size() / robots, whole.size());
      team.push_back(explore(between(whole, first, last), course, certificate));
    }
    for (const FederationMethod method : kFederationMethods) {
      world.teams.push_back(outcome_of(team, method, seed, index));
    }
  }
  return world;
}

}  // namespace tcert::study
