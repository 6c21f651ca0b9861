#ifdef TCERT_BINARY
#include "cli/attacks.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "reports/sha256.hpp"

namespace tcert {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using test_support::ProcessResult;
using test_support::Shell;

std::unique_ptr<Shell> Attacks::shell;

std::vector<std::string> hostile_ids() {
  std::vector<std::string> ids = {"..",
                                  ".",
                                  ".hidden",
                                  ".x.1-0.tmp",
                                  "../canary/x",
                                  "../../canary/x",
                                  "../../../canary/x",
                                  "a/../../../canary/x",
                                  "../canary",
                                  "series/../../canary/x",
                                  "a/b",
                                  "a\\..\\b",
                                  "~/x",
                                  "$HOME/x",
                                  "`touch x`/y",
                                  "x\ty",
                                  "\x1b[2J",
                                  "x\ny",
                                  "\x7F",
                                  std::string(231, 'a'),
                                  std::string(255, 'a'),
                                  std::string(5000, 'b'),
                                  "link/x",
                                  "manifest.json/x",
                                  "x\xC2\x9By/z"};
  for (int depth = 1; depth <= 8; ++depth) {
    std::string up;
    for (int k = 0; k < depth; ++k) {
      up += "../";
    }
    ids.push_back(up + "canary/planted");
    ids.push_back("x/" + up + "canary/planted");
  }
  return ids;
}

std::string csv_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    out += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return out + "\"";
}

void Attacks::SetUpTestSuite() {
  shell = std::make_unique<Shell>();
  const ProcessResult run = shell->run(
      "mkdir -p run && cd run && $T simulate --trials 6 --output tree/corpus && "
      "$T certify tree/corpus --output tree/certificates && mkdir -p canary out ../canary && "
      "echo mine > canary/x && echo mine > canary/x.csv && echo mine > ../canary/planted && "
      "echo mine > ../canary/planted.csv && ln -s ../canary link");
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
}

ProcessResult Attacks::attack(const std::string& line) {
  const auto before = shell->contents("", "run/out");
  ProcessResult run = shell->run("cd run && rm -rf out && mkdir out && timeout 60 " + line);
  const auto after = shell->contents("", "run/out");
  for (const auto& [path, bytes] : before) {
    const auto now = after.find(path);
    EXPECT_TRUE(now != after.end() && now->second == bytes) << path << "\n" << to_string(run);
  }
  for (const auto& [path, bytes] : after) {
    EXPECT_TRUE(before.count(path) == 1) << "planted: " << path << "\n" << to_string(run);
  }
  EXPECT_NE(run.exit_code, 70) << to_string(run);
  EXPECT_LT(run.exit_code, 124) << to_string(run);
  return run;
}

void Attacks::foreign_tree(const std::string& id) {
  fs::remove_all(shell->work() / "run/foreign");
  fs::copy(shell->work() / "run/tree", shell->work() / "run/foreign", fs::copy_options::recursive);
  const std::string folder = "run/foreign/certificates/";
  ordered_json manifest = ordered_json::parse(shell->work().read(folder + "manifest.json"));
  for (const char* name : {"certificates.csv", "features.csv"}) {
    std::string text = shell->work().read(folder + name);
    for (auto at = text.find("t0000000"); at != std::string::npos; at = text.find("t0000000")) {
      text.replace(at, 8, csv_quoted(id));
    }
    shell->work().write(folder + name, text);
    for (auto& output : manifest["outputs"]) {
      if (output["path"] == name) {
        output["bytes"] = text.size();
        output["sha256"] = sha256(text);
      }
    }
  }
  shell->work().write(folder + "manifest.json", manifest.dump(2) + "\n");
}

}  // namespace tcert
#endif
