#include "datasets/corpus/micro_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <tcert/elementary.hpp>
#include <vector>

#include "datasets/corpus/drive.hpp"
#include "datasets/corpus/purpose.hpp"
#include "datasets/corpus/streams.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

constexpr std::array<double, 5> kOffsets{-0.030, -0.015, 0.0, 0.015, 0.030};
constexpr double kScale = 0.008;  // of the logistic law of success
constexpr double kCorridorLength = 3.4;
constexpr double kCorridorWidth = 1.2;
constexpr double kGateFromLeft = 1.5;  // from the corridor's left end; not its middle
constexpr double kGateLength = 0.15;
constexpr double kApproachSpeed = 0.15;
constexpr double kSqueeze =
    0.002;  // how much the body gives beyond the gate, or stands proud of it
constexpr double kEndRadius = 0.3;
constexpr std::uint64_t kEverything = kGatePasses;  // index of the draws that order the passes

struct Pass {
  double gate_width_m = 0.0;
  bool from_left = true;
};

/// Gates and sides in a random order of their own.
Pass pass_of(std::uint64_t seed, std::uint64_t index) {
  table::RandomStream random(seed, draws::kMicroStudy, kEverything);
  std::vector<std::uint64_t> order(kGatePasses);
  std::iota(order.begin(), order.end(), std::uint64_t{0});
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  }
  const std::uint64_t place = order[index];
  return {corpus_robot().body_width_m + kOffsets[place % kOffsets.size()],
          place / kOffsets.size() % 2 == 0};
}

Region region_at(double x) { return Disc{{x, 0.0}, kEndRadius}; }

Polygon box(double x_low, double y_low, double x_high, double y_high) {
  return {{{x_low, y_low}, {x_high, y_low}, {x_high, y_high}, {x_low, y_high}}};
}

/// A straight corridor from S at x = 0 to G at x = kCorridorLength.
World build_corridor(const Pass& pass) {
  const double gate = pass.from_left ? kGateFromLeft : kCorridorLength - kGateFromLeft;
  const double end = kCorridorLength + 1.0;
  const double wall = 0.5 * kCorridorWidth;
  World world;
  world.synthetic = true;
  world.bounds = {{-1.0, -1.0}, {end, 1.0}};
  world.start = region_at(0.0);
  world.goal = region_at(kCorridorLength);
  world.obstacles.emplace_back(box(-1.0, wall, end, 1.0));
  world.obstacles.emplace_back(box(-1.0, -1.0, end, -wall));
  const double half = 0.5 * kGateLength;
  const double jaw = 0.5 * pass.gate_width_m;
  world.obstacles.emplace_back(box(gate - half, jaw, gate + half, wall));
  world.obstacles.emplace_back(box(gate - half, -wall, gate + half, -jaw));
  return world;
}

DrivePlan plan_pass(const Pass& pass, bool success) {
  DrivePlan plan;
  plan.legs = {{straight_path({0.0, 0.0}, {kCorridorLength + 0.2, 0.0}), false}};
  plan.goal = region_at(kCorridorLength);
  plan.policy = {kApproachSpeed, 0.0, 0.0, 0.0, 0.02};
  plan.graded_caution = 0.0;
  const double half_gate = 0.5 * pass.gate_width_m;
  const double half_body = 0.5 * corpus_robot().body_width_m;
  plan.body_radius_m = success ? std::min(half_body, half_gate - kSqueeze)
                               : std::max(half_body, half_gate + kSqueeze);
  plan.when_stuck = EndReason::wedged;
  return plan;
}

}  // namespace

SimulatedTrial simulate_gate_pass(std::uint64_t seed, std::uint64_t index) {
  const Pass pass = pass_of(seed, index);
  table::RandomStream random(seed, draws::kMicroStudy, index);
  const double margin = pass.gate_width_m - corpus_robot().body_width_m;
  const bool success = random.uniform() < 1.0 / (1.0 + elementary::exp(-margin / kScale));

  SimulatedTrial trial;
  trial.true_margin_m = margin;
  trial.world = build_corridor(pass);
  trial.world.seed = seed;
  trial.world.name = fmt::format("g{:03}", index);
  const WallIndex walls(trial.world, kSensingRange);
  const Drive driven = drive(
      plan_pass(pass, success), walls, table::RandomStream(seed, draws::kMicroStudy, 1000 + index));
  if ((driven.end_reason == EndReason::goal) != success) {
    throw std::logic_error(
        fmt::format("gate pass {} of seed {} did not end as drawn", index, seed));
  }
  // Beyond the corpus's indices, so that no pass shares its noise with a trial.
  trial.log = log_drive(driven, walls, {seed, (std::uint64_t{1} << 40U) + index, false, 0.0});
  trial.row.trial_id = trial.world.name;
  trial.row.success = success;
  trial.row.time_s = driven.time_s;
  trial.row.distance_m = driven.distance_m;
  trial.row.end_reason = driven.end_reason;
  trial.row.extra = {fmt::format("{:.4f}", margin),
                     fmt::format("{:.4f}", pass.gate_width_m),
                     pass.from_left ? "left" : "right"};
  return trial;
}

void simulate_micro_study(const std::filesystem::path& folder,
                          std::uint64_t seed,
                          const TrialProgress& progress,
                          bool replace) {
  SimulatedBundle bundle;
  bundle.info.synthetic = true;
  bundle.info.seed = seed;
  bundle.info.provenance = fmt::format(
      "synthetic, seed {}: made by tcert, not logged by a robot; 60 passes of the bottleneck "
      "micro-study, "
      "Pr(success) = logistic((gate width - body width) / 8 mm), declared",
      seed);
  bundle.info.robot = corpus_robot();
  bundle.info.course = {region_at(0.0), region_at(kCorridorLength)};
  bundle.info.trial_limit_s = 180.0;
  bundle.extra_columns = {"true_margin_m", "gate_width_m", "entry_side"};
  bundle.trials = kGatePasses;
  bundle.simulate = [seed](std::uint64_t i) { return simulate_gate_pass(seed, i); };
  write_simulated_bundle(folder, bundle, progress, replace);
}

}  // namespace tcert
