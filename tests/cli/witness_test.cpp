#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

void expect_done(const ProcessResult& run) { ASSERT_EQ(run.exit_code, 0) << to_string(run); }

using Rows = std::vector<std::map<std::string, std::string>>;

Rows rows_of(const std::string& csv) {
  std::istringstream lines(csv);
  Rows rows;
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) {
      continue;
    }
    std::vector<std::string> cells;
    std::istringstream rest(line + ',');
    for (std::string cell; std::getline(rest, cell, ',');) {
      cells.push_back(cell);
    }
    if (names.empty()) {
      names = cells;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) {
      rows.back()[names[i]] = cells[i];
    }
  }
  return rows;
}

/// True if the rows agree in all columns but these.
void expect_same_but(const Rows& a, const Rows& b, const std::set<std::string>& but) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const auto& [name, cell] : a[i]) {
      if (!but.contains(name)) {
        ASSERT_EQ(cell, b[i].at(name)) << name << " in row " << i;
      }
    }
  }
}

// All but T_t is as under width, and T_t is the witness's; asking for the files changes no other.
TEST(WitnessOption, LeavesEverythingButTheCertificateAsItIs) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "24", "--output", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--output", "width"}));
  const ProcessResult asking = work.run({"certify", "corpus", "--witness", "--output", "asked"});
  expect_done(asking);
  expect_done(work.run({"certify", "corpus", "--set", "clearance=witness", "--output", "by"}));
  EXPECT_EQ(work.read("asked/features.csv"), work.read("width/features.csv"));
  const std::set<std::string> of_certificate{
      "issued", "issued_s", "certificate_m", "issued_before_goal", "certificate_falls"};
  expect_same_but(rows_of(work.read("width/features.csv")),
                  rows_of(work.read("by/features.csv")),
                  of_certificate);
  std::size_t issued = 0;
  const Rows asked = rows_of(work.read("asked/certificates.csv"));
  const Rows by_witness = rows_of(work.read("by/certificates.csv"));
  EXPECT_FALSE(rows_of(work.read("width/certificates.csv")).front().contains("witness_m"));
  ASSERT_EQ(asked.size(), by_witness.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    EXPECT_EQ(asked[i].at("witness_m"), by_witness[i].at("certificate_m"));
    const std::string& margin = by_witness[i].at("certificate_m");
    const bool is_issued = by_witness[i].at("issued") == "1";
    EXPECT_EQ(is_issued, !margin.empty() && std::stod(margin) > 0.0);
    issued += is_issued ? 1U : 0U;
    if (is_issued) {
      EXPECT_EQ(asked[i].at("success"), "1") << asked[i].at("trial_id");
      EXPECT_LT(std::stod(margin), 0.5);  // narrower than the course is wide
    }
  }
  EXPECT_GT(issued, 12U);
  const std::string found = "Witnesses: " + std::to_string(issued) + " of 24 trials have a path";
  EXPECT_NE(asking.err.find(found), std::string::npos) << asking.err;
  for (const std::string& file : work.files("width/series")) {
    expect_same_but(rows_of(work.read("width/series/" + file)),
                    rows_of(work.read("by/series/" + file)),
                    {"certificate_m", "series_m", "issued"});
  }
}

