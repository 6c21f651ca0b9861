/// One value too many for every parameter: whatever lies outside of its bounds is refused by its
/// name, and what lies at them is taken.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tcert/fallback.hpp>
#include <tcert/guards.hpp>
#include <tcert/parameters.hpp>
#include <tcert/policy_parameters.hpp>
#include <tcert/risk_field.hpp>
#include <tcert/robot.hpp>
#include <tcert/route_planner.hpp>
#include <tcert/speed_law.hpp>

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What is said of a group; empty if it is taken.
template <class Group>
std::string refusal(const Group& group) {
  try {
    require_fields(group);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

template <class Group>
void expect_bounds() {
  std::size_t fields = 0;
  visit_fields(Group{}, [&](const auto& field, auto member) {
    Group group;
    auto& value = group.*member;
    using Value = std::decay_t<decltype(value)>;
    const std::string name(field.key);
    SCOPED_TRACE(name);
    ++fields;
    EXPECT_EQ(refusal(group), "") << "the default";
    if constexpr (std::is_enum_v<Value>) {
      const auto words = std::count(field.words.begin(), field.words.end(), ' ') + 1;
      value = static_cast<Value>(words - 1);
      EXPECT_EQ(refusal(group), "");
      value = static_cast<Value>(words);
      EXPECT_EQ(refusal(group).rfind(name + " is", 0), 0U);
    } else {
      const auto [low, high, low_allowed] = field.bounds;
      ASSERT_LT(low, high);
      ASSERT_TRUE(std::isfinite(low) && std::isfinite(high));
      const auto said = [&](double number) {
        value = static_cast<Value>(number);
        return refusal(group);
      };
      EXPECT_EQ(said(high), "");
      EXPECT_EQ(said(low) == "", low_allowed);
      if constexpr (std::is_floating_point_v<Value>) {
        for (const double wrong : {std::nextafter(low, -kInfinity),
                                   std::nextafter(high, kInfinity),
                                   kInfinity,
                                   -kInfinity,
                                   std::nan("")}) {
          EXPECT_EQ(said(wrong).rfind(name + " is", 0), 0U) << wrong << ": " << refusal(group);
        }
      } else {
        EXPECT_EQ(said(high + 1.0).rfind(name + " is", 0), 0U);
        EXPECT_EQ(low < 1.0 || said(low - 1.0).rfind(name + " is", 0) == 0, true);
      }
    }
  });
  EXPECT_GT(fields, 1U);
}

TEST(ParameterBounds, AreThoseThatAreDeclared) {
  expect_bounds<CertificateParameters>();
  expect_bounds<Robot>();
  expect_bounds<SpeedLaw>();
  expect_bounds<GuardParameters>();
  expect_bounds<RouteParameters>();
  expect_bounds<RiskParameters>();
  expect_bounds<FallbackParameters>();
  expect_bounds<policies::PolicyParameters>();
}

/// What bounds memory and work is a ratio of two parameters.
struct Ratio {
  double CertificateParameters::*larger;
  double CertificateParameters::*smaller;
  double most;
  ClearanceReading clearance = ClearanceReading::width;
};

TEST(ParameterBounds, BoundRatiosToo) {
  for (const Ratio& ratio :
       {Ratio{
            &CertificateParameters::side_window_m, &CertificateParameters::travel_deadband_m, 1e5},
        Ratio{&CertificateParameters::curvature_window_m,
              &CertificateParameters::travel_deadband_m,
              1e5},
        Ratio{&CertificateParameters::swept_lag_m, &CertificateParameters::travel_deadband_m, 1e5},
        Ratio{&CertificateParameters::memory_sigma_m, &CertificateParameters::memory_cell_m, 32.0},
        Ratio{&CertificateParameters::least_obstacle_m,
              &CertificateParameters::swept_cell_m,
              500.0,
              ClearanceReading::swept}}) {
    CertificateParameters p;
    p.clearance = ratio.clearance;
    p.*ratio.smaller = 0.0625;  // a power of two: the products are exact
    p.curvature_min_travel_m = 0.0625;
    p.*ratio.larger = ratio.most * 0.0625;
    EXPECT_NO_THROW(validate(p));
    p.*ratio.larger = std::nextafter(ratio.most * 0.0625, kInfinity);
    EXPECT_THROW(validate(p), std::invalid_argument);
  }
}

TEST(ParameterBounds, BoundTheBodyAndTheRaysInCells) {
  Robot robot;
  robot.rays = {{"left", {0.3, 0.4}, 1.57, 2.0, RayKind::range, {}}};
  const auto is_taken = [&](const CertificateParameters& p) {
    try {
      validate(robot, p);
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  };
  CertificateParameters p;
  EXPECT_TRUE(is_taken(p));
  p.memory_cell_m = 0.0625;
  robot.body_width_m = 256.0 * 0.0625;
  EXPECT_TRUE(is_taken(p));
  robot.body_width_m = 256.01 * 0.0625;
  EXPECT_FALSE(is_taken(p));
  p = {};
  robot.body_width_m = 0.45;
  p.travel_deadband_m = 0.44 / 1e5;  // 102,272 of them in a body
  p.side_window_m = 0.1;
  p.curvature_window_m = 0.2;
  p.swept_lag_m = 0.2;
  EXPECT_FALSE(is_taken(p));
  p.travel_deadband_m = 0.46 / 1e5;
  EXPECT_TRUE(is_taken(p));
  // Mount and reach together are 2.5 m.
  p = {};
  p.clearance = ClearanceReading::swept;
  p.least_obstacle_m = 0.01;
  p.swept_cell_m = 2.51 / 5000.0;
  EXPECT_TRUE(is_taken(p));
  p.swept_cell_m = 2.49 / 5000.0;
  EXPECT_FALSE(is_taken(p));
  p.clearance = ClearanceReading::width;
  EXPECT_TRUE(is_taken(p)) << "no cells, no bound";
  robot.rays.clear();
  robot.body_width_m = 5.0;
  p = {};
  p.clearance = ClearanceReading::swept;
  p.least_obstacle_m = 0.01;
  p.swept_cell_m = 0.00101;
  EXPECT_TRUE(is_taken(p));
  p.swept_cell_m = 0.00099;
  EXPECT_FALSE(is_taken(p));
}

TEST(ParameterBounds, RefuseAWindowThatIsNeverReached) {
  CertificateParameters p;
  const auto expect_limit = [&](double CertificateParameters::*length,
                                double CertificateParameters::*window) {
    p.*length = p.*window;
    EXPECT_NO_THROW(validate(p));
    p.*length = std::nextafter(p.*window, kInfinity);
    EXPECT_THROW(validate(p), std::invalid_argument);
  };
  expect_limit(&CertificateParameters::curvature_min_travel_m,
               &CertificateParameters::curvature_window_m);
  p.curvature = CurvatureReading::contact;
  EXPECT_NO_THROW(validate(p)) << "then that window is not looked at";
  expect_limit(&CertificateParameters::contact_spacing_m, &CertificateParameters::contact_window_m);
  p.curvature = CurvatureReading::contact_literal;
  EXPECT_NO_THROW(validate(p));
  expect_limit(&CertificateParameters::contact_literal_spacing_m,
               &CertificateParameters::contact_window_m);
  p = {};
  p.contact_off_n = p.contact_on_n;
  EXPECT_NO_THROW(validate(p));
  p.contact_off_n = std::nextafter(p.contact_on_n, kInfinity);
  EXPECT_THROW(validate(p), std::invalid_argument);
}

}  // namespace
}  // namespace tcert
