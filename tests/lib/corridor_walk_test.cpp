#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <tcert/corridor_walk.hpp>

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAbout = std::numbers::pi;

// Walks along straight pieces in steps of 1 cm. S is x < 0.1, G is x > 2.9.
class Walker {
 public:
  explicit Walker(CertificateParameters parameters = {}, Robot robot = {}, double side_m = 0.5)
      : walk_(robot, parameters), side_m_(side_m) {}

  Walker& begin(double x, double y, double yaw = 0.0) {
    walk_.begin(evidence(x, y, yaw, 0.5), !(x < 0.1));
    x_ = x;
    y_ = y;
    return *this;
  }
  // To (x, y) with a fixed yaw, feeling `margin_m` on the way.
  Walker& to(double x, double y, double yaw, double margin_m = 0.5) {
    const double from_x = x_, from_y = y_;
    const int steps = static_cast<int>(std::ceil(std::hypot(x - x_, y - y_) / 0.01 - 1e-9));
    for (int k = 1; k <= steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      step(from_x + share * (x - from_x), from_y + share * (y - from_y), yaw, margin_m);
    }
    return *this;
  }
  Walker& step(double x, double y, double yaw, double margin_m = 0.5) {
    travel_m_ += std::hypot(x - x_, y - y_);
    x_ = x;
    y_ = y;
    walk_.advance(evidence(x, y, yaw, margin_m));
    return *this;
  }
  Walker& jump(double x, double y, double yaw, double bridge_m = -kInfinity) {
    x_ = x;
    y_ = y;
    walk_.advance_after_break(evidence(x, y, yaw, 0.5), bridge_m);
    return *this;
  }
  CorridorWalk& walk() { return walk_; }
  std::size_t nodes() { return walk_.graph().nodes().size(); }
  std::size_t edges() { return walk_.graph().edges().size(); }
  const Edge& edge(std::size_t e) { return walk_.graph().edges()[e]; }

 private:
  Evidence evidence(double x, double y, double yaw, double margin_m) const {
    return {{{x, y}, yaw},
            direction(yaw),
            travel_m_,
            margin_m,
            side_m_,
            side_m_,
            1.0,
            1000.0,
            0.0,
            x<0.1, x> 2.9};
  }
  CorridorWalk walk_;
  double side_m_;
  double x_ = 0.0;
  double y_ = 0.0;
  double travel_m_ = 0.0;
};

TEST(CorridorWalk, LaysANodeEachEdgeLength) {
  Walker walker;
  walker.begin(0.0, 0.0).to(0.80, 0.0, 0.0);
  ASSERT_EQ(walker.nodes(), 4U);  // 0, 0.25, 0.50, 0.75
  EXPECT_EQ(walker.edges(), 3U);
  EXPECT_NEAR(walker.walk().graph().nodes()[2].pose.position.x_m, 0.50, 0.011);
  EXPECT_EQ(walker.edge(0).ends[0], (EdgeEnd{0, Side::front}));
  EXPECT_EQ(walker.edge(0).ends[1], (EdgeEnd{1, Side::back}));
  EXPECT_EQ(walker.walk().certificate_m(), -kInfinity);
}

TEST(CorridorWalk, ValueIsTheSmallestMarginUpToHere) {
  Walker walker;
  walker.begin(0.0, 0.0).to(0.30, 0.0, 0.0, 0.4);
  EXPECT_EQ(walker.walk().corridor_value_m(), 0.4);
  walker.to(0.35, 0.0, 0.0, 0.1);
  EXPECT_EQ(walker.walk().corridor_value_m(), 0.1);  // pending
  EXPECT_EQ(walker.walk().reached_m(), 0.4);
  walker.to(0.80, 0.0, 0.0, 0.6);
  EXPECT_EQ(walker.walk().corridor_value_m(), 0.1);
}

TEST(CorridorWalk, ConnectsAtTheFirstEntryOfG) {
  Walker walker;
  walker.begin(0.0, 0.0).to(1.0, 0.0, 0.0, 0.5).to(1.2, 0.0, 0.0, 0.2).to(2.90, 0.0, 0.0, 0.4);
  EXPECT_EQ(walker.walk().certificate_m(), -kInfinity);
  walker.step(2.91, 0.0, 0.0, 0.3);
  EXPECT_EQ(walker.walk().certificate_m(), 0.2);
  EXPECT_TRUE(walker.walk().graph().nodes().back().in_goal);
}

