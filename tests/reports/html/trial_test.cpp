#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reports/html/trial_block.hpp"
#include "reports/html/trial_list.hpp"
#include "tests/reports/html/unpacked.hpp"

namespace tcert {
namespace {

using Json = nlohmann::json;

/// 300 ticks of 0.1 s at 0.2 m/s along x; T_t of 0.05 m from tick 200 on.
std::string series_csv(double start_s = 0.0) {
  std::string text =
      "time_s,x_m,y_m,yaw_rad,travel_m,left_m,right_m,width_m,margin_m,edge_margin_m,memory,"
      "corridor_value_m,certificate_m,speed_law_mps,contacts,issued\n";
  for (int i = 0; i < 300; ++i) {
    const std::string x = std::to_string(0.02 * i);
    const std::string margin = i == 77 ? "-0.31" : "0.2";
    text += std::to_string(start_s + 0.1 * i) + "," + x + ",1.5,0," + x + ",0.4,0.3,0.7," + margin +
            ",0.2,0," + "0.1," + (i >= 200 ? "0.05" : "") + ",0.18,0," + (i >= 200 ? "1" : "0") +
            "\n";
  }
  return text;
}

table::NumberTable series(double start_s = 0.0) {
  std::string problem;
  auto table = read_page_series(table::Bytes::copy_of(series_csv(start_s)), "t.csv", problem);
  EXPECT_TRUE(table) << problem;
  return std::move(table.value());
}

/// What the page's scripts make of a column.
std::vector<std::optional<double>> decoded(const Json& column) {
  std::vector<std::optional<double>> values;
  long long sum = 0;
  for (const Json& step : column["steps"]) {
    if (step.is_null()) {
      values.emplace_back();
    } else {
      sum += step.get<long long>();
      values.emplace_back(static_cast<double>(sum) / column["scale"].get<double>());
    }
  }
  return values;
}

TEST(TrialBlock, CarriesEveryTickOfAShortTrial) {
  const Json json = Json::parse(unpacked(trial_block(series(), {}, "facts", 300)));
  EXPECT_EQ(json["ticks"], 300);
  EXPECT_EQ(json["facts"], "facts");
  const auto time = decoded(json["series"]["time_s"]);
  const auto certificate = decoded(json["series"]["certificate_m"]);
  const auto margin = decoded(json["series"]["margin_m"]);
  const auto speed = decoded(json["series"]["speed_mps"]);
  ASSERT_EQ(time.size(), 300U);
  for (std::size_t i = 0; i < 300; ++i) {
    EXPECT_NEAR(time[i].value(), 0.1 * static_cast<double>(i), 0.0005);
    EXPECT_EQ(certificate[i].has_value(), i >= 200);
    EXPECT_NEAR(margin[i].value(), i == 77 ? -0.31 : 0.2, 0.00005);
  }
  EXPECT_FALSE(speed[0]);  // Nothing to compare with.
  EXPECT_NEAR(speed[299].value(), 0.2, 0.0005);
  EXPECT_FALSE(json["series"].contains("gated_speed_mps"));
}

TEST(TrialBlock, CountsTimeFromTheFirstTick) {
  const Json json = Json::parse(unpacked(trial_block(series(1.7e9), {}, "facts", 300)));
  const auto time = decoded(json["series"]["time_s"]);
  ASSERT_EQ(time.size(), 300U);
  EXPECT_EQ(time[0], 0.0);
  EXPECT_NEAR(time[299].value(), 29.9, 0.0015);
}

TEST(TrialBlock, OfALongTrialTheDipAndTheIssuanceStay) {
  const Json json = Json::parse(unpacked(trial_block(series(), {}, "", 40)));
  const auto time = decoded(json["series"]["time_s"]);
  const auto margin = decoded(json["series"]["margin_m"]);
  EXPECT_LE(time.size(), 40U);
  EXPECT_EQ(json["ticks"], 300);
  bool dip = false;
  bool issuance = false;
  for (std::size_t i = 0; i < time.size(); ++i) {
    dip = dip || margin[i] == -0.31;
    issuance = issuance || std::abs(time[i].value() - 20.0) < 0.001;
  }
  EXPECT_TRUE(dip);
  EXPECT_TRUE(issuance);
  EXPECT_NEAR(json["map"]["issued"]["x"].get<double>(), 4.0, 0.001);
}

TEST(TrialBlock, ShowsWhatWasFeltWhereNoWallsAreKnown) {
  TrialMap map;
  map.edges = {{{0, 0}, {1, 0}, 0.25}, {{1, 0}, {2, 0}, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_FALSE(Json::parse(unpacked(trial_block(series(), map, "", 300)))["map"].contains("beams"));
  map.felt = true;
  const Json json = Json::parse(unpacked(trial_block(series(), map, "", 300)))["map"];
  ASSERT_EQ(json["beams"].size(), 600U);
  EXPECT_EQ(json["beams"][0], Json({0.0, 1.9}));
  EXPECT_EQ(json["beams"][1], Json({0.0, 1.2}));
  EXPECT_EQ(json["edges"][0], Json({0.0, 0.0, 1.0, 0.0, 0.25}));
  EXPECT_EQ(json["edges"][1][4], nullptr);
}

TEST(TrialBlock, NamesTheFileAndLineOfABadSeries) {
  std::string problem;
  std::string text = series_csv();
  text.replace(text.find("0.020000,"), 4, "oops");
  EXPECT_FALSE(read_page_series(table::Bytes::copy_of(text), "series/t.csv", problem));
  EXPECT_NE(problem.find("series/t.csv:3"), std::string::npos) << problem;
}

table::TextTable table(std::vector<std::string> columns, std::vector<std::string> cells) {
  table::TextTable result;
  result.columns = std::move(columns);
  result.cells = std::move(cells);
  for (std::size_t i = 0; i < result.cells.size() / result.columns.size(); ++i) {
    result.lines.push_back(i + 2);
  }
  return result;
}

TEST(TrialListing, JoinsFeaturesAndCertificatesByTrial) {
  const TrialList trials(table({"trial_id", "algorithm", "success", "time_s"},
                               {"007", "M1", "1", "59.05", "b", "", "0", "8"}),
                         table({"trial_id", "issued", "issued_s", "certificate_m"},
                               {"b", "0", "", "", "007", "1", "58.9", "0.054"}));
  ASSERT_EQ(trials.size(), 2U);
  EXPECT_EQ(trials.id(0), "007");
  EXPECT_EQ(trials.cell(0, "issued_s"), "58.9");
  EXPECT_TRUE(std::isnan(trials.number(1, "certificate_m")));
  EXPECT_EQ(trials.facts(0), "M1: success after 59.0 s. Certificate 0.054 m, issued at 58.9 s.");
  EXPECT_EQ(trials.facts(1), "failure after 8.0 s. No way from S to G was found, not issued.");
  const Json json = Json::parse(unpacked(trial_list_block(trials, {})));
  EXPECT_EQ(json["rows"][0][0], "007");
  EXPECT_EQ(json["rows"][1][1], nullptr);
  EXPECT_EQ(json["columns"].size(), json["rows"][0].size());
}

TEST(Sparklines, AreTheCorridorValueAndThenTheCertificate) {
  const Sparkline spark = sparkline(series());
  ASSERT_EQ(spark.size(), kSparkPoints);
  EXPECT_EQ(spark.front(), 0.1);
  EXPECT_EQ(spark.back(), 0.05);
}

}  // namespace
}  // namespace tcert
