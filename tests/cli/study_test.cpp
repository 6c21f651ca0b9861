#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

json rows_of(Workdir& work, std::vector<std::string> arguments, const std::string& table) {
  arguments.insert(arguments.begin(), "study");
  arguments.insert(arguments.end(), {"--quiet", "--format", "json", "--table", table});
  const ProcessResult run = work.run(arguments);
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  return json::parse(run.out)["rows"];
}

TEST(StudyCommand, TheSweptReadingIsSoundAndFreeSpaceForUnknownIsNot) {
  Workdir work(TCERT_BINARY);
  const json rows = rows_of(
      work, {"soundness", "--worlds", "200", "--hard", "70", "--u-turns", "50"}, "soundness");
  int swept = 0;
  int free = 0;
  for (const json& row : rows) {
    const std::string method = row["method"];
    EXPECT_LE(row["violating_worlds"], row["worlds"]) << row;
    EXPECT_LE(row["issued_untraversable"], row["untraversable"]) << row;
    EXPECT_GE(row["upper_95"], row["rate"]) << row;
    EXPECT_EQ(row["violating_worlds"] == 0, row["largest_excess_m"] == 0.0) << row;
    EXPECT_EQ(row["violating_worlds"] == 0, row["worst_world"].is_null()) << row;
    if (method == "swept") {
      ++swept;
      EXPECT_EQ(row["violating_worlds"], 0) << row;
    } else if (method.starts_with("A2")) {
      ++free;
      EXPECT_GT(row["rate"], 0.9) << row;
    }
  }
  EXPECT_GE(swept, 4);
  EXPECT_GE(free, 2);
}

TEST(StudyCommand, IntervalsCoverMoreThanHalfTheTruthAndWidthsArePositive) {
  Workdir work(TCERT_BINARY);
  const json rows =
      rows_of(work, {"coverage", "--data-sets", "12", "--replicates", "99"}, "coverage");
  ASSERT_FALSE(rows.empty());
  double covered = 0.0;
  for (const json& row : rows) {
    EXPECT_GE(row["coverage"], 0.0) << row;
    EXPECT_LE(row["coverage"], 1.0) << row;
    EXPECT_GT(row["mean_width"], 0.0) << row;
    EXPECT_LE(std::abs(row["truth"].get<double>() - row["mean_estimate"].get<double>()), 0.1)
        << row;
    covered += row["coverage"].get<double>();
  }
  EXPECT_GT(covered / static_cast<double>(rows.size()), 0.7);
}

TEST(StudyCommand, TestsOfTheTruthRejectSeldom) {
  Workdir work(TCERT_BINARY);
  const json rows =
      rows_of(work, {"inference", "--data-sets", "6", "--replicates", "39"}, "inference");
  ASSERT_EQ(rows.size(), 12U * 4U * 5U);
  double rejected = 0.0;
  for (const json& row : rows) {
    EXPECT_EQ(row["tests"].get<int>() + row["missing"].get<int>() + row["withheld"].get<int>(), 6);
    rejected += row["method"] == "jackknife" ? row["rejected"].get<double>() : 0.0;
  }
  EXPECT_LT(rejected / 48.0, 0.2);
}

/// True of a share, and of a missing one.
bool is_share(const json& cell) { return cell.is_null() || (cell >= 0.0 && cell <= 1.0); }

TEST(StudyCommand, EquivalenceIsFoundLessOftenTheFurtherLightingsLieApart) {
  Workdir work(TCERT_BINARY);
  const json all = rows_of(work, {"equivalence", "--data-sets", "12"}, "equivalence");
  ASSERT_EQ(all.size(), 36U);
  json rows = json::array();
  for (const json& row : all) {
    if (row["days"] == 22) {
      rows.push_back(row);
    }
  }
  ASSERT_EQ(rows.size(), 27U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const json& row = rows[i];
    EXPECT_TRUE(is_share(row["equivalent"]) && is_share(row["different"])) << row;
    EXPECT_LE(row["equivalent"], row["pair_equivalent"]) << row;  // all pairs are harder than one
    EXPECT_LE(row["difference"], row["margin"]) << row;
    EXPECT_GT(row["mean_se"], 0.01) << row;
    EXPECT_LT(row["mean_se"], 0.3) << row;
    EXPECT_GT(row["margin_80"], row["mean_se"]) << row;
    if (i % 3 == 2) {  // a margin apart, against alike
      EXPECT_LE(row["equivalent"], rows[i - 2]["equivalent"]) << row;
    }
  }
}

TEST(StudyCommand, SetsOfTheEvenChanceLieInMillimetresBelowZero) {
  Workdir work(TCERT_BINARY);
  const json rows =
      rows_of(work, {"gate", "--data-sets", "6", "--replicates", "99"}, "gate_coverage");
  ASSERT_EQ(rows.size(), 4U);
  for (const json& row : rows) {
    EXPECT_LE(row["sets"], 6) << row;
    EXPECT_TRUE(is_share(row["coverage"]) && is_share(row["unbounded_share"])) << row;
    EXPECT_LE(row["covers_zero"], 0.5) << row;  // the felt margin is too small, so 0 lies above
    EXPECT_GT(row["median_width_m"], 0.002) << row;
    EXPECT_LT(row["median_width_m"], 0.05) << row;
  }
}

