#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "support/unix_client.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

/// Rows of a CSV file by its header; lines that begin with # are left out.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> names;
  std::vector<std::map<std::string, std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) {
      continue;
    }
    std::istringstream cells(line);
    std::vector<std::string> values;
    for (std::string cell; std::getline(cells, cell, ',');) {
      values.push_back(cell);
    }
    if (names.empty()) {
      names = values;
      continue;
    }
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) {
      row[names[i]] = values[i];
    }
  }
  return rows;
}

ProcessResult drive(Workdir& work, const std::string& output, std::vector<std::string> more) {
  more.insert(more.begin(), {"drive", "--output", output, "--quiet"});
  return work.run(more);
}

TEST(DriveCommand, HasTheSameBytesForAnyThreadsAndIsMadeAgain) {
  Workdir work(TCERT_BINARY);
  for (const std::string threads : {"1", "2"}) {
    const ProcessResult run =
        drive(work,
              "d" + threads,
              {"--policies", "M3,TD*Lite,CB-V", "--worlds", "2", "--threads", threads});
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
  }
  EXPECT_EQ(work.read("d1/manifest.json"), work.read("d2/manifest.json"));  // digests of every file
  const ProcessResult verified = work.run({"verify", "d1"});
  EXPECT_EQ(verified.exit_code, 0) << to_string(verified);
}

/// The rest of a study may be driven elsewhere.
TEST(DriveCommand, BeginsAnywhere) {
  Workdir work(TCERT_BINARY);
  ASSERT_EQ(drive(work, "all", {"--trials", "6"}).exit_code, 0);
  ASSERT_EQ(drive(work, "rest", {"--trials", "2", "--from", "4"}).exit_code, 0);
  const auto all = rows_of(work.read("all/trials.csv"));
  const auto rest = rows_of(work.read("rest/trials.csv"));
  ASSERT_EQ(all.size(), 6U);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0], all[4]);
  EXPECT_EQ(rest[1], all[5]);
  EXPECT_EQ(work.read("rest/logs/t0000005/tactile.csv"),
            work.read("all/logs/t0000005/tactile.csv"));
}

/// Arms of one world have its walls, its crash force and its day in common; nothing else is dealt.
TEST(DriveCommand, ArmsMeetTheSameWorlds) {
  Workdir work(TCERT_BINARY);
  ASSERT_EQ(drive(work, "d", {"--policies", "M1,M3,M3+squash20", "--worlds", "3"}).exit_code, 0);
  std::map<std::string, std::map<std::string, std::string>> first;
  const auto rows = rows_of(work.read("d/trials.csv"));
  ASSERT_EQ(rows.size(), 27U);
  for (const auto& row : rows) {
    const auto [same, is_new] = first.emplace(row.at("world"), row);
    for (const char* const column : {"day", "lighting", "true_margin_m", "crash_force_n"}) {
      EXPECT_EQ(row.at(column), same->second.at(column)) << row.at("trial_id");
    }
    EXPECT_NE(work.read("d/worlds/" + row.at("world") + ".json"), "");
  }
  EXPECT_EQ(first.size(), 9U);
}

/// Its own reader finds nothing to say of a driven bundle, and certifies it.
TEST(DriveCommand, WritesABundleLikeAnyOther) {
  Workdir work(TCERT_BINARY);
  ASSERT_EQ(drive(work, "d", {"--worlds", "2", "--lightings", "Outdoor"}).exit_code, 0);
  const ProcessResult checked = work.run({"check", "d"});
  EXPECT_EQ(checked.exit_code, 0) << to_string(checked);
  EXPECT_NE(checked.err.find("12 trials checked: 0 errors, 0 warnings"), std::string::npos)
      << to_string(checked);
  const ProcessResult certified = work.run({"certify", "d", "--truth", "--output", "r", "--quiet"});
  ASSERT_EQ(certified.exit_code, 0) << to_string(certified);
  for (const auto& row : rows_of(work.read("r/features.csv"))) {
    EXPECT_EQ(row.at("certificate_falls"), "0");
    if (row.at("success") == "0") {
      EXPECT_EQ(row.at("issued"), "0") << row.at("trial_id");
    }
  }
}

/// What is printed is what the rows of trials.csv come to, counted here.
TEST(DriveCommand, PairsAreCountedAsTheyEnd) {
  Workdir work(TCERT_BINARY);
  ASSERT_EQ(drive(work,
                  "d",
                  {"--policies", "M3,M3+clip10,CB-V", "--worlds", "8", "--set", "drive_worlds=any"})
                .exit_code,
            0);
  std::map<std::string, std::map<std::string, bool>> arrives;  // by world, then arm
  for (const auto& row : rows_of(work.read("d/trials.csv"))) {
    arrives[row.at("world")][row.at("algorithm")] = row.at("success") == "1";
  }
  const ProcessResult run = work.run(
      {"hypotheses", "h3", "d", "--driven", "--quiet", "--format", "json", "--table", "h3_driven"});
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  const json rows = json::parse(run.out)["rows"];
  ASSERT_EQ(rows.size(), 2U);
  for (const json& row : rows) {
    int lost = 0;
    int won = 0;
    for (const auto& [world, of] : arrives) {
      const bool own = of.at(row["arm"].get<std::string>());
      lost += of.at("M3") && !own ? 1 : 0;
      won += !of.at("M3") && own ? 1 : 0;
    }
    EXPECT_EQ(row["pairs"], 24);
    EXPECT_EQ(row["lost"], lost) << row;
    EXPECT_EQ(row["won"], won) << row;
  }
}

