#include "datasets/import/column_guess.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tcert::recording {
namespace {

std::string guess(const std::string& name, double largest = 1.0) {
  const ColumnGuess found = guess_column(name, 0.0, largest);
  return std::string(to_string(found.role)) + (found.unit.empty() ? "" : " " + found.unit);
}

TEST(GuessColumn, KnowsTheNamesOfTheTools) {
  EXPECT_EQ(guess("pose.pose.position.x"), "x");
  EXPECT_EQ(guess("ty"), "y");
  EXPECT_EQ(guess("p_RS_R_x [m]"), "x");
  EXPECT_EQ(guess("q_RS_w []"), "quaternion w");
  EXPECT_EQ(guess("orientation.z"), "quaternion z");
  EXPECT_EQ(guess("linear.x"), "speed");
  EXPECT_EQ(guess("angular.z"), "yaw rate");
  EXPECT_EQ(guess("/turtle1/cmd_vel/linear/x"), "speed");
  EXPECT_EQ(guess("left_range_m"), "range");
  EXPECT_EQ(guess("left_mm"), "range mm");
  EXPECT_EQ(guess("x_mm"), "x mm");
}

TEST(GuessColumn, GoesByTheSizeWhereTheNameHasNoUnit) {
  EXPECT_EQ(guess("yaw", 180), "yaw deg");
  EXPECT_EQ(guess("yaw", 3.1), "yaw");
  EXPECT_EQ(guess("bend_left", 40), "bend deg");
  EXPECT_EQ(guess("sonar", 4000), "range mm");
  EXPECT_EQ(guess("fsr_left", 600), "force g");
  EXPECT_EQ(guess("yaw_deg", 3), "yaw deg");
}

TEST(GuessColumn, LeavesTheOthersAlone) {
  for (const char* const name : {"linear.y",
                                 "linear.z",
                                 "force.x",
                                 "torque.y",
                                 "v_RS_R_y [m s^-1]",
                                 "b_w_RS_S_z [rad s^-1]",
                                 "range_min",
                                 "covariance.x",
                                 "V_bat",
                                 "seq",
                                 "frame_id",
                                 ""}) {
    EXPECT_EQ(guess(name), "") << name;
  }
}

}  // namespace
}  // namespace tcert::recording
