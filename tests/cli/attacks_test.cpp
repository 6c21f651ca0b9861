/// Names, manifests and folders made by strangers: nothing is written, replaced or deleted but
/// below
/// --output.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/attacks.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using test_support::ProcessResult;

TEST_F(Attacks, TrialsOfABundleAreRejectedOneByOne) {
  std::string table = shell->work().read("run/tree/corpus/trials.csv");
  for (const std::string& id : hostile_ids()) {
    table += csv_quoted(id) + ",M1,Dark,D01,B01,1,20,3,goal,0.1\n";
  }
  shell->work().write("trials.csv", table);
  ASSERT_EQ(shell
                ->run("rm -rf run/hostile && cp -r run/tree/corpus run/hostile && "
                      "cp trials.csv run/hostile/")
                .exit_code,
            0);
  for (const char* line : {"$T certify hostile --ticks --output out/a",
                           "$T replay hostile --series --output out/b",
                           "$T check hostile",
                           "$T certify hostile --trials '*' --format csv"}) {
    const ProcessResult run = attack(line);
    EXPECT_TRUE(run.exit_code == 3 || run.exit_code == 1) << to_string(run);
  }
  EXPECT_EQ(shell->work().files("run/out").size(), 0U) << "the last line writes nothing";
  const ProcessResult first =
      attack("$T ablate hostile --replicates 20 --cache out/cache --output out/one");
  EXPECT_EQ(first.exit_code, 3) << to_string(first);
  const ProcessResult twice = attack(
      "sh -c '$T ablate hostile --replicates 20 --cache out/cache --output out/one; "
      "$T ablate hostile --replicates 20 --cache out/cache --output out/two; echo $?; "
      "diff -r out/one out/two; echo $?'");
  EXPECT_EQ(twice.out, "3\n0\n") << "from the cache as without: " << to_string(twice);
}

TEST_F(Attacks, AnIdOfAForeignTreeLeadsNowhere) {
  for (const std::string& id : hostile_ids()) {
    foreign_tree(id);
    const ProcessResult figures = attack("env PATH=/none $T figures foreign --output out/figures");
    EXPECT_TRUE(figures.exit_code == 0 || figures.exit_code == 65 || figures.exit_code == 66)
        << to_string(figures);
  }
  for (const std::string& id : hostile_ids()) {
    if (id.find_first_of(",'\n") == std::string::npos && id.size() < 1000) {
      (void)attack("env PATH=/none $T figures tree --output out/figures --trials '" + id + "'");
    }
  }
}

TEST_F(Attacks, APageReadsNothingByAForeignName) {
  for (const char* id : {"../../canary/x", "../../../canary/planted", "..", "a/../../x"}) {
    foreign_tree(id);
    const ProcessResult run = attack("$T report foreign --output out/report.html");
    EXPECT_TRUE(run.exit_code == 65 || run.exit_code == 66) << to_string(run);
  }
}

TEST_F(Attacks, WorldsOfAnyNameAreDrawnBelowTheFolder) {
  std::string worlds;
  std::size_t count = 0;
  for (const std::string& id : hostile_ids()) {
    ordered_json world =
        ordered_json::parse(shell->work().read("run/tree/corpus/worlds/t0000000.json"));
    world["name"] = id;
    worlds += world.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
    ++count;
  }
  shell->work().write("run/worlds.jsonl", worlds);
  const ProcessResult run =
      attack("$T world worlds.jsonl --no-curvature --step 0.2 --picture out/pictures");
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_EQ(shell->work().files("run/out/pictures").size(), count + 1) << "and the manifest";
}

TEST_F(Attacks, ATrialOfAnImportIsCalledAsAFileMayBe) {
  shell->work().write("run/log.clf", "FLASER 3 1 1 1 0 0 0 0 0 0 1 host 1\n");
  for (const char* id : {"..", "../../canary", "a/b", "", ".x"}) {
    const ProcessResult run =
        attack("$T import carmen log.clf --output out/carmen --trial-id '" + std::string(id) + "'");
    EXPECT_EQ(run.exit_code, 2) << to_string(run);
  }
}

