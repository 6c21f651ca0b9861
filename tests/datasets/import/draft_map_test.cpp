#include "datasets/import/draft_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/import/csv_survey.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

DraftedMap draft_of(const std::string& header, const std::string& row, const std::string& next) {
  test_support::TemporaryFolder folder;
  folder.write("run1.csv", header + '\n' + row + '\n' + next + '\n');
  folder.write("run2.csv", header + '\n' + row + '\n' + next + '\n');
  table::DiagnosticGroups problems;
  return draft_map(survey_csv(folder.path(), false, "", problems));
}

TEST(DraftMapTest, EveryNullThatIsLeftIsNamed) {
  const DraftedMap drafted =
      draft_of("time_s,x_m,y_m,yaw_rad,left_range_m", "0,0,0,0,0.5", "0.1,0.1,0,0,0.6");
  const auto map = nlohmann::json::parse(drafted.text);
  EXPECT_EQ(map["pose"]["x_m"], "x_m");
  EXPECT_TRUE(map["rays"]["rays"][0]["mount_y_m"].is_null());
  EXPECT_THAT(drafted.remarks.front(),
              HasSubstr("robot.body_width_m, course.start.disc.{x_m, y_m}, "
                        "course.goal.disc.{x_m, y_m}, "
                        "rays.rays.left.{mount_x_m, mount_y_m, bearing_deg, reach_m} ("));
}

/// Names in another language: what is known by an x, a y and a unit of time is drafted, the other
/// columns are named.
TEST(DraftMapTest, NamesThatAreNotKnownLeaveAMapWithWhatIs) {
  const DraftedMap drafted = draft_of("zeit_ms,x_mm,y_mm,kurs_grad,links_mm",
                                      "1700000000000,0,0,1,250",
                                      "1700000000100,10,0,2,260");
  const auto map = nlohmann::json::parse(drafted.text);
  EXPECT_EQ(map["pose"]["time"], (nlohmann::json{{"column", "zeit_ms"}, {"unit", "ms"}}));
  EXPECT_EQ(map["pose"]["x_m"], (nlohmann::json{{"column", "x_mm"}, {"unit", "mm"}}));
  EXPECT_TRUE(map["pose"]["yaw_rad"].is_null());
  EXPECT_THAT(drafted.remarks,
              ElementsAre(HasSubstr("pose.yaw_rad"),
                          HasSubstr("no column is called as a heading"),
                          HasSubstr("no column is a range or a bend"),
                          HasSubstr("measured in 'kurs_grad', 'links_mm' is not known"),
                          HasSubstr("no table of outcomes")));
}

}  // namespace
}  // namespace tcert::recording