TEST(CorridorWalk, ClosesWhereThePathCrossesAKnownNode) {
  Walker walker;
  walker.begin(0.0, 0.0).to(1.0, 0.0, 0.0);
  const std::size_t nodes = walker.nodes();
  // Round a lobe and back over the lane near x = 0.5, heading the other way, 10 cm aside.
  walker.to(1.2, 0.8, 0.5 * kAbout).to(0.6, 0.8, kAbout).to(0.6, 0.1, -0.5 * kAbout);
  const std::size_t after_lobe = walker.nodes();
  EXPECT_GT(after_lobe, nodes);
  walker.to(0.40, 0.1, kAbout, 0.3);
  const auto edges = walker.walk().graph().edges();
  const Edge& closing = edges.back();
  EXPECT_EQ(closing.ends[1], (EdgeEnd{2, Side::front}));  // entered by its front
  EXPECT_EQ(closing.pass.margin_m, 0.3);
  // Going on it leaves node 2 by its back, and closes at node 1 on the edge that is there.
  const std::size_t edges_before = walker.edges();
  walker.to(0.20, 0.1, kAbout, 0.7);
  EXPECT_EQ(walker.edges(), edges_before);
}

// The same lobe: T_t is charged the turn from one lane to the other, V_t and the margin felt not.
TEST(CorridorWalk, ChangingLanesAsksForATurn) {
  Walker walker;
  walker.begin(0.0, 0.0).to(1.0, 0.0, 0.0).to(1.2, 0.8, 0.5 * kAbout).to(0.6, 0.8, kAbout);
  walker.to(0.6, 0.1, -0.5 * kAbout).to(0.40, 0.1, kAbout);
  const Edge& closing = walker.walk().graph().edges().back();
  EXPECT_EQ(closing.pass.margin_m, 0.5);
  // Two parabolas of 0.25 m each: 0.1 m aside asks for 4 * 0.1 / 0.5^2 = 1.6 / m.
  const double radius_m = 1.0 / (1.6 + 0.001);  // on top of the path's own
  EXPECT_NEAR(closing.certified.turn_radius_m, radius_m, 1e-9);
  EXPECT_NEAR(closing.certified.margin_m, radius_m - Robot{}.min_turn_radius_m, 1e-9);
  CertificateParameters no_turns;
  no_turns.curvature = CurvatureReading::none;
  Walker free(no_turns);
  free.begin(0.0, 0.0).to(1.0, 0.0, 0.0).to(1.2, 0.8, 0.5 * kAbout).to(0.6, 0.8, kAbout);
  free.to(0.6, 0.1, -0.5 * kAbout).to(0.40, 0.1, kAbout);
  EXPECT_EQ(free.walk().graph().edges().back().certified.margin_m, 0.5);
}

// A narrow robot drives two lanes with a wall between them, 10 cm apart.
TEST(CorridorWalk, LanesWithAWallBetweenThemDoNotJoin) {
  Robot narrow;
  narrow.body_width_m = 0.12;
  for (const auto& [side_m, edges] : {std::pair{0.07, 3U}, std::pair{0.17, 4U}}) {
    Walker walker({}, narrow, side_m);
    walker.begin(0.0, 0.0).to(0.6, 0.0, 0.0).to(0.6, 0.1, 0.5 * kAbout);
    walker.to(0.35, 0.1, kAbout);
    EXPECT_EQ(walker.edges(), edges) << side_m;
  }
}

// Down a dead end, round on the spot, and back over the last node into another lane.
// A turn on the spot is a path of radius 0, so its margin is at most 0.
TEST(CorridorWalk, OnlyARobotThatTurnsOnTheSpotMayTurnAtANode) {
  for (const double radius_m : {0.0, 0.01}) {
    Robot robot;
    robot.min_turn_radius_m = radius_m;
    Walker walker({}, robot);
    walker.begin(0.0, 0.0).to(0.55, 0.0, 0.0, 0.3).to(0.45, 0.0, kAbout, 0.4);
    walker.to(0.45, 0.40, 0.5 * kAbout).to(2.95, 0.40, 0.0);
    EXPECT_EQ(walker.walk().certificate_m(), radius_m > 0.0 ? -kInfinity : 0.0) << radius_m;
  }
}

TEST(CorridorWalk, ASecondPassCanOnlyRaiseAMargin) {
  CertificateParameters parameters;
  Walker walker(parameters);
  walker.begin(0.0, 0.0).to(0.26, 0.0, 0.0, 0.5).to(0.51, 0.0, 0.0, 0.2).to(0.60, 0.0, 0.0, 0.5);
  EXPECT_EQ(walker.edge(1).pass.margin_m, 0.2);
  // Back over both nodes: the same edge, felt wider this time.
  walker.to(0.10, 0.0, 0.0, 0.35);
  EXPECT_EQ(walker.edge(1).pass.margin_m, 0.35);
  EXPECT_EQ(walker.edge(0).pass.margin_m, 0.5);
}

