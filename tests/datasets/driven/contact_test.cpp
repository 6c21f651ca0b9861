#include "datasets/driven/contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <table/random.hpp>
#include <vector>

namespace tcert {
namespace {

TEST(NearestAllowed, LeavesWhatNoWallForbids) {
  const std::array<Contact, 1> ahead{{{{-1.0, 0.0}, 0.0}}};
  EXPECT_EQ(nearest_allowed({-0.1, 0.3}, ahead, 100.0), (Point{-0.1, 0.3}));
  EXPECT_EQ(nearest_allowed({0.2, 0.3}, {}, 100.0), (Point{0.2, 0.3}));
}

TEST(NearestAllowed, TakesTheSpeedIntoAWallAndLeavesTheSpeedAlongIt) {
  const std::array<Contact, 1> ahead{{{{-1.0, 0.0}, 0.0}}};
  EXPECT_EQ(nearest_allowed({0.2, 0.3}, ahead, 100.0), (Point{0.0, 0.3}));
}

// 1 mm in 10 ms are 0.1 m/s.
TEST(NearestAllowed, ClosesAGapWithinOneStepAndNoFaster) {
  const std::array<Contact, 1> ahead{{{{-1.0, 0.0}, 0.001}}};
  EXPECT_NEAR(nearest_allowed({0.2, 0.0}, ahead, 100.0).x_m, 0.1, 1e-15);
  EXPECT_EQ(nearest_allowed({0.2, 0.0}, ahead, 0.0), Point{});
}

// Two jaws of a gate that is too narrow: normals 6 degrees off straight sideways, both with a part
// against the way. Forwards nothing is left, backwards everything.
TEST(NearestAllowed, HoldsABodyBetweenTwoJawsAndLetsItBack) {
  const double s = std::sin(0.1);
  const double c = std::cos(0.1);
  const std::array<Contact, 2> jaws{{{{-s, -c}, 0.0}, {{-s, c}, 0.0}}};
  EXPECT_EQ(nearest_allowed({0.2, 0.01}, jaws, 100.0), Point{});
  EXPECT_EQ(nearest_allowed({-0.2, 0.01}, jaws, 100.0), (Point{-0.2, 0.01}));
}

// In the corner of two walls the gaps are closed to both: 1 mm to the right, 2 mm ahead.
TEST(NearestAllowed, EndsInTheCornerOfTwoWalls) {
  const std::array<Contact, 2> corner{{{{-1.0, 0.0}, 0.002}, {{0.0, 1.0}, 0.001}}};
  const Point v = nearest_allowed({0.5, -0.4}, corner, 100.0);
  EXPECT_NEAR(v.x_m, 0.2, 1e-15);
  EXPECT_NEAR(v.y_m, -0.1, 1e-15);
}

/// Dykstra's alternating projections: the nearest point of an intersection of half planes, another
/// way.
Point by_alternating_projections(Point wanted, const std::vector<Contact>& contacts, double hz) {
  std::vector<Point> corrections(contacts.size());
  Point v = wanted;
  for (int round = 0; round < 20'000; ++round) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Point from = v + corrections[i];
      const double lacking = -hz * contacts[i].gap_m - dot(contacts[i].normal, from);
      v = lacking > 0.0 ? from + lacking * contacts[i].normal : from;
      corrections[i] = from - v;
    }
  }
  return v;
}

TEST(NearestAllowed, IsTheNearestPointOfTheIntersection) {
  table::RandomStream random(1, 0x7465'0002, 0);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    std::vector<Contact> contacts(1 + random.below(5));
    for (Contact& contact : contacts) {
      contact = {direction(random.uniform(-3.1, 3.1)), random.uniform(0.0, 0.003)};
    }
    const Point wanted{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
    const double hz = random.below(4) == 0 ? 0.0 : 100.0;
    const Point nearest = nearest_allowed(wanted, contacts, hz);
    for (const Contact& contact : contacts) {
      ASSERT_GE(dot(contact.normal, nearest), -hz * contact.gap_m - 1e-11);
    }
    const Point slow = by_alternating_projections(wanted, contacts, hz);
    EXPECT_NEAR(distance(nearest, wanted), distance(slow, wanted), 1e-5);
  }
}

TEST(NearestAllowed, MirrorsBitForBit) {
  table::RandomStream random(1, 0x7465'0003, 0);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Contact> contacts(1 + random.below(4));
    for (Contact& contact : contacts) {
      contact = {direction(random.uniform(-3.1, 3.1)), random.uniform(0.0, 0.003)};
    }
    const Point wanted{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
    const Point v = nearest_allowed(wanted, contacts, 100.0);
    for (Contact& contact : contacts) {
      contact.normal.y_m = -contact.normal.y_m;
    }
    const Point image = nearest_allowed({wanted.x_m, -wanted.y_m}, contacts, 100.0);
    ASSERT_EQ(image.x_m, v.x_m);
    ASSERT_EQ(image.y_m, -v.y_m);
  }
}

}  // namespace
}  // namespace tcert
