#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <tcert/contact_curvature.hpp>

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

CertificateParameters reading(CurvatureReading curvature) {
  CertificateParameters parameters;
  parameters.curvature = curvature;
  return parameters;
}

// The robot drives counter-clockwise on a circle of 1 m about the origin; at angle a its left
// points to the centre. A wall of radius `wall_m` is felt at lateral distance 1 - wall_m.
Contact felt_at(double a, double wall_m, double travel_m) {
  const Point out{std::cos(a), std::sin(a)};
  return {wall_m * out, 1.0 - wall_m, -1.0 * out, travel_m};
}

TEST(CircleThrough, FindsCentreAndRadius) {
  const CircleFit fit = circle_through({3.0, 1.0}, {1.0, 3.0}, {-1.0, 1.0});
  EXPECT_NEAR(fit.radius_m, 2.0, 1e-15);
  EXPECT_NEAR(fit.centre.x_m, 1.0, 1e-15);
  EXPECT_NEAR(fit.centre.y_m, 1.0, 1e-15);
  EXPECT_NEAR(fit.longest_m, 4.0, 1e-15);
  EXPECT_NEAR(fit.height_m, 2.0, 1e-15);
}

TEST(CircleThrough, IsInfiniteForCollinearPoints) {
  EXPECT_EQ(circle_through({0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}).radius_m, kInfinity);
  const CircleFit point = circle_through({1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0});
  EXPECT_EQ(point.radius_m, kInfinity);
  EXPECT_EQ(point.height_m, 0.0);
}

TEST(PathRadiusAlong, AddsTheLateralDistanceToAWallOnTheInside) {
  const std::array<Contact, 3> triple{
      felt_at(0.0, 0.6, 0.0), felt_at(0.4, 0.6, 0.4), felt_at(0.8, 0.6, 0.8)};
  EXPECT_NEAR(path_radius_along(triple, reading(CurvatureReading::contact)), 1.0, 1e-12);
  EXPECT_NEAR(path_radius_along(triple, reading(CurvatureReading::contact_literal)), 0.6, 1e-12);
}

TEST(PathRadiusAlong, SubtractsTheLateralDistanceToAWallOnTheOutside) {
  const std::array<Contact, 3> triple{
      felt_at(0.0, 1.5, 0.0), felt_at(0.4, 1.5, 0.4), felt_at(0.8, 1.5, 0.8)};
  EXPECT_NEAR(path_radius_along(triple, reading(CurvatureReading::contact)), 1.0, 1e-12);
  EXPECT_NEAR(path_radius_along(triple, reading(CurvatureReading::contact_literal)), 1.5, 1e-12);
}

TEST(PathRadiusAlong, DoesNotReadARadiusOutOfNoiseOnAStraightWall) {
  // Height 5 mm on 0.4 m: above 2 % of the longest side never, below 3 sigma = 9 mm.
  const std::array<Contact, 3> triple{Contact{{0.0, 0.5}, 0.5, {0.0, 1.0}, 0.0},
                                      Contact{{0.2, 0.505}, 0.5, {0.0, 1.0}, 0.2},
                                      Contact{{0.4, 0.5}, 0.5, {0.0, 1.0}, 0.4}};
  EXPECT_EQ(path_radius_along(triple, reading(CurvatureReading::contact)), kInfinity);
}

TEST(ContactCurvature, KeepsThePathEstimateUntilThreeContactsAreApart) {
  ContactCurvature contacts(1, reading(CurvatureReading::contact));
  contacts.add(0, felt_at(0.0, 0.6, 0.0));
  contacts.add(0, felt_at(0.1, 0.6, 0.1));  // 6 cm along the wall: too near, passed over
  contacts.add(0, felt_at(0.4, 0.6, 0.4));
  EXPECT_EQ(contacts.radius(0.4, 1.3), 1.3);
  contacts.add(0, felt_at(0.8, 0.6, 0.8));
  EXPECT_NEAR(contacts.radius(0.8, 1.3), 1.0, 1e-12);
  EXPECT_EQ(contacts.radius(0.8, 0.9), 0.9);   // the smaller is kept
  EXPECT_EQ(contacts.radius(0.8, 2.1), 2.1);   // more than a factor 2 off: a kink of the wall
  EXPECT_EQ(contacts.radius(1.01, 1.3), 1.3);  // the first contact left the window
}

// A fourth contact takes the place of the first: the wall has become tighter since.
TEST(ContactCurvature, FollowsTheLastThreeContacts) {
  ContactCurvature contacts(1, reading(CurvatureReading::contact));
  for (const double a : {0.0, 0.3, 0.6}) {
    contacts.add(0, felt_at(a, 0.6, a));
  }
  EXPECT_NEAR(contacts.radius(0.6, 1.3), 1.0, 1e-12);
  const std::array<Contact, 3> last{
      felt_at(0.3, 0.6, 0.3), felt_at(0.6, 0.6, 0.6), felt_at(0.9, 0.5, 0.9)};
  contacts.add(0, last[2]);
  const double expected_m = path_radius_along(last, reading(CurvatureReading::contact));
  EXPECT_LT(expected_m, 0.9);
  EXPECT_EQ(contacts.radius(0.9, 1.2), expected_m);
  EXPECT_EQ(contacts.radius(1.31, 1.3), 1.3) << "1.01 m after the first of them";
  contacts.clear();
  EXPECT_EQ(contacts.radius(0.9, 1.3), 1.3);
}

// Share of ticks with a turn radius below R_min while driving straight along a straight wall that
// is felt with 6 mm of noise.
double share_read_as_tight(CurvatureReading curvature) {
  std::mt19937 engine(5);
  const auto noise_m = [&engine] {
    double sum = 0.0;
    for (int k = 0; k < 12; ++k) {
      sum += static_cast<double>(engine()) / 4294967296.0;
    }
    return 0.006 * (sum - 6.0);
  };
  ContactCurvature contacts(1, reading(curvature));
  int tight = 0;
  for (int k = 0; k < 10'000; ++k) {
    const double x_m = 0.017 * k;
    const double wall_m = 0.4 + noise_m();
    contacts.add(0, {{x_m, wall_m}, wall_m, {0.0, 1.0}, x_m});
    tight += contacts.radius(x_m, 1000.0) < 0.35 ? 1 : 0;
  }
  return tight / 10'000.0;
}

TEST(ContactCurvature, TheLiteralReadingTakesNoiseOnAStraightWallForTightCurves) {
  EXPECT_GT(share_read_as_tight(CurvatureReading::contact_literal), 0.10);
  EXPECT_EQ(share_read_as_tight(CurvatureReading::contact), 0.0);
}

}  // namespace
}  // namespace tcert
