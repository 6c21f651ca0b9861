#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

/// A gap of 0.6 m between two discs on the way; the rest is closed by discs that touch.
constexpr const char* kDiscs =
    "world,x_m,y_m,radius_m\n"
    "gap,2,0.35,0.35\ngap,2,1.65,0.35\n"
    "closed,2,0.5,0.5\nclosed,2,1.5,0.5\n"
    "in-goal,3.5,1,0.1\n";

std::vector<std::string> arguments(const char* file, std::vector<std::string> more = {}) {
  std::vector<std::string> all{"world",
                               file,
                               "--start",
                               "0.5,1,0.1",
                               "--goal",
                               "3.5,1,0.1",
                               "--bounds",
                               "0,0,4,2",
                               "--quiet"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(WorldCommand, OneRowAWorldAndABadOneIsNamed) {
  Workdir work(TCERT_BINARY);
  work.write("d.csv", kDiscs);
  const ProcessResult run = work.run(arguments("d.csv", {"--no-curvature", "--format", "json"}));
  EXPECT_EQ(run.exit_code, 3) << to_string(run);
  EXPECT_NE(run.err.find("of world 'in-goal' a goal free of obstacles"), std::string::npos)
      << to_string(run);
  const auto rows = nlohmann::json::parse(run.out)["rows"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["world"], "gap");
  EXPECT_NEAR(rows[0]["T_upper_m"].get<double>(), 0.6 - 0.45, 1e-12);
  EXPECT_NEAR(rows[0]["T_lower_m"].get<double>(), 0.6 - 0.45, 1e-12);
  EXPECT_EQ(rows[0]["connected"], 1);
  EXPECT_EQ(rows[1]["connected"], 0);
  EXPECT_TRUE(rows[1]["T_upper_m"].is_null());  // no path is not 0
}

TEST(WorldCommand, TheSameForAnyNumberOfThreadsAndWithPictures) {
  Workdir work(TCERT_BINARY);
  work.write("d.csv", kDiscs);
  const ProcessResult one = work.run(arguments("d.csv", {"--threads", "1", "--format", "csv"}));
  const ProcessResult two =
      work.run(arguments("d.csv", {"--threads", "2", "--format", "csv", "--picture", "svg"}));
  EXPECT_EQ(one.exit_code, 3) << to_string(one);
  EXPECT_EQ(one.out, two.out);
  EXPECT_EQ(work.read("svg/gap.svg").rfind("<svg", 0), 0U);
  EXPECT_TRUE(std::filesystem::exists(work / "svg/closed.svg"));
  EXPECT_NE(work.run(arguments("d.csv", {"--clearance", "radial", "--format", "csv"})).out,
            one.out);
}

TEST(WorldCommand, RefusesWhatItCannotUse) {
  Workdir work(TCERT_BINARY);
  work.write("bad.map", "type octile\nheight 3\nwidth 2\nmap\n..\n..\n");
  const ProcessResult lies = work.run(arguments("bad.map"));
  EXPECT_EQ(lies.exit_code, 65) << to_string(lies);
  EXPECT_NE(lies.err.find("3 rows, as the header says"), std::string::npos) << to_string(lies);
  EXPECT_EQ(work.run({"world", "nowhere.csv"}).exit_code, 66);
  work.write("d.csv", kDiscs);
  EXPECT_EQ(work.run({"world", "d.csv", "--start", "1,2"}).exit_code, 2);
  EXPECT_EQ(work.run({"world", "d.csv", "--clearance", "widht"}).exit_code, 2);
}

TEST(CertifyTruth, StandsBesideTheCertificate) {
  Workdir work(TCERT_BINARY);
  ASSERT_EQ(work.run({"simulate", "--output", "corpus", "--trials", "3", "--quiet"}).exit_code, 0);
  const ProcessResult run =
      work.run({"certify", "corpus", "--truth", "--format", "json", "--quiet"});
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_NE(run.err.find("Certificates issued in failed trials: 0 of"), std::string::npos)
      << to_string(run);
  const auto rows = nlohmann::json::parse(run.out)["rows"];
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const double lower = std::stod(row["truth_lower_m"].get<std::string>());
    const double upper = std::stod(row["truth_upper_m"].get<std::string>());
    EXPECT_LT(lower, upper);
    EXPECT_GT(upper, std::stod(row["true_margin_m"].get<std::string>()) - 1e-9);
  }
}

}  // namespace
}  // namespace tcert