TEST(StudyCommand, TrustingLessHoldsNoMoreUnsafeGroundSafe) {
  Workdir work(TCERT_BINARY);
  const json rows = rows_of(work, {"terrain", "--terrains", "40"}, "terrain_trust");
  ASSERT_EQ(rows.size(), 5U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_LE(rows[i]["with_unsafe_visits"], rows[i]["with_unsafe_cells"]) << rows[i];
    EXPECT_LE(rows[i]["with_unsafe_cells"], rows[i]["terrains"]) << rows[i];
    if (i > 0) {  // a wider band
      EXPECT_LE(rows[i]["with_unsafe_cells"], rows[i - 1]["with_unsafe_cells"]) << rows[i];
      EXPECT_GE(rows[i]["mean_samples"], rows[i - 1]["mean_samples"]) << rows[i];
    }
  }
}

TEST(StudyCommand, NothingIsFoundWhereThereIsNothing) {
  Workdir work(TCERT_BINARY);
  const json told = rows_of(work, {"terrain", "--terrains", "4"}, "terrain_soundness");
  ASSERT_EQ(told.size(), 6U);
  EXPECT_EQ(told[0]["with_unsafe_cells"], 0);
  const json null = rows_of(work, {"null", "--data-sets", "1"}, "null_corpora");
  ASSERT_EQ(null.size(), 2U);
  for (const json& row : null) {
    EXPECT_NEAR(row["auc"].get<double>(), 0.5, 0.2) << row;
  }
}

TEST(StudyCommand, SaysThatAPathWithoutASlashIsOneFile) {
  Workdir work(TCERT_BINARY);
  const std::vector<std::string> asked{
      "study", "soundness", "--worlds", "2", "--hard", "0", "--u-turns", "1"};
  std::vector<std::string> file = asked;
  file.insert(file.end(), {"--output", "x"});
  const ProcessResult run = work.run(file);
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_FALSE(work.read("x").empty());
  EXPECT_FALSE(work.read("x.manifest.json").empty());
  EXPECT_NE(run.err.find("'x' is one file, in the format text; 'x/' would be a folder"),
            std::string::npos)
      << run.err;
  std::vector<std::string> folder = asked;
  folder.insert(folder.end(), {"--output", "y/"});
  EXPECT_EQ(work.run(folder).err.find("one file"), std::string::npos);
  EXPECT_NE(work.run({"help", "study"}).out.find("is one file of what would be printed"),
            std::string::npos);
}

TEST(StudyCommand, IsTheSameForAnyThreadsAndIsMadeAgain) {
  Workdir work(TCERT_BINARY);
  const std::vector<std::string> asked{
      "study", "soundness", "--worlds", "40", "--hard", "21", "--u-turns", "9"};
  for (const std::string threads : {"1", "2"}) {
    std::vector<std::string> all = asked;
    all.insert(all.end(), {"--threads", threads, "--output", "of" + threads + "/", "--quiet"});
    const ProcessResult run = work.run(all);
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
  }
  EXPECT_EQ(work.read("of1/report.json"), work.read("of2/report.json"));
  EXPECT_EQ(work.read("of1/manifest.json"), work.read("of2/manifest.json"));
  const ProcessResult verified = work.run({"verify", "of1"});
  EXPECT_EQ(verified.exit_code, 0) << to_string(verified);
}

/// The sentence before the table says what the table says.
TEST(StudyCommand, SoundnessBeginsWithWhatItFound) {
  Workdir work(TCERT_BINARY);
  const ProcessResult run = work.run(
      {"study", "soundness", "--worlds", "40", "--hard", "0", "--u-turns", "9", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  const json rows =
      rows_of(work, {"soundness", "--worlds", "40", "--hard", "0", "--u-turns", "9"}, "soundness");
  std::string counts;
  for (const json& row : rows) {
    if (row["worlds_of"] == "mixed" && row["noise"] == "no") {
      counts += (counts.empty() ? "" : "; ") + row["method"].get<std::string>() + ": " +
                std::to_string(row["violating_worlds"].get<int>());
      if (row["violating_worlds"] > 0) {
        std::array<char, 40> excess{};
        std::snprintf(excess.data(),
                      excess.size(),
                      ", by at most %.4f m",
                      row["largest_excess_m"].get<double>());
        counts += excess.data();
      }
    }
  }
  EXPECT_NE(run.out.find("T_t above the truth, mixed: of 40 worlds " + counts + ".\n"),
            std::string::npos)
      << counts << '\n'
      << run.out;
}

TEST(StudyCommand, RefusesWhatDoesNothing) {
  Workdir work(TCERT_BINARY);
  const ProcessResult option = work.run({"study", "null", "--worlds", "3"});
  EXPECT_EQ(option.exit_code, 2);
  EXPECT_NE(option.err.find("--worlds does nothing to 'study null'"), std::string::npos)
      << to_string(option);
  const ProcessResult table = work.run({"study", "soundness", "--table", "tightnes"});
  EXPECT_EQ(table.exit_code, 2);
  EXPECT_NE(table.err.find("expected one of summary soundness tightness"), std::string::npos)
      << to_string(table);
  const ProcessResult name = work.run({"study", "soundnes"});
  EXPECT_EQ(name.exit_code, 2);
  EXPECT_NE(name.err.find("did you mean 'soundness'"), std::string::npos) << to_string(name);
  work.write("small.csv", "a,b\n1,2\n3,4\n");
  const ProcessResult seeds = work.run({"study", "terrain", "--seeds", "3"});
  EXPECT_EQ(seeds.exit_code, 2) << to_string(seeds);
  const ProcessResult last = work.run({"study", "null", "--seed", "9223372036854775807"});
  EXPECT_EQ(last.exit_code, 2) << to_string(last);
  const ProcessResult small = work.run({"study", "terrain", "small.csv"});
  EXPECT_EQ(small.exit_code, 65) << to_string(small);
  EXPECT_NE(small.err.find("600 x 400"), std::string::npos) << to_string(small);
}

}  // namespace
}  // namespace tcert
