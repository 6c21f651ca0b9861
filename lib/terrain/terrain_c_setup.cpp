#include <algorithm>
#include <stdexcept>
#include <string>
#include <terrain/limits.hpp>
#include <terrain/terrain_c_setup.hpp>

namespace tcert::terrain {
namespace {

[[nodiscard]] Selection selection_of(std::int32_t word, RuleSet rules) {
  switch (word) {
    case TCERT_TERRAIN_BY_RULES:
      return rules == RuleSet::band ? Selection::pareto : Selection::horizon;
    case TCERT_TERRAIN_THESIS:
      return Selection::thesis;
    case TCERT_TERRAIN_LOOK_AHEAD:
      return Selection::look_ahead;
    case TCERT_TERRAIN_HORIZON:
      return Selection::horizon;
    case TCERT_TERRAIN_PARETO:
      return Selection::pareto;
    default:
      throw std::invalid_argument("selection: found " + std::to_string(word) +
                                  ", expected a tcert_terrain_selection");
  }
}

[[nodiscard]] Body body_of(const tcert_terrain_setup& s) {
  Body body;
  const bool is_box = s.body_length != 0.0 || s.body_width != 0.0;
  if (s.body_radius != 0.0 && is_box) {
    throw std::invalid_argument("a body is a disc or a box: a radius, or a length and a width");
  }
  if (s.body_radius != 0.0) {
    body.kind = Body::Kind::disc;
    body.radius = s.body_radius;
  } else if (is_box) {
    body.kind = Body::Kind::box;
    body.length = s.body_length;
    body.width = s.body_width;
    body.yaw = s.body_yaw_rad;
  }
  return body;
}

}  // namespace

tcert_terrain_setup default_setup_in_c() noexcept {
  tcert_terrain_setup setup{};
  setup.struct_size = sizeof setup;
  setup.rules = TCERT_TERRAIN_CERTIFIED;
  setup.selection = TCERT_TERRAIN_BY_RULES;
  setup.max_steps = 2000;
  setup.length_scale = 30.0;
  setup.confidence = 0.95;
  return setup;
}

ExploreSetup setup_of(const tcert_terrain_setup& s, const std::uint8_t* blocked) {
  if (s.rows < 1 || s.columns < 1 || s.rows > kMostSide || s.columns > kMostSide) {
    throw std::invalid_argument("rows and columns: found " + std::to_string(s.rows) + " x " +
                                std::to_string(s.columns) + ", expected 1 to " +
                                std::to_string(kMostSide));
  }
  if (s.rules != TCERT_TERRAIN_CERTIFIED && s.rules != TCERT_TERRAIN_BAND) {
    throw std::invalid_argument("rules: found " + std::to_string(s.rules) +
                                ", expected a tcert_terrain_rules");
  }
  ExploreSetup setup;
  setup.rules.kind = s.rules == TCERT_TERRAIN_BAND ? RuleSet::band : RuleSet::certified;
  setup.rules.threshold = s.threshold;
  setup.rules.lipschitz = s.lipschitz != 0.0 ? s.lipschitz : setup.rules.lipschitz;
  setup.rules.noise_bound = s.noise_bound;
  setup.rules.noise_sd = s.noise_sd;
  setup.rules.selection = selection_of(s.selection, setup.rules.kind);
  if (setup.rules.kind == RuleSet::band) {
    setup.rules.beta = kTrustedBeta;
  }
  setup.prior.length_scale = s.length_scale;
  setup.start = {s.start_x, s.start_y};
  if (s.has_goal != 0) {
    setup.goal = Cell{s.goal_x, s.goal_y};
  }
  if (blocked != nullptr) {
    const std::size_t cells = Grid{s.rows, s.columns}.size();
    setup.blocked.resize(cells);
    std::transform(blocked, blocked + cells, setup.blocked.begin(), [](std::uint8_t b) {
      return b != 0 ? std::uint8_t{1} : std::uint8_t{0};
    });
  }
  setup.max_steps = s.max_steps;
  setup.motion = Motion::pursuit;
  setup.body = body_of(s);
  setup.noise_sd = s.noise_sd;
  setup.gradient = {s.prior_gradient_sd, s.prior_places};
  setup.confidence = s.confidence;
  return setup;
}

}  // namespace tcert::terrain