/// What a stranger may write into the command line of a manifest.
TEST_F(Attacks, AManifestRunsNothingButWhatMakesResults) {
  const std::string path = "run/signed/certificates/manifest.json";
  const ordered_json manifest =
      ordered_json::parse(shell->work().read("run/tree/certificates/manifest.json"));
  const ordered_json corpus = {{"input", "corpus"}};
  const auto input = [](const std::string& name) { return ordered_json{{"input", name}}; };
  const std::string here = shell->work() / "run";
  struct Case {
    std::string command;
    std::vector<ordered_json> words;
  };
  std::vector<Case> cases = {
      {"world", {input("corpus"), "--picture", here + "/canary"}},
      {"world", {input("corpus"), "--picture=" + here + "/canary"}},
      {"world", {"--picture", "../canary", input("corpus")}},
      {"report", {input("tree"), "--figures", here + "/canary"}},
      {"report", {input("tree"), "--bundle", here + "/tree/corpus"}},
      {"report", {input("tree"), "--output", here + "/canary/x"}},
      {"certify", {corpus, "--output", here + "/canary/new"}},
      {"certify", {corpus, "--output=" + here + "/canary/new"}},
      {"certify", {here + "/tree/corpus"}},
      {"certify", {input("../tree/corpus")}},
      {"certify", {input(here + "/tree/corpus")}},
      {"certify", {input("..")}},
      {"certify", {corpus, "--config", here + "/canary/x"}},
      {"certify", {corpus, "--config", input("x")}},
      {"certify", {corpus, "--threads", "1000"}},
      {"certify", {corpus, "--quiet"}},
      {"certify", {corpus, "-o", "x"}},
      {"certify", {corpus, "--trials"}},
      {"certify", {corpus, "--trials", input("x")}},
      {"certify", {corpus, "--ticks=1"}},
      {"certify", {corpus, "--help"}},
      {"certify", {corpus, "--"}},
      {"certify", {}},
      {"certify", {corpus, "--strict", "--strict"}},
      {"certify", {corpus, "--trials", "a", "--trials", "b"}},
      {"hypotheses", {corpus}},
      {"ablate", {corpus, "--cache", here + "/canary/cache"}},
      {"ablate", {corpus, "--no-cache"}},
      {"ablate", {corpus, "--cells", here + "/canary/x.csv"}},
      {"sweep", {corpus, "--cache=" + here + "/canary/cache"}},
      {"live", {"--bundle", here + "/tree/corpus", "--record", here + "/canary/r"}},
      {"live", {"--audit", here + "/canary/x"}},
      {"reproduce", {"--output", here + "/canary/tree"}},
      {"reproduce", {corpus}},
      {"verify", {input("tree")}},
      {"import", {"carmen", input("corpus"), "--output", here + "/canary/c"}},
      {"import carmen", {input("corpus")}},
      {"simulate", {"--output", here + "/canary/s"}},
      {"simulate", {"terrain", "--output", here + "/canary/s"}},
      {"help", {}},
      {"version", {}},
      {"", {}},
      {"certify;touch x", {corpus}},
      {"/bin/sh", {"-c", "touch x"}},
      {"fit", {"glm", "--data", here + "/canary/x.csv", "--formula", "y ~ x"}},
      {"fit", {"../x"}},
      {"hypotheses", {"h1", "--features", here + "/canary/x.csv"}},
      {"hypotheses", {"h9", corpus}},
      {"figures", {input("tree"), "--output", here + "/canary/f"}},
      {"explore", {"--config", "/etc/passwd"}}};
  ASSERT_EQ(shell->run("rm -rf run/signed && cp -r run/tree run/signed").exit_code, 0);
  for (const Case& one : cases) {
    ordered_json other = manifest;
    other["command"] = one.command;
    other["arguments"] = ordered_json::array();
    for (const ordered_json& word : one.words) {
      other["arguments"].push_back(word);
    }
    shell->work().write(path, other.dump(2) + "\n");
    const ProcessResult run = attack("$T verify signed");
    EXPECT_TRUE(run.exit_code == 1 || run.exit_code == 66) << other["arguments"] << to_string(run);
    EXPECT_NE(run.err.find("its manifest"), std::string::npos)
        << other["arguments"] << to_string(run);
  }
}

/// The other side of it: no option that shapes a result was forgotten.
TEST_F(Attacks, AManifestMayHaveEveryOptionThatShapesAResult) {
  const std::set<std::string> others = {"help",
                                        "output",
                                        "quiet",
                                        "threads",
                                        "config",
                                        "cache",
                                        "no-cache",
                                        "picture",
                                        "figures",
                                        "wide"};
  ordered_json manifest =
      ordered_json::parse(shell->work().read("run/tree/certificates/manifest.json"));
  ASSERT_EQ(shell->run("rm -rf run/signed && mkdir -p run/signed/one").exit_code, 0);
  const auto is_refused = [&](const std::vector<ordered_json>& words, const std::string& option) {
    manifest["arguments"] = words;
    shell->work().write("run/signed/one/manifest.json", manifest.dump(2) + "\n");
    const ProcessResult run = shell->run("cd run && $T verify signed");
    EXPECT_NE(run.exit_code, 0) << to_string(run);
    return run.err.find("the option '" + option + "'") != std::string::npos;
  };
  int options = 0;
  for (const char* line : {"simulate",        "simulate terrain", "import barn", "certify",
                           "replay",          "ablate",           "sweep",       "gate",
                           "study coverage",  "hypotheses h1",    "world",       "figures",
                           "report",          "explore",          "federate",    "fit glm",
                           "fit cox",         "fit km",           "fit glmm",    "fit roc",
                           "fit calibration", "fit concordance"}) {
    std::istringstream words(line);
    std::string command;
    std::string kind;
    words >> command >> kind;
    std::istringstream help(shell->run(std::string("$T ") + line + " --help").out);
    for (std::string text; std::getline(help, text);) {
      if (!text.starts_with("  --")) {
        continue;
      }
      const std::string name = text.substr(4, text.find(' ', 4) - 4);
      if (others.count(name) != 0) {
        continue;
      }
      const std::string option = "--" + name;
      manifest["command"] = command;
      std::vector<ordered_json> front;
      if (!kind.empty()) {
        front.emplace_back(kind);
      }
      const auto with = [&](std::initializer_list<ordered_json> value) {
        std::vector<ordered_json> all = front;
        all.push_back(option);
        all.insert(all.end(), value.begin(), value.end());
        // Nothing is run, whatever is allowed: one may be taken for a value, the other is refused.
        all.insert(all.end(), 2, "--no-such-option");
        return all;
      };
      EXPECT_FALSE(is_refused(with({"1"}), option) && is_refused(with({}), option) &&
                   is_refused(with({ordered_json{{"input", "nowhere"}}}), option))
          << line << ' ' << option;
      ++options;
    }
  }
  EXPECT_GT(options, 150);
}

