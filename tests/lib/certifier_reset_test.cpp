/// A certifier that was reset is a fresh one: in all that it says, after many different trials.
#include <gtest/gtest.h>

#include <cstring>
#include <tcert/bottleneck.hpp>
#include <tcert/certifier.hpp>
#include <tcert/corridor_graph.hpp>

#include "support/random_run.hpp"

namespace tcert {
namespace {

constexpr std::size_t kTicks = 400;

bool alike(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expect_alike(const CertifiedTick& a, const CertifiedTick& b) {
  ASSERT_EQ(a.time_ns, b.time_ns);
  ASSERT_TRUE(alike(a.travel_m, b.travel_m));
  ASSERT_TRUE(alike(a.left_m, b.left_m));
  ASSERT_TRUE(alike(a.right_m, b.right_m));
  ASSERT_TRUE(alike(a.width_m, b.width_m));
  ASSERT_TRUE(alike(a.turn_radius_m, b.turn_radius_m));
  ASSERT_TRUE(alike(a.margin_m, b.margin_m));
  ASSERT_TRUE(alike(a.edge_margin_m, b.edge_margin_m));
  ASSERT_TRUE(alike(a.memory, b.memory));
  ASSERT_TRUE(alike(a.corridor_value_m, b.corridor_value_m));
  ASSERT_TRUE(alike(a.certificate_m, b.certificate_m));
  ASSERT_EQ(a.contacts, b.contacts);
  ASSERT_EQ(a.new_contacts, b.new_contacts);
  ASSERT_EQ(a.nodes, b.nodes);
  ASSERT_EQ(a.edges, b.edges);
  ASSERT_EQ(a.labels_raised, b.labels_raised);
  ASSERT_EQ(a.flags, b.flags);
  ASSERT_EQ(a.issued, b.issued);
}

void expect_alike(const Certifier& a, const Certifier& b) {
  ASSERT_EQ(a.last_node(), b.last_node());
  for (std::size_t k = 0; k < a.ray_margins().size(); ++k) {
    ASSERT_TRUE(alike(a.ray_margins()[k], b.ray_margins()[k]));
  }
  ASSERT_EQ(a.graph().edges().size(), b.graph().edges().size());
  for (std::size_t e = 0; e < a.graph().edges().size(); ++e) {
    const Edge& x = a.graph().edges()[e];
    const Edge& y = b.graph().edges()[e];
    ASSERT_EQ(x.ends, y.ends);
    ASSERT_TRUE(alike(x.pass.margin_m, y.pass.margin_m));
    ASSERT_TRUE(alike(x.certified.margin_m, y.certified.margin_m));
  }
  ASSERT_EQ(a.bottleneck().has_value(), b.bottleneck().has_value());
  if (a.bottleneck()) {
    ASSERT_EQ(a.bottleneck()->edge, b.bottleneck()->edge);
  }
}

void expect_reset_is_fresh(const CertificateParameters& parameters, double min_turn_radius_m) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    test_support::Run first = test_support::random_run(seed, kTicks + 13 * seed);
    test_support::Run second = test_support::random_run(1000 + seed, kTicks);
    first.robot.min_turn_radius_m = second.robot.min_turn_radius_m = min_turn_radius_m;
    Certifier used(first.robot, first.course, parameters);
    for (const Tick& tick : first.ticks) {
      used.update(tick);
    }
    used.reset();
    Certifier fresh(first.robot, first.course, parameters);
    expect_alike(used, fresh);
    for (const Tick& tick : second.ticks) {
      expect_alike(used.update(tick), fresh.update(tick));
      if (testing::Test::HasFatalFailure()) {
        return;
      }
    }
    expect_alike(used, fresh);
  }
}

TEST(CertifierReset, IsAFreshCertifier) { expect_reset_is_fresh({}, 0.35); }

TEST(CertifierReset, IsAFreshCertifierByContacts) {
  CertificateParameters parameters;
  parameters.curvature = CurvatureReading::contact;
  expect_reset_is_fresh(parameters, 0.35);
}

TEST(CertifierReset, IsAFreshCertifierOfARobotThatTurnsOnTheSpot) {
  expect_reset_is_fresh({}, 0.0);
}

TEST(CertifierReset, IsAFreshCertifierOfTheSweptArea) {
  CertificateParameters parameters;
  parameters.clearance = ClearanceReading::swept;
  parameters.max_swept_cells = 1U << 18U;  // less to clear
  expect_reset_is_fresh(parameters, 0.35);
}

TEST(CertifierReset, IsAFreshCertifierThatTakesUnknownSpaceForFree) {
  CertificateParameters parameters;
  parameters.unknown = UnknownSpace::free;
  parameters.max_nodes = 40;  // and runs out of room
  expect_reset_is_fresh(parameters, 0.35);
}

}  // namespace
}  // namespace tcert