TEST(WitnessOption, VerifyChecksTheProofs) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "3", "--output", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--witness", "--threads", "2", "--output", "out"}));
  expect_done(work.run({"verify", "out", "--inputs", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--witness", "--threads", "1", "--output", "one"}));
  const auto files = work.files("out/witness");
  ASSERT_FALSE(files.empty());
  for (const std::string& file : files) {
    EXPECT_EQ(work.read("out/witness/" + file), work.read("one/witness/" + file));
  }
  const std::string name = "out/witness/" + *files.begin();
  std::string text = work.read(name);
  const auto margin = text.find("\"margin_m\":0.0");
  ASSERT_NE(margin, std::string::npos);
  text.replace(margin, 14, "\"margin_m\":0.1");
  work.write(name, text);
  const ProcessResult verified = work.run({"verify", "out", "--inputs", "corpus"});
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_NE(verified.err.find("the checker measures another margin"), std::string::npos)
      << to_string(verified);
}

// Edges: a failed trial has proofs of what it passed, what chains from S to G proves no more than
// the world has, and what is proved of the whole stays as it is.
TEST(WitnessOption, EdgesAreProvedInFailedTrialsToo) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "40", "--output", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--witness", "--output", "whole"}));
  const ProcessResult asking =
      work.run({"certify", "corpus", "--witness-edges", "--threads", "2", "--output", "edges"});
  expect_done(asking);
  EXPECT_NE(asking.err.find(" edges (proved_m)"), std::string::npos) << asking.err;
  const Rows trials = rows_of(work.read("edges/certificates.csv"));
  expect_same_but(rows_of(work.read("whole/certificates.csv")), trials, {});
  std::size_t failures = 0;
  std::size_t edges = 0;
  std::size_t proved = 0;
  for (const auto& trial : trials) {
    const std::string& id = trial.at("trial_id");
    std::size_t proved_here = 0;
    for (const auto& edge : rows_of(work.read("edges/edges/" + id + ".csv"))) {
      ++edges;
      const std::string& margin = edge.at("proved_m");
      proved_here += !margin.empty() && std::stod(margin) > 0.0 ? 1U : 0U;
      if (!margin.empty()) {
        EXPECT_LT(std::stod(margin), 1.2 - 0.45);  // the course is 1.2 m wide where it is widest
      }
    }
    EXPECT_EQ(std::to_string(proved_here), trial.at("edges_proved"));
    proved += proved_here;
    failures += trial.at("success") == "0" && proved_here > 10 ? 1U : 0U;
    if (!trial.at("chain_m").empty() && !trial.at("witness_m").empty()) {
      EXPECT_LT(std::stod(trial.at("chain_m")), std::stod(trial.at("witness_m")) + 0.02) << id;
    }
  }
  EXPECT_GT(failures, 1U);
  EXPECT_GT(10 * proved, 9 * edges);
  for (const std::string& file : work.files("whole/witness")) {
    const std::string whole = work.read("whole/witness/" + file);
    const std::string both = work.read("edges/witness/" + file);
    EXPECT_EQ(both.substr(0, whole.size() - 2), whole.substr(0, whole.size() - 2)) << file;
  }
  EXPECT_EQ(work.files("edges/witness").size(), trials.size());
  expect_done(work.run({"verify", "edges", "--inputs", "corpus"}));
}

TEST(WitnessOption, AProofThatChoosesItsOwnRuleOrDropsItsLabelIsRefused) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "2", "--output", "corpus"}));
  expect_done(work.run(
      {"certify", "corpus", "--witness", "--set", "pose_bridge_s=0.05", "--output", "out"}));
  expect_done(work.run({"verify", "out", "--inputs", "corpus"}));
  const auto files = work.files("out/witness");
  ASSERT_FALSE(files.empty());
  const std::string name = "out/witness/" + *files.begin();
  const std::string text = work.read(name);
  const auto refused = [&](const std::string& from, const std::string& to, const char* why) {
    std::string changed = text;
    ASSERT_NE(changed.find(from), std::string::npos) << from;
    work.write(name, changed.replace(changed.find(from), from.size(), to));
    const ProcessResult verified = work.run({"verify", "out", "--inputs", "corpus"});
    EXPECT_EQ(verified.exit_code, 1);
    EXPECT_NE(verified.err.find(why), std::string::npos) << to_string(verified);
  };
  refused(
      "\"pose_bridge_s\":0.05", "\"pose_bridge_s\":0.06", "another robot, course, rule or label");
  refused("\"body_width_m\":0.", "\"body_width_m\":0.0", "another robot, course, rule or label");
  refused("{\"synthetic\":true,\"seed\":1,", "{", "another robot, course, rule or label");
  refused("\"trial_id\":", "\"trial_id\": ", "is not written as the tool writes");
}

// Another program, of the standard library of another language, from the log alone. Rays along the
// axes put the ends of strips on the lines between cells.
TEST(WitnessOption, AnotherCheckerAgrees) {
  const auto script = std::filesystem::path(TCERT_GOLDEN) / "../../scripts/check_witness.py";
  Workdir work(TCERT_BINARY);
  if (std::system("python3 -c '' 2>/dev/null") != 0) {
    GTEST_SKIP() << "missing: python3";
  }
  std::string ticks = "time_s,x_m,y_m,yaw_rad,left_range_m,right_range_m,front_range_m\n";
  for (int i = 0; i <= 250; ++i) {
    ticks += std::to_string(0.1 * i) + ',' + std::to_string(0.02 * i) + ",0,0,0.4,0.45,1.0\n";
  }
  work.write("corridor/logs/t/ticks.csv", ticks);
  work.write("corridor/trials.csv", "trial_id,success,time_s\nt,1,25\n");
  work.write("corridor/bundle.json",
             R"({"format":"tcert-bundle","version":1,"robot":{"body_width_m":0.3,
 "min_turn_radius_m":0.2},"rays":[
 {"name":"left","kind":"range","mount_y_m":0.1,"bearing_rad":1.5707963267948966,"reach_m":0.5},
 {"name":"right","kind":"range","mount_y_m":-0.1,"bearing_rad":-1.5707963267948966,"reach_m":0.5},
 {"name":"front","kind":"range","mount_x_m":0.1,"bearing_rad":0,"reach_m":1}],
 "course":{"start":{"disc":{"x_m":0.5,"y_m":0,"radius_m":0.4}},
           "goal":{"disc":{"x_m":4.2,"y_m":0,"radius_m":0.4}}}})");
  expect_done(work.run({"simulate", "--trials", "2", "--output", "corpus"}));
  for (const std::string bundle : {"corridor", "corpus"}) {
    expect_done(
        work.run({"certify", bundle, "--witness-edges", "--output", bundle + "-out", "--quiet"}));
    const auto files = work.files(bundle + "-out/witness");
    ASSERT_FALSE(files.empty()) << bundle;
    const std::string proof = (work / (bundle + "-out/witness/" + *files.begin())).string();
    const std::string command =
        "python3 -O " + script.string() + " " + (work / bundle).string() + " ";
    EXPECT_EQ(std::system((command + proof + " >/dev/null").c_str()), 0) << bundle;
    const std::string text = test_support::read_text(proof);
    // The margin of the whole, that of the first edge, and where a waypoint lies.
    const std::size_t edges = text.find("\"edges\":{");
    ASSERT_NE(edges, std::string::npos);
    for (const auto& [key, from] : {std::pair("\"margin_m\":", std::size_t{0}),
                                    std::pair("\"margin_m\":", edges),
                                    std::pair("\"waypoint\":[", edges)}) {
      std::string changed = text;
      const std::size_t at = changed.find(key, from) + std::string(key).size();
      changed.replace(at, changed.find(',', at) - at, "0.9");
      work.write("changed.json", changed);
      EXPECT_NE(std::system((command + (work / "changed.json").string() + " >/dev/null").c_str()),
                0)
          << key;
    }
  }
}

