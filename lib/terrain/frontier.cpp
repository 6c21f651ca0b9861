#include <algorithm>
#include <cmath>
#include <numbers>
#include <terrain/frontier.hpp>

namespace tcert::terrain {
namespace {

constexpr std::size_t kBeam = 24;
constexpr int kDirections = 16;

/// A sequence of expected measurements.
struct Sequence {
  Cell first;
  Cell last;
  double radius = 0.0;  // of the last disc
  double way = 0.0;
  double gain = 0.0;  // without a goal: how far the ground grew
  double score = 0.0;
};

[[nodiscard]] double score_of(const FrontierView& view,
                              const Sequence& s,
                              std::optional<Cell> goal) {
  const double way = view.rules.travel_weight * s.way;
  return goal ? std::max(distance(s.last, *goal) - s.radius, 0.0) + way : way - s.gain;
}

void keep_best(std::vector<Sequence>& sequences) {
  std::stable_sort(sequences.begin(), sequences.end(), [](const Sequence& a, const Sequence& b) {
    return a.score < b.score;
  });
  sequences.resize(std::min(sequences.size(), kBeam));
}

/// Whether ground may be expected at a cell: in the grid, free, and not ruled out.
[[nodiscard]] bool may_be_ground(const FrontierView& view, Cell c) {
  if (!view.grid.contains(c)) {
    return false;
  }
  const std::size_t i = view.grid.index(c);
  return (view.blocked.empty() || view.blocked[i] == 0) &&
         view.intervals.upper[i] >= view.rules.threshold;
}

/// Sequences that go on at the edge of the last disc of `from`.
void extend(const FrontierView& view,
            const Sequence& from,
            std::optional<Cell> goal,
            std::vector<Sequence>& longer) {
  // Beyond the grid there is nothing, however steady the ground.
  const double radius =
      std::min(from.radius, static_cast<double>(view.grid.rows) + view.grid.columns);
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kDirections;
    const Cell c{from.last.x + static_cast<int>(radius * std::cos(angle)),
                 from.last.y + static_cast<int>(radius * std::sin(angle))};
    if (!may_be_ground(view, c) || view.safe[view.grid.index(c)] != 0) {
      continue;
    }
    Sequence next = from;
    next.last = c;
    next.radius = view.expected_radius(view.grid.index(c));
    next.way += distance(from.last, c);
    next.gain += next.radius;
    next.score = score_of(view, next, goal);
    if (next.radius > 0.0) {
      longer.push_back(next);
    }
  }
}

[[nodiscard]] double normal_probability(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

/// Of values at least `least` at cell i.
[[nodiscard]] double probability_above(const FrontierView& view, std::size_t i, double least) {
  const double sd = std::sqrt(std::max(view.variance[i], 0.0) * view.field_variance);
  const double over = view.expected(i) - least;
  return sd > 0.0 ? normal_probability(over / sd) : (over >= 0.0 ? 1.0 : 0.0);
}

}  // namespace

double FrontierView::expected(std::size_t i) const {
  return std::clamp(mean[i], intervals.lower[i], std::max(intervals.lower[i], intervals.upper[i]));
}

double FrontierView::expected_radius(std::size_t i) const {
  if (rules.kind == RuleSet::band) {
    return 0.0;
  }
  return std::max(0.0, (expected(i) - rules.threshold) / rules.lipschitz);
}

std::optional<Cell> look_ahead(const FrontierView& view,
                               const std::vector<std::size_t>& candidates,
                               std::optional<Cell> goal,
                               Cell robot) {
  std::optional<Cell> next;
  double best = kUnbounded;
  for (const std::size_t i : candidates) {
    const Cell c = view.grid.cell(i);
    const double radius = view.expected_radius(i);
    const double gain = radius - std::sqrt(static_cast<double>(view.depth2[i]));
    const double way = view.rules.travel_weight * distance(c, robot);
    const double score = goal ? distance(c, *goal) - radius + way : way - gain;
    if (score < best) {
      best = score;
      next = c;
    }
  }
  return next;
}

std::optional<Cell> best_sequence(const FrontierView& view,
                                  const std::vector<std::size_t>& candidates,
                                  std::optional<Cell> goal,
                                  Cell robot) {
  std::vector<Sequence> beam;
  for (const std::size_t i : candidates) {
    const Cell c = view.grid.cell(i);
    const double radius = view.expected_radius(i);
    Sequence s{c,
               c,
               radius,
               distance(c, robot),
               radius - std::sqrt(static_cast<double>(view.depth2[i])),
               0.0};
    s.score = score_of(view, s, goal);
    beam.push_back(s);
  }
  if (beam.empty()) {
    return std::nullopt;
  }
  keep_best(beam);
  Sequence best = beam.front();
  for (int n = 1; n < view.rules.horizon; ++n) {
    std::vector<Sequence> longer;
    for (const Sequence& s : beam) {
      extend(view, s, goal, longer);
    }
    keep_best(longer);
    beam = std::move(longer);
    if (!beam.empty() && beam.front().score < best.score) {
      best = beam.front();
    }
  }
  return best.first;
}

double growth_probability(const FrontierView& view, std::size_t i) {
  const Rules& rules = view.rules;
  if (rules.kind != RuleSet::band) {
    const double depth = std::sqrt(static_cast<double>(view.depth2[i]));
    return probability_above(
        view, i, rules.threshold + rules.noise_bound + rules.lipschitz * depth);
  }
  const Cell c = view.grid.cell(i);
  double most = 0.0;
  for (const Cell step : kSteps) {
    const Cell next{c.x + step.x, c.y + step.y};
    if (may_be_ground(view, next) && view.safe[view.grid.index(next)] == 0) {
      most = std::max(most, probability_above(view, view.grid.index(next), rules.threshold));
    }
  }
  return most;
}

std::optional<Cell> best_of_front(const FrontierView& view,
                                  const std::vector<std::size_t>& candidates,
                                  std::optional<Cell> goal,
                                  Cell robot) {
  struct Offer {
    std::size_t index = 0;
    double cost = 0.0;
    double probability = 0.0;
  };
  std::vector<Offer> offers;
  for (const std::size_t i : candidates) {
    const Cell c = view.grid.cell(i);
    const double way = view.rules.travel_weight * distance(c, robot);
    offers.push_back({i, way + (goal ? distance(c, *goal) : 0.0), growth_probability(view, i)});
  }
  std::stable_sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.probability > b.probability;
  });
  std::vector<Offer> front;
  for (const Offer& offer : offers) {
    if (front.empty() || offer.probability > front.back().probability) {
      front.push_back(offer);
    }
  }
  if (front.empty()) {
    return std::nullopt;
  }
  const auto scaled = [](double value, double low, double high) {
    return high > low ? (value - low) / (high - low) : 0.0;
  };
  const double weight = view.rules.growth_weight;
  const Offer* best = nullptr;
  double highest = -kUnbounded;
  for (const Offer& offer : front) {
    const double score =
        weight * scaled(offer.probability, front.front().probability, front.back().probability) -
        (1.0 - weight) * scaled(offer.cost, front.front().cost, front.back().cost);
    if (score > highest) {
      highest = score;
      best = &offer;
    }
  }
  return view.grid.cell(best->index);
}

}  // namespace tcert::terrain