TEST(DriveCommand, RefusesWhatItCannotDrive) {
  Workdir work(TCERT_BINARY);
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--policies", "M3"}, "need --worlds"},
      {{"--policies", "M4", "--worlds", "1"}, "found 'M4', expected a policy"},
      {{"--policies", "M3,M3", "--worlds", "1"}, "each policy once"},
      {{"--lightings", "dark", "--worlds", "1"}, "expected Dark, Indoor or Outdoor"},
      {{"--trials", "3", "--worlds", "1"}, "expected one of them"},
      {{"--set", "drive_friction=-1"}, "drive_friction"},
      {{"--set", "cruise_mps=0"}, "cruise_mps"},
      {{"--set", "lookahead_m=9"}, "at most 64 times policy_cell_m"},
      {{"--trials", "2", "--set", "drive_gate_margin_m=-0.3"}, "drive_worlds=any"}};
  for (const auto& [more, message] : wrong) {
    const ProcessResult run = drive(work, "d", more);
    EXPECT_EQ(run.exit_code, 2) << to_string(run);
    EXPECT_NE(run.err.find(message), std::string::npos) << to_string(run);
  }
  const ProcessResult nowhere = work.run({"drive"});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_NE(nowhere.err.find("needs --output DIR"), std::string::npos) << to_string(nowhere);
}

std::string lines_of(const std::string& line, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += line + '\n';
  }
  return text;
}

/// A controller that sees nothing and drives straight on: what it is told is a row a command, and
/// the trial that it drove is a bundle.
TEST(DriveCommand, GivesTheLoopToAnotherProcess) {
  Workdir work(TCERT_BINARY);
  const ProcessResult run =
      work.run({"drive", "--stdio", "--output", "d"}, lines_of("0.15, 0", 12000));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto trials = rows_of(work.read("d/trials.csv"));
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].at("algorithm"), "stdio");
  EXPECT_NE(trials[0].at("success"), "1");  // it meets the island beside S
  const auto told = rows_of(run.out);
  EXPECT_GT(told.size(), 100U);
  EXPECT_NE(run.out.find("# lane 1 1 "), std::string::npos);
  EXPECT_EQ(work.run({"check", "d"}).exit_code, 0);
}

// The same world and the same commands are the same trial, whichever way they come.
TEST(DriveCommand, GivesTheLoopToAnotherProcessOverASocket) {
  Workdir work(TCERT_BINARY);
  const std::string path = (work / "loop").string();
  ProcessResult run;
  std::thread tool([&] {
    run =
        work.run({"drive", "--listen", "unix:" + path, "--name", "mine", "--output", "by-socket"});
  });
  const int end = test_support::connected_to(path);
  EXPECT_GE(end, 0);
  if (end >= 0) {
    std::FILE* const told = ::fdopen(end, "r");
    std::array<char, 1U << 16U> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), told) != nullptr) {
      if (std::isdigit(static_cast<unsigned char>(line[0])) != 0) {  // a row, not what leads to it
        constexpr std::string_view kOn = "0.15,0\n";
        EXPECT_EQ(::send(end, kOn.data(), kOn.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(kOn.size()));
      }
    }
    std::fclose(told);
  }
  tool.join();
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_NE(run.err.find("listening on unix:"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(path)) << "the socket is gone with its connection";
  ASSERT_EQ(work.run({"drive", "--stdio", "--output", "d"}, lines_of("0.15,0", 12000)).exit_code,
            0);
  EXPECT_EQ(rows_of(work.read("by-socket/trials.csv"))[0].at("algorithm"), "mine");
  for (const char* const stream : {"pose", "tactile", "control"}) {
    const std::string file = std::string("/logs/t0000000/") + stream + ".csv";
    EXPECT_EQ(work.read("by-socket" + file), work.read("d" + file));
    EXPECT_GT(work.read("d" + file).size(), 1000U);
  }
  EXPECT_EQ(work.run({"drive", "--listen", "udp:5", "--output", "x"}).exit_code, 2);
  EXPECT_EQ(work.run({"drive", "--listen", "unix:a", "--stdio", "--output", "x"}).exit_code, 2);
  EXPECT_EQ(work.run({"drive", "--name", "mine", "--output", "x"}).exit_code, 2);
}

TEST(DriveCommand, RefusesLinesThatAreNoCommands) {
  Workdir work(TCERT_BINARY);
  for (const std::string& wrong : {std::string("speed_mps,yaw_rate_rps"),
                                   std::string("0.1"),
                                   std::string("0.1,nan"),
                                   std::string("inf,0"),
                                   std::string("0.1;0"),
                                   std::string(),
                                   std::string("0.1,0.2\0rubbish", 15),
                                   "0.1," + std::string(400, '0')}) {
    const ProcessResult run = work.run({"drive", "--stdio", "--output", "d"}, wrong + '\n');
    EXPECT_EQ(run.exit_code, 65) << wrong << run.err;
    EXPECT_NE(run.err.find("expected two numbers with a comma"), std::string::npos) << run.err;
  }
  const ProcessResult left = work.run({"drive", "--stdio", "--output", "d"}, "0.1,0\n");
  EXPECT_EQ(left.exit_code, 65);
  EXPECT_NE(left.err.find("before the trial did: nothing is written"), std::string::npos)
      << left.err;
  EXPECT_TRUE(work.files("d").empty());
  work.write("mine/notes.txt", "mine");
  EXPECT_EQ(work.run({"drive", "--stdio", "--output", "mine"}, lines_of("0,0", 9)).exit_code, 73);
}

}  // namespace
}  // namespace tcert