TEST(WitnessOption, NothingThatGoesFromTickToTickTakesItForItsReading) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "12", "--output", "corpus"}));
  const ProcessResult sweep = work.run({"sweep", "corpus", "--grid", "clearance=width,witness"});
  EXPECT_NE((sweep.out + sweep.err).find("take width, radial or swept"), std::string::npos)
      << to_string(sweep);
  expect_done(
      work.run({"replay", "corpus", "--set", "clearance=witness", "--replan", "--output", "by"}));
  expect_done(work.run({"replay", "corpus", "--replan", "--output", "width"}));
  EXPECT_EQ(work.read("by/replay.csv"), work.read("width/replay.csv"));
}

std::vector<std::string> column_of(const std::string& series, const std::string& name) {
  std::vector<std::string> cells;
  for (auto& row : rows_of(series)) {
    cells.push_back(row[name]);
  }
  return cells;
}

// Live rows know what a look found one look later; nothing else of them differs from those of
// certify, nor does anything but T_t from those of width.
TEST(WitnessOption, ALiveRunLooksWhenCertifyDoes) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "4", "--output", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--ticks", "--output", "width"}));
  EXPECT_EQ(work.run({"live", "--bundle", "corpus", "--set", "clearance=witness"}).exit_code, 2);
  constexpr std::size_t kEvery = 25;
  std::size_t earlier = 0;
  for (int trial = 0; trial < 4; ++trial) {
    const std::string id = "t000000" + std::to_string(trial);
    const std::string record = "record-" + id;
    const ProcessResult live = work.run({"live",
                                         "--bundle",
                                         "corpus",
                                         "--set",
                                         "clearance=witness",
                                         "--set",
                                         "witness_every=" + std::to_string(kEvery),
                                         "--record",
                                         record},
                                        work.read("width/ticks/" + id + ".csv"));
    expect_done(live);
    expect_done(work.run({"certify", record, "--output", "by-" + id}));
    const std::string series = work.read("by-" + id + "/series/live.csv");
    const std::vector<std::string> at_once = column_of(series, "certificate_m");
    const std::vector<std::string> later = column_of(live.out, "certificate_m");
    ASSERT_EQ(at_once.size(), later.size());
    for (std::size_t i = 0; i < later.size(); ++i) {
      EXPECT_EQ(later[i], i < kEvery ? at_once.front() : at_once[i - kEvery]) << i;
    }
    for (std::size_t i = 1; i + 1 < at_once.size(); ++i) {
      earlier += at_once[i] != at_once.front() ? 1 : 0;
      EXPECT_TRUE(at_once[i] == at_once[i - 1] || (i + 1) % kEvery == 0) << i;
    }
    EXPECT_EQ(column_of(series, "margin_m"),
              column_of(work.read("width/series/" + id + ".csv"), "margin_m"));
    const bool proves = live.err.find("a witness proves a margin of") != std::string::npos;
    EXPECT_EQ(proves, at_once.back() != at_once.front()) << live.err;
  }
  EXPECT_GT(earlier, 0U) << "no look before the last found a witness";
}

TEST(WitnessOption, NeedsAFolder) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "1", "--output", "corpus"}));
  EXPECT_EQ(work.run({"certify", "corpus", "--witness"}).exit_code, 2);
}

}  // namespace
}  // namespace tcert
