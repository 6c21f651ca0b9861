/// Paths given to --output and its kin that hold something of the user's, or lead to it.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "cli/attacks.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;

/// Every command that writes, without the path that it writes to.
const std::vector<std::string>& writers() {
  static const std::vector<std::string> all = {
      "simulate --trials 6 --output",
      "simulate terrain --rows 4 --columns 4 --output",
      "import carmen log.clf --fov 180 --output",
      "certify tree/corpus --output",
      "replay tree/corpus --output",
      "ablate tree/corpus --replicates 20 --no-cache --output",
      "sweep tree/corpus --replicates 20 --no-cache --grid beta_per_m=5 --output",
      "hypotheses h1 --features tree/certificates/features.csv --replicates 20 --output",
      "fit km --data tree/certificates/features.csv --formula 'Surv(time_s,success)~1' --output",
      "world tree/corpus/worlds/t0000000.json --no-curvature --output",
      "world tree/corpus/worlds/t0000000.json --no-curvature --picture",
      "explore map.csv --start 2,2 --lipschitz 18 --threshold=-1e9 --mode explore --output",
      "figures tree --output",
      "report tree --output",
      "live --bundle tree/corpus --record",
      "live --bundle tree/corpus --guards --audit"};
  return all;
}

class HostilePaths : public Attacks {
 protected:
  static void SetUpTestSuite() {
    Attacks::SetUpTestSuite();
    const ProcessResult run = shell->run(
        "cd run && $T simulate terrain --rows 4 "
        "--columns 4 --output map.csv && "
        "echo 'FLASER 3 1 1 1 0 0 0 0 0 0 1 host 1' > log.clf && mkfifo pipe && "
        "ln -s ../canary/new dangling && ln -s canary/x to_file && ln -s loop loop");
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
  }
};

TEST_F(HostilePaths, NothingOfTheUserIsReplacedOrWrittenThrough) {
  const std::vector<std::string> paths = {"canary",
                                          "canary/",
                                          "canary/.",
                                          "canary/../canary",
                                          "$PWD/canary",
                                          "canary/x",
                                          "canary/x/below",
                                          "link",
                                          "link/",
                                          "dangling",
                                          "to_file",
                                          "loop",
                                          "loop/below",
                                          "pipe",
                                          "pipe/below",
                                          "/dev/null",
                                          "/proc/self/new",
                                          ".",
                                          "..",
                                          "/",
                                          "tree",
                                          "tree/corpus/trials.csv",
                                          "tree/certificates/features.csv",
                                          "$(printf '%0300d' 1)",
                                          "$(printf '%05000d' 1)"};
  for (const std::string& writer : writers()) {
    std::string line = "true; ";
    for (const std::string& path : paths) {
      line += "$T " + writer + " \"" + path + "\" < /dev/null; echo $?; ";
    }
    const ProcessResult run = attack(line);
    std::istringstream codes(run.out);
    std::size_t refused = 0;
    for (std::string code; std::getline(codes, code);) {
      refused += code == "73" || code == "2" ? 1 : 0;
    }
    EXPECT_EQ(refused, paths.size()) << to_string(run);
  }
}

/// A manifest that claims a folder, or lists what lies elsewhere, makes nobody's files ours.
TEST_F(HostilePaths, AManifestThatLiesMakesNothingOurs) {
  const std::string manifest = shell->work().read("run/tree/certificates/manifest.json");
  const std::vector<std::string> listed = {"../canary/x",
                                           "../../canary/planted",
                                           "/etc/passwd",
                                           "..",
                                           ".",
                                           "",
                                           "../",
                                           "series/../../canary/x",
                                           "mine.txt",
                                           "link/x"};
  for (const std::string& path : listed) {
    std::string lie = manifest;
    const auto at = lie.find("\"features.csv\"");
    ASSERT_NE(at, std::string::npos);
    lie.replace(at, 14, "\"" + path + "\"");
    shell->work().write("run/claimed/manifest.json", lie);
    shell->work().write("run/claimed/mine.txt", "mine");
    for (const char* line :
         {"$T certify tree/corpus --output claimed",
          "sh -c 'cp -r claimed out/certificates && $T reproduce tree/corpus --output "
          "out; c=$?; test -f out/certificates/mine.txt || exit 0; exit $c'",
          "$T verify claimed --inputs tree/corpus",
          "$T verify claimed --files-only",
          "$T report claimed --output out/r.html"}) {
      const ProcessResult run = attack(line);
      EXPECT_NE(run.exit_code, 0) << path << to_string(run);
    }
    (void)attack("$T figures claimed --output out/f");  // of what is there: nothing
  }
}

/// Of a file's manifest the same.
TEST_F(HostilePaths, AManifestBesideAFileOfTheUserMakesItNotOurs) {
  ASSERT_EQ(shell
                ->run("cd run && cp map.csv own.csv && cp map.csv.manifest.json "
                      "own.csv.manifest.json && echo mine >> own.csv && "
                      "ln -s ../canary/planted linked.csv && "
                      "cp map.csv.manifest.json linked.csv.manifest.json")
                .exit_code,
            0);
  for (const char* path : {"own.csv", "linked.csv", "map.csv.manifest.json"}) {
    const ProcessResult run =
        attack(std::string("$T simulate terrain --rows 5 --columns 4 --output ") + path);
    EXPECT_EQ(run.exit_code, 73) << to_string(run);
  }
}

}  // namespace
}  // namespace tcert