TEST_F(Attacks, BytesBehindAManifestAndAddedLinksAreNoticed) {
  const auto differs = [&](const std::string& spoil) {
    ASSERT_EQ(shell
                  ->run("rm -rf run/signed && cp -r run/tree run/signed && cd run/signed/" +
                        std::string("certificates && ") + spoil)
                  .exit_code,
              0);
    for (const char* line : {"$T verify signed --files-only", "$T verify signed"}) {
      const ProcessResult run = attack(line);
      EXPECT_EQ(run.exit_code, 1) << spoil << to_string(run);
    }
  };
  differs("printf ' ' >> manifest.json");
  differs("printf '\\n' >> manifest.json");
  differs("sed -i 's/\"command\"/\"note\": \"trust me\",\\n  \"command\"/' manifest.json");
  differs("ln -s ../../canary added");
  differs("ln -s /nowhere dangling");
  differs("ln -s ../../../canary series/added");
  differs("ln -s /nowhere edges/dangling");
  differs("mkfifo series/pipe");
  differs("mv features.csv ../../other.csv; ln -s ../../other.csv features.csv");
  fs::remove(shell->work() / "run/other.csv");
}

TEST_F(Attacks, TheTreeStandsAsItIs) {
  const ProcessResult run = attack("$T verify tree");
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
}

TEST_F(Attacks, NamesThatAreNotUtf8OrHoldQuotesAreDrawn) {
  std::string table = shell->work().read("run/tree/corpus/trials.csv");
  for (const auto& [from, to] : {std::pair<std::string, std::string>("t0000001", "t\xFF'1"),
                                 std::pair<std::string, std::string>(",M2,", ",it's \xFE,")}) {
    for (auto at = table.find(from); at != std::string::npos; at = table.find(from, at + 1)) {
      table.replace(at, from.size(), to);
    }
  }
  shell->work().write("trials.csv", table);
  ASSERT_EQ(shell
                ->run("cp -r run/tree/corpus run/odd && cp trials.csv run/odd/ && "
                      "mv run/odd/logs/t0000001 \"run/odd/logs/$(printf \"t\\377'1\")\"")
                .exit_code,
            0);
  const ProcessResult run =
      attack("sh -c \"\\$T certify odd --output out/c && \\$T figures out --output out/figures\"");
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
}

/// Stops the process before the first call that brings its results to the disk, after it has looked
/// at what it is to replace; edits that; and lets it go on.
TEST_F(Attacks, WhatIsEditedWhileACommandRunsStays) {
  const std::string stopped = "LD_PRELOAD='" TCERT_KILL_AT_LIBRARY "' TCERT_STOP_AT=1 $T ";
  const std::string and_edit =
      " & pid=$!; until grep -q '^State:.T' /proc/$pid/status; do "
      "sleep 0.01; done; ";
  const std::string and_go_on = "; kill -CONT $pid; wait $pid; echo $?; ls -A out | grep tmp";
  for (const char* edit : {"echo mine >> out/c/features.csv",
                           "echo mine > out/c/mine.txt",
                           "echo mine > out/c/series/t0000000.csv",
                           "rm out/c/edges/t0000000.csv",
                           "ln -s /nowhere out/c/link"}) {
    const ProcessResult run = shell->run(
        "cd run; rm -rf out; $T certify tree/corpus --output out/c; " + stopped +
        "certify tree/corpus --output out/c" + and_edit + edit + "; cp -a out/c out/expected" +
        and_go_on + "; diff -r --no-dereference out/c out/expected && echo same");
    EXPECT_EQ(run.out, "73\nsame\n") << edit << to_string(run);
    EXPECT_NE(run.err.find("while this command ran"), std::string::npos) << run.err;
  }
  const std::string fit =
      "fit km --data tree/certificates/features.csv --formula "
      "'Surv(time_s,success)~1' --output out/km.txt";
  const ProcessResult file =
      shell->run("cd run; rm -rf out; $T " + fit + "; " + stopped + fit + and_edit +
                 "echo mine > out/km.txt" + and_go_on + "; cat out/km.txt");
  EXPECT_EQ(file.out, "73\nmine\n") << to_string(file);
}

}  // namespace
}  // namespace tcert