TEST(CorridorWalk, TurningBackLaysANodeThatIsLeftByTheSideItWasEnteredBy) {
  Walker walker;
  walker.begin(0.0, 0.0).to(0.35, 0.0, 0.0, 0.5).to(0.40, 0.0, 0.0, 0.1);
  ASSERT_EQ(walker.nodes(), 2U);
  walker.to(0.36, 0.0, 0.0);  // 4 cm back: not yet
  EXPECT_EQ(walker.nodes(), 2U);
  walker.to(0.345, 0.0, 0.0);
  ASSERT_EQ(walker.nodes(), 3U);
  EXPECT_EQ(walker.edge(1).ends[1], (EdgeEnd{2, Side::back}));
  EXPECT_EQ(walker.edge(1).pass.margin_m, 0.1);  // what was felt at the far end is kept
  // The way back to node 1 is a pass along the same edge; the throat lies beyond node 2.
  walker.to(0.20, 0.0, 0.0, 0.3);
  EXPECT_EQ(walker.edges(), 2U);
  EXPECT_EQ(walker.edge(1).pass.margin_m, 0.3);
  // Forward again, it is walked anew, and whatever lies beyond must be felt again.
  walker.to(0.50, 0.0, 0.0, 0.1);
  EXPECT_EQ(walker.edge(1).pass.margin_m, 0.3);
  EXPECT_EQ(walker.walk().corridor_value_m(), 0.1);
}

TEST(CorridorWalk, CreepingBackAndForthThroughAGateDoesNotEraseIt) {
  Walker walker;
  walker.begin(0.0, 0.0).to(0.30, 0.0, 0.0, 0.5);
  for (int k = 0; k < 5; ++k) {
    walker.to(0.38, 0.0, 0.0, 0.05).to(0.29, 0.0, 0.0, 0.05);
  }
  walker.to(1.0, 0.0, 0.0, 0.05).to(2.95, 0.0, 0.0, 0.5);
  EXPECT_EQ(walker.walk().certificate_m(), 0.05);
}

TEST(CorridorWalk, CrossingTheLastNodeRestartsThePendingEdge) {
  Walker walker;
  walker.begin(0.0, 0.0).to(0.26, 0.0, 0.0);
  walker.to(0.28, 0.0, 0.0, 0.1);
  EXPECT_EQ(walker.walk().edge_margin_m(), 0.1);
  walker.to(0.235, 0.0, 0.0, 0.4);  // 4.5 cm back, over the node at 0.25
  EXPECT_EQ(walker.walk().edge_margin_m(), 0.4);
  EXPECT_EQ(walker.nodes(), 2U);
}

TEST(CorridorWalk, LanesThatCrossAtAnAngleDoNotJoin) {
  Walker walker;
  walker.begin(0.0, 0.0).to(1.0, 0.0, 0.0).to(1.0, 0.5, 0.5 * kAbout);
  const std::size_t edges = walker.edges();
  // Straight down through the first lane at right angles.
  walker.to(0.5, 0.5, kAbout);
  const std::size_t before = walker.edges();
  walker.to(0.5, -0.5, -0.5 * kAbout);
  for (std::size_t e = before; e < walker.edges(); ++e) {
    EXPECT_GT(walker.edge(e).ends[1].node, 4U) << "closed at a node of the first lane";
  }
  EXPECT_GT(walker.edges(), edges);
}

TEST(CorridorWalk, ABreakStartsANewComponentAndVGoesOn) {
  Walker walker;
  walker.begin(0.0, 0.0).to(0.30, 0.0, 0.0, 0.2);
  walker.jump(1.0, 0.0, 0.0);
  EXPECT_EQ(walker.walk().corridor_value_m(), 0.2);
  walker.to(2.95, 0.0, 0.0, 0.5);
  EXPECT_EQ(walker.walk().corridor_value_m(), 0.2);
  EXPECT_EQ(walker.walk().certificate_m(), -kInfinity);
}

TEST(CorridorWalk, ABridgedBreakConnects) {
  Walker walker;
  walker.begin(0.0, 0.0).to(0.30, 0.0, 0.0, 0.5);
  walker.jump(1.0, 0.0, 0.0, 0.15).to(2.95, 0.0, 0.0, 0.5);
  EXPECT_EQ(walker.walk().certificate_m(), 0.15);
}

TEST(CorridorWalk, StartingOutsideSNeverGivesAValue) {
  Walker walker;
  walker.begin(0.5, 0.0).to(0.0, 0.0, kAbout).to(2.95, 0.3, 0.0);
  EXPECT_EQ(walker.walk().corridor_value_m(), -kInfinity);
  EXPECT_EQ(walker.walk().certificate_m(), -kInfinity);
}

TEST(CorridorWalk, AFullGraphIgnoresNewEvidenceAndSaysSo) {
  for (const auto& [max_nodes, max_edges] : {std::pair{5U, 100U}, std::pair{100U, 5U}}) {
    CertificateParameters parameters;
    parameters.max_nodes = max_nodes;
    parameters.max_edges = max_edges;
    Walker walker(parameters);
    walker.begin(0.0, 0.0).to(1.0, 0.0, 0.0, 0.4);
    EXPECT_FALSE(walker.walk().capacity_exceeded());
    walker.to(2.95, 0.0, 0.0, 0.3);
    EXPECT_TRUE(walker.walk().capacity_exceeded());
    EXPECT_EQ(walker.walk().certificate_m(), -kInfinity);
    EXPECT_EQ(walker.walk().corridor_value_m(), 0.3);
  }
}

}  // namespace
}  // namespace tcert
