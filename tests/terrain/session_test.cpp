// A robot that is not simulated is told what a simulated one does.
#include <gtest/gtest.h>

#include <terrain/terrain_c.h>
#include <cstddef>
#include <cstring>
#include <terrain/session.hpp>

#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain {
namespace {

Terrain field_of(std::uint64_t number) {
  TerrainFieldOptions field;
  field.rows = 60;
  field.columns = 48;
  field.mean = 0.0;
  field.length_scale = 8.0;
  field.number = number;
  TerrainGrid made = random_terrain(field);
  return {{made.rows, made.columns}, std::move(made.values)};
}

Cell highest(const Terrain& terrain) {
  const auto at = std::max_element(terrain.values.begin(), terrain.values.end());
  return terrain.grid.cell(static_cast<std::size_t>(at - terrain.values.begin()));
}

ExploreSetup setup_of(RuleSet kind, const Terrain& terrain) {
  ExploreSetup setup;
  setup.rules.kind = kind;
  setup.rules.threshold = 0.0;
  setup.rules.lipschitz = 18.0;
  setup.rules.selection = Selection::horizon;
  setup.rules.beta = kind == RuleSet::band ? kTrustedBeta : 3.0;
  setup.confidence = 0.95;
  setup.prior.length_scale = 6.0;
  setup.start = highest(terrain);
  setup.goal = Cell{30, 24};
  setup.more_goals = {{10, 10}};
  setup.motion = Motion::pursuit;
  setup.max_steps = 60;
  return setup;
}

TEST(Session, TellsWhatExploreDoes) {
  for (const RuleSet kind : {RuleSet::certified, RuleSet::band}) {
    for (std::uint64_t number = 0; number < 6; ++number) {
      const Terrain terrain = field_of(number);
      ExploreSetup setup = setup_of(kind, terrain);
      const Told told{false, false, false};
      Session session(terrain.grid, setup, told);
      std::vector<Measurement> first;
      for (const Cell c : session.first_cells(2)) {
        first.push_back({position(c), terrain.at(c)});
      }
      ExploreSetup simulated = setup;
      for (std::size_t k = 0; k + 1 < first.size(); ++k) {
        simulated.first_cells.push_back(nearest_cell(first[k].at));
        session.take(simulated.first_cells.back(), first[k].value);
      }
      settle(simulated, terrain.grid, first, told);
      const ExploreResult result = explore(terrain, simulated);
      Cell robot = setup.start;
      std::vector<Position> path{position(robot)};
      for (std::size_t k = 0;; ++k) {
        ASSERT_LT(k, result.steps.size());
        const Decision& decision = session.plan(robot, terrain.at(robot));
        const ExploreStep& step = result.steps[k];
        EXPECT_EQ(step.step, decision.row.step);
        EXPECT_EQ(step.at, decision.row.at);
        EXPECT_EQ(step.safe, decision.row.safe);
        EXPECT_EQ(step.next, decision.row.next);
        EXPECT_EQ(step.lipschitz, decision.row.lipschitz);
        EXPECT_EQ(step.certificate, decision.row.certificate);
        EXPECT_EQ(step.travelled, decision.row.travelled);
        path.insert(path.end(), decision.way.begin(), decision.way.end());
        if (decision.end) {
          EXPECT_EQ(k + 1, result.steps.size());
          const bool is_same = *decision.end == result.end || *decision.end == End::exhausted;
          EXPECT_TRUE(is_same) << to_string(*decision.end) << ", " << to_string(result.end);
          EXPECT_EQ(result.goals_reached, decision.goals_reached);
          break;
        }
        robot = nearest_cell(decision.way.back());
      }
      EXPECT_EQ(result.path, path);
    }
  }
}

TEST(Session, RefusesWhatCannotBeAndGoesOn) {
  const Terrain terrain = field_of(1);
  const ExploreSetup setup = setup_of(RuleSet::certified, terrain);
  Session session(terrain.grid, setup, {true, false, false});
  EXPECT_THROW(session.take({-1, 0}, 1.0), std::invalid_argument);
  EXPECT_THROW(session.take({1, 1}, std::nan("")), std::invalid_argument);
  const Cell start = setup.start;
  EXPECT_FALSE(session.plan(start, terrain.at(start)).end);
  EXPECT_THROW((void)session.plan({60, 0}, 1.0), std::invalid_argument);
  // It stands elsewhere than it was told to: it is planned for from there.
  const Cell aside{start.x, start.y + (start.y > 0 ? -1 : 1)};
  const Decision& decision = session.plan(aside, terrain.at(aside));
  EXPECT_EQ(1, decision.row.step);
  EXPECT_EQ(position(aside), decision.row.at);
  ExploreSetup thesis = setup;
  thesis.rules.kind = RuleSet::thesis;
  EXPECT_THROW(Session(terrain.grid, thesis, {}), std::invalid_argument);
}

/// Noise and a constant that the first measurements contradict are settled as explore() has them.
TEST(Session, SettlesWhatWasToldAsASimulationDoes) {
  const Terrain terrain = field_of(2);
  for (const bool is_noisy : {false, true}) {
    ExploreSetup setup = setup_of(RuleSet::certified, terrain);
    setup.more_goals.clear();
    setup.rules.lipschitz = is_noisy ? 18.0 : 0.1;
    setup.noise_sd = setup.rules.noise_sd = is_noisy ? 0.5 : 0.0;
    setup.rules.threshold = -1000.0;
    Session session(terrain.grid, setup, {true, false, false});
    std::vector<Measurement> first;
    for (const Cell c : session.first_cells(2)) {
      first.push_back({position(c), terrain.at(c)});
      if (!(c == setup.start)) {
        session.take(c, terrain.at(c));
      }
    }
    (void)session.plan(setup.start, terrain.at(setup.start));
    ExploreSetup settled = setup;
    settle(settled, terrain.grid, first, {true, false, false});
    EXPECT_EQ(settled.rules.lipschitz, session.setup().rules.lipschitz);
    EXPECT_EQ(settled.rules.noise_bound, session.setup().rules.noise_bound);
    if (is_noisy) {
      EXPECT_EQ(18.0, settled.rules.lipschitz);
      EXPECT_EQ(0.0, settled.confidence) << "nothing is bounded";
      EXPECT_DOUBLE_EQ(gaussian_noise_bound(0.5, 0.95, 60 + first.size()),
                       settled.rules.noise_bound);
    } else {
      EXPECT_GT(settled.rules.lipschitz, 0.1);
      EXPECT_EQ(0.95, settled.confidence);
    }
  }
  ExploreSetup unbounded = setup_of(RuleSet::certified, terrain);
  unbounded.noise_sd = unbounded.rules.noise_sd = 0.5;
  unbounded.confidence = 0.0;
  EXPECT_THROW(Session(terrain.grid, unbounded, {true, false, false}), std::invalid_argument);
}

TEST(Session, WhatIsRefusedChangesNothing) {
  const Terrain terrain = field_of(1);
  const ExploreSetup setup = setup_of(RuleSet::certified, terrain);
  const Cell start = setup.start;
  const Cell beside{start.x > 0 ? start.x - 1 : 1, start.y};
  Session refused(terrain.grid, setup, {true, false, false});
  Session plain(terrain.grid, setup, {true, false, false});
  EXPECT_THROW((void)refused.plan(start, -1.0), std::invalid_argument) << "unsafe";
  EXPECT_EQ(nullptr, refused.explorer());
  for (Session* const session : {&refused, &plain}) {
    session->take(beside, terrain.at(beside));
  }
  refused.take(beside, terrain.at(beside));  // Twice the same is once.
  EXPECT_THROW(refused.take(beside, terrain.at(beside) + 1.0), std::invalid_argument);
  EXPECT_THROW((void)refused.plan(beside, terrain.at(beside) + 1.0), std::invalid_argument);
  EXPECT_EQ(nullptr, refused.explorer());
  for (Session* const session : {&refused, &plain}) {
    (void)session->plan(start, terrain.at(start));
  }
  EXPECT_EQ(plain.explorer()->planner().measurements().size(),
            refused.explorer()->planner().measurements().size());
  EXPECT_EQ(plain.explorer()->planner().safe(), refused.explorer()->planner().safe());
  EXPECT_THROW(refused.take(start, terrain.at(start) + 1.0), std::invalid_argument);
  EXPECT_THROW((void)refused.plan(start, terrain.at(start) + 1.0), std::invalid_argument);
  EXPECT_EQ(plain.explorer()->planner().measurements().size(),
            refused.explorer()->planner().measurements().size());
}

TEST(Session, MeasurementsBesideTheWayCountTowardsTheLimit) {
  const Terrain terrain = field_of(1);
  ExploreSetup setup = setup_of(RuleSet::certified, terrain);
  setup.max_steps = 3;
  Session session(terrain.grid, setup, {true, false, false});
  (void)session.plan(setup.start, terrain.at(setup.start));
  for (int k = 0; k < 3; ++k) {
    session.take({k, 0}, terrain.at({k, 0}));
    session.take({k, 0}, terrain.at({k, 0}));
  }
  EXPECT_THROW(session.take({3, 0}, terrain.at({3, 0})), std::invalid_argument);
  EXPECT_EQ(End::step_limit, session.plan(setup.start, terrain.at(setup.start)).end);
  EXPECT_THROW((void)session.plan(setup.start, terrain.at(setup.start)), std::invalid_argument);
}

TEST(Session, RefusesASetupThatCannotBe) {
  const Terrain terrain = field_of(1);
  const auto refused = [&](const auto& change) {
    ExploreSetup setup = setup_of(RuleSet::certified, terrain);
    change(setup);
    EXPECT_THROW(Session(terrain.grid, setup, {}), std::invalid_argument);
  };
  refused([](ExploreSetup& s) {
    s.body.kind = Body::Kind::disc;
    s.body.radius = -1.0;
  });
  refused([](ExploreSetup& s) { s.prior.length_scale = 0.0; });
  refused([](ExploreSetup& s) { s.confidence = 1.0; });
  refused([](ExploreSetup& s) { s.confidence = 0.0; });
  refused([](ExploreSetup& s) { s.noise_sd = -1.0; });
  refused([](ExploreSetup& s) { s.known = {{position({99, 0}), 1.0}}; });
  refused([](ExploreSetup& s) { s.known = {{{1e300, 0.0}, 1.0}}; });
}

TEST(Session, BeginsOnSafeGroundAlone) {
  const Terrain terrain = field_of(1);
  Session session(terrain.grid, setup_of(RuleSet::certified, terrain), {true, false, false});
  EXPECT_THROW((void)session.plan({5, 5}, -1.0), std::invalid_argument);
  // What was felt beside it may be soft: the robot does not stand there.
  session.take({5, 6}, -1.0);
  const Decision& decision = session.plan({5, 5}, 5.0);
  EXPECT_EQ(0, session.explorer()->planner().safe()[terrain.grid.index({5, 6})]);
  EXPECT_LE(1U, decision.row.safe);
}

TEST(TerrainInC, TellsWhatTheSessionDoes) {
  const Terrain terrain = field_of(2);
  ExploreSetup setup = setup_of(RuleSet::certified, terrain);
  setup.more_goals.clear();
  setup.confidence = 0.0;
  Session session(terrain.grid, setup, {true, false, false});
  tcert_terrain_setup in_c;
  tcert_terrain_setup_init(&in_c);
  in_c.rows = 60;
  in_c.columns = 48;
  in_c.lipschitz = 18.0;
  in_c.length_scale = 6.0;
  in_c.start_x = setup.start.x;
  in_c.start_y = setup.start.y;
  in_c.has_goal = 1;
  in_c.goal_x = setup.goal->x;
  in_c.goal_y = setup.goal->y;
  in_c.max_steps = 60;
  char why[200] = "";
  tcert_terrain* ground = nullptr;
  ASSERT_EQ(TCERT_TERRAIN_OK, tcert_terrain_create(&in_c, nullptr, &ground, why, sizeof why))
      << why;
  EXPECT_EQ(TCERT_TERRAIN_ERROR_INPUT, tcert_terrain_take(ground, 99, 0, 1.0, why, sizeof why));
  EXPECT_NE(nullptr, std::strstr(why, "(99, 0)"));
  Cell robot = setup.start;
  for (;;) {
    const Decision& decision = session.plan(robot, terrain.at(robot));
    tcert_terrain_decision now{};
    now.struct_size = sizeof now;
    ASSERT_EQ(
        TCERT_TERRAIN_OK,
        tcert_terrain_plan(ground, robot.x, robot.y, terrain.at(robot), &now, why, sizeof why))
        << why;
    EXPECT_EQ(decision.row.safe, now.safe_cells);
    EXPECT_EQ(decision.row.travelled, now.travelled);
    ASSERT_EQ(decision.way.size(), now.way_points);
    std::vector<double> way(2 * decision.way.size());
    EXPECT_EQ(decision.way.size(), tcert_terrain_way(ground, way.data(), decision.way.size()));
    for (std::size_t k = 0; k < decision.way.size(); ++k) {
      EXPECT_EQ(decision.way[k], Position(way[2 * k], way[2 * k + 1]));
    }
    EXPECT_EQ(decision.end.has_value(), now.end != TCERT_TERRAIN_GOES_ON);
    if (decision.end) {
      break;
    }
    robot = nearest_cell(decision.way.back());
    EXPECT_EQ(robot, (Cell{now.next_x, now.next_y}));
  }
  std::vector<double> safe(terrain.grid.size());
  EXPECT_EQ(TCERT_TERRAIN_OK, tcert_terrain_layer(ground, TCERT_TERRAIN_SAFE, safe.data()));
  const CellSet& expected = session.explorer()->layers().safe;
  EXPECT_TRUE(std::equal(safe.begin(), safe.end(), expected.begin()));
  EXPECT_EQ(TCERT_TERRAIN_ERROR_INPUT, tcert_terrain_layer(ground, 99, safe.data()));
  tcert_terrain_destroy(ground);
  // A caller who was compiled with a shorter struct keeps what lies beyond it.
  in_c.body_radius = 7.0;
  const tcert_terrain_setup before = in_c;
  EXPECT_EQ(TCERT_TERRAIN_OK,
            tcert_terrain_setup_init_sized(&in_c, offsetof(tcert_terrain_setup, body_radius)));
  EXPECT_EQ(offsetof(tcert_terrain_setup, body_radius), in_c.struct_size);
  EXPECT_EQ(0.0, in_c.lipschitz);
  EXPECT_EQ(before.body_radius, in_c.body_radius);
  EXPECT_EQ(TCERT_TERRAIN_ERROR_VERSION, tcert_terrain_setup_init_sized(&in_c, sizeof in_c + 8));
  in_c = before;
  in_c.struct_size += 8;
  EXPECT_EQ(TCERT_TERRAIN_ERROR_VERSION,
            tcert_terrain_create(&in_c, nullptr, &ground, why, sizeof why));
  tcert_terrain_setup_init(&in_c);
  EXPECT_EQ(TCERT_TERRAIN_ERROR_INPUT,
            tcert_terrain_create(&in_c, nullptr, &ground, why, sizeof why));
  EXPECT_EQ(nullptr, ground);
}

TEST(TerrainInC, RefusesBodiesThatAreNoneAndAllowsForNoise) {
  tcert_terrain_setup setup;
  tcert_terrain_setup_init(&setup);
  setup.rows = setup.columns = 20;
  setup.threshold = 0.0;
  setup.lipschitz = 1.0;
  setup.start_x = setup.start_y = 10;
  tcert_terrain* ground = nullptr;
  char why[200] = "";
  const auto create = [&](const tcert_terrain_setup& s) {
    return tcert_terrain_create(&s, nullptr, &ground, why, sizeof why);
  };
  for (const auto field : {&tcert_terrain_setup::body_radius,
                           &tcert_terrain_setup::body_length,
                           &tcert_terrain_setup::body_width}) {
    tcert_terrain_setup s = setup;
    s.*field = -1.0;
    EXPECT_EQ(TCERT_TERRAIN_ERROR_INPUT, create(s));
    s.*field = 2.0;
    EXPECT_EQ(field == &tcert_terrain_setup::body_radius, create(s) == TCERT_TERRAIN_OK) << why;
    tcert_terrain_destroy(ground);
  }
  const auto safe_with = [&](double noise_sd) {
    tcert_terrain_setup s = setup;
    s.noise_sd = noise_sd;
    EXPECT_EQ(TCERT_TERRAIN_OK, create(s)) << why;
    tcert_terrain_decision now{};
    now.struct_size = sizeof now;
    EXPECT_EQ(TCERT_TERRAIN_OK, tcert_terrain_plan(ground, 10, 10, 5.0, &now, why, sizeof why))
        << why;
    tcert_terrain_destroy(ground);
    return now.safe_cells;
  };
  EXPECT_GT(safe_with(0.0), safe_with(0.3));
}

TEST(TerrainInC, ARobotThatIsThereAlreadyIsToldSo) {
  tcert_terrain_setup setup;
  tcert_terrain_setup_init(&setup);
  setup.rows = setup.columns = 20;
  setup.lipschitz = 1.0;
  setup.start_x = setup.start_y = setup.goal_x = setup.goal_y = 10;
  setup.has_goal = 1;
  tcert_terrain* ground = nullptr;
  ASSERT_EQ(TCERT_TERRAIN_OK, tcert_terrain_create(&setup, nullptr, &ground, nullptr, 0));
  tcert_terrain_decision now{};
  now.struct_size = sizeof now;
  ASSERT_EQ(TCERT_TERRAIN_OK, tcert_terrain_plan(ground, 10, 10, 5.0, &now, nullptr, 0));
  EXPECT_EQ(TCERT_TERRAIN_REACHED, now.end);
  EXPECT_EQ(10, now.next_x);
  EXPECT_EQ(10, now.next_y);
  tcert_terrain_destroy(ground);
}

}  // namespace
}  // namespace tcert::terrain
