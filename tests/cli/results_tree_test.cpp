/// A tree of results: verify, figures, and what they refuse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <table/read_data_table.hpp>

#include "support/temporary_folder.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::Workdir;

namespace fs = std::filesystem;

/// corpus, certificates, h1 of 120 trials; made once.
class ResultsTree : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    work = std::make_unique<Workdir>(TCERT_BINARY);
    const std::vector<std::vector<std::string>> steps = {
        {"simulate", "--trials", "120", "--output", "made/corpus"},
        {"certify", "made/corpus", "--output", "made/certificates"},
        {"hypotheses",
         "h1",
         "--features",
         "made/certificates/features.csv",
         "--replicates",
         "60",
         "--output",
         "made/h1/"}};
    for (const auto& step : steps) {
      const ProcessResult run = work->run(step);
      ASSERT_EQ(run.exit_code, 0) << to_string(run);
    }
  }
  static void TearDownTestSuite() { work.reset(); }

  /// A copy that a test may spoil.
  static void copy_to(const std::string& name) {
    fs::remove_all(work->path() / name);
    fs::copy(work->path() / "made", work->path() / name, fs::copy_options::recursive);
  }

  static std::unique_ptr<Workdir> work;
};

std::unique_ptr<Workdir> ResultsTree::work;

TEST_F(ResultsTree, StandsAsItWasMade) {
  const ProcessResult run = work->run({"verify", "made", "--format", "csv"});
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_NE(run.out.find("certificates,certify,"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find(",no,"), std::string::npos) << "everything is made again: " << run.out;
}

TEST_F(ResultsTree, NamesAnEditedFile) {
  copy_to("edited");
  work->write("edited/h1/h1.csv", work->read("made/h1/h1.csv") + "one more row\n");
  for (const bool files_only : {true, false}) {
    std::vector<std::string> words = {"verify", "edited"};
    if (files_only) {
      words.emplace_back("--files-only");
    }
    const ProcessResult run = work->run(words);
    EXPECT_EQ(run.exit_code, 1) << to_string(run);
    EXPECT_NE(run.err.find("h1: 'h1.csv'"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("certificates:"), std::string::npos) << run.err;
  }
}

TEST_F(ResultsTree, NamesAFileThatIsMissingFromAFolderOfMany) {
  copy_to("missing");
  fs::remove(work->path() / "missing/certificates/edges/t0000007.csv");
  const ProcessResult run = work->run({"verify", "missing"});
  EXPECT_EQ(run.exit_code, 1) << to_string(run);
  EXPECT_NE(run.err.find("'edges/t0000007.csv' is missing"), std::string::npos) << run.err;
}

TEST_F(ResultsTree, NamesAnInputThatChangedThoughEveryDigestFits) {
  copy_to("changed");
  const std::string log = "changed/corpus/logs/t0000003/tactile.csv";
  const std::string text = work->read(log);
  work->write(log, text.substr(0, text.rfind('\n', text.size() - 2) + 1));
  const ProcessResult run = work->run({"verify", "changed"});
  EXPECT_EQ(run.exit_code, 1) << to_string(run);
  EXPECT_NE(run.err.find("certificates: its input 'logs/' has changed"), std::string::npos)
      << run.err;
}

TEST_F(ResultsTree, DoesNotStandWithAManifestThatSaysOtherwise) {
  const std::string path = "falsified/certificates/manifest.json";
  const auto verified_with = [&](const std::string& text) {
    work->write(path, text);
    return work->run({"verify", "falsified"});
  };
  copy_to("falsified");
  const std::string manifest = work->read(path);
  const auto key = manifest.find("\"body_width_m\": ");
  ASSERT_NE(key, std::string::npos);
  std::string other = manifest;
  other.replace(key, manifest.find(',', key) - key, "\"body_width_m\": 0.987");
  const ProcessResult parameter = verified_with(other);
  EXPECT_EQ(parameter.exit_code, 1) << to_string(parameter);
  EXPECT_NE(parameter.err.find("the parameter body_width_m as '0.987'"), std::string::npos)
      << parameter.err;
  other = manifest;
  const auto digest = other.rfind("\"sha256\": \"");
  other.replace(digest + 11, 64, std::string(64, '0'));
  const ProcessResult zeroed = verified_with(other);
  EXPECT_EQ(zeroed.exit_code, 1) << to_string(zeroed);
  EXPECT_NE(zeroed.err.find("another digest of"), std::string::npos) << zeroed.err;
}

TEST_F(ResultsTree, NamesWhatNoManifestCovers) {
  copy_to("uncovered");
  fs::remove(work->path() / "uncovered/h1/manifest.json");
  work->write("uncovered/notes.txt", "looks like a result");
  const ProcessResult run = work->run({"verify", "uncovered", "--files-only"});
  EXPECT_EQ(run.exit_code, 1) << to_string(run);
  EXPECT_NE(run.err.find("'h1/' is no result"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("'notes.txt' is no result"), std::string::npos) << run.err;
}

TEST_F(ResultsTree, StandsWithEveryKindOfResultInIt) {
  copy_to("all");
  const std::vector<std::vector<std::string>> steps = {
      {"simulate", "--micro-study", "--output", "all/gates"},
      {"gate", "all/gates", "--output", "all/gate/"},
      {"replay", "all/corpus", "--output", "all/replays"},
      {"hypotheses", "h2", "--features", "all/certificates/features.csv", "--output", "all/h2/"},
      {"hypotheses", "h3", "--replays", "all/replays/replay.csv", "--output", "all/h3.md"},
      {"sweep",
       "all/corpus",
       "--grid",
       "beta_per_m=5,10",
       "--replicates",
       "60",
       "--no-cache",
       "--output",
       "all/sweep"},
      {"figures", "all", "--output", "all/figures"}};
  for (const auto& step : steps) {
    const ProcessResult run = work->run(step);
    ASSERT_EQ(run.exit_code, 0) << step[0] << ' ' << to_string(run);
  }
  const ProcessResult page = work->run({"report", "all", "--output", "all/report.html"});
  ASSERT_TRUE(page.exit_code == 0 || page.exit_code == 66) << to_string(page);
  const ProcessResult run = work->run({"verify", "all", "--format", "csv", "--threads", "2"});
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_EQ(run.out.find(",no,"), std::string::npos) << "everything is made again: " << run.out;
  for (const char* const name : {"figures,", "h3.md,", "sweep,", "gate,"}) {
    EXPECT_NE(run.out.find(name), std::string::npos) << name << run.out;
  }
  work->write("all/h3.md", work->read("all/h3.md") + "one more line\n");
  const ProcessResult edited = work->run({"verify", "all", "--files-only"});
  EXPECT_EQ(edited.exit_code, 1) << to_string(edited);
  EXPECT_NE(edited.err.find("h3.md: 'h3.md' was changed"), std::string::npos) << edited.err;
}

TEST_F(ResultsTree, APageOfNothingIsAnErrorThatSaysWhatIsMissing) {
  work->write("bare/notes.txt", "mine");
  const ProcessResult bare = work->run({"report", "bare", "--output", "bare.html"});
  EXPECT_EQ(bare.exit_code, 66) << to_string(bare);
  EXPECT_NE(bare.err.find("has a manifest.json, as 'tcert certify'"), std::string::npos)
      << bare.err;
  const ProcessResult logs = work->run({"report", "made/corpus", "--output", "bare.html"});
  EXPECT_EQ(logs.exit_code, 66) << to_string(logs);
  EXPECT_NE(
      logs.err.find("holds no table, only what 'tcert simulate' wrote; 'tcert certify BUNDLE"),
      std::string::npos)
      << logs.err;
  EXPECT_FALSE(fs::exists(work->path() / "bare.html"));
}

TEST_F(ResultsTree, InputsThatAreNotThereAreAnError) {
  const ProcessResult run = work->run({"verify", "made", "--inputs", "made", "--inputs", "store?"});
  EXPECT_EQ(run.exit_code, 66) << to_string(run);
  EXPECT_NE(run.err.find("--inputs: there is no 'store?'"), std::string::npos) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST_F(ResultsTree, ReproducedLosesWhatIsNotMadeAgain) {
  const std::vector<std::string> again = {
      "reproduce", "made/corpus", "--output", "rep", "--no-series", "--quiet"};
  const std::vector<std::string> sweep = {"sweep",
                                          "made/corpus",
                                          "--grid",
                                          "beta_per_m=5,10",
                                          "--replicates",
                                          "60",
                                          "--output",
                                          "rep/sensitivity"};
  ASSERT_EQ(work->run(sweep).exit_code, 0);
  ASSERT_EQ(work->run({"simulate", "--micro-study", "--output", "rep/gates"}).exit_code, 0);
  std::vector<std::string> other = again;
  other.insert(other.end(), {"--set", "body_width_m=0.5"});
  const ProcessResult run = work->run(other);
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_FALSE(fs::exists(work->path() / "rep/sensitivity"));
  EXPECT_FALSE(fs::exists(work->path() / "rep/gates"));
  ASSERT_EQ(work->run(sweep).exit_code, 0);
  work->write("rep/sensitivity/mine.txt", "mine");
  const ProcessResult refused = work->run(again);
  EXPECT_EQ(refused.exit_code, 73) << to_string(refused);
  EXPECT_EQ(work->read("rep/sensitivity/mine.txt"), "mine");
}

TEST_F(ResultsTree, CannotBeVerifiedWithoutItsInputs) {
  copy_to("alone");
  fs::rename(work->path() / "alone/corpus", work->path() / "elsewhere");
  const ProcessResult run = work->run({"verify", "alone"});
  EXPECT_EQ(run.exit_code, 66) << to_string(run);
  EXPECT_NE(run.err.find("its input 'corpus' cannot be found"), std::string::npos) << run.err;
  fs::create_directory(work->path() / "store");
  fs::rename(work->path() / "elsewhere", work->path() / "store/corpus");
  EXPECT_EQ(work->run({"verify", "alone", "--inputs", "store"}).exit_code, 0);
  EXPECT_EQ(work->run({"verify", "nowhere"}).exit_code, 66);
}

TEST_F(ResultsTree, KeepsTheManifestFreeOfPlaces) {
  for (const char* part : {"certificates", "h1"}) {
    const std::string manifest = work->read(std::string("made/") + part + "/manifest.json");
    EXPECT_EQ(manifest.find("made/"), std::string::npos) << manifest;
    EXPECT_EQ(manifest.find(work->path().string()), std::string::npos) << manifest;
  }
}

TEST_F(ResultsTree, OfDifferentInputsIsNotDrawn) {
  copy_to("mixed");
  const ProcessResult again = work->run(
      {"certify", "made/corpus", "--set", "memory_weight_m=0", "--output", "mixed/certificates"});
  ASSERT_EQ(again.exit_code, 0) << to_string(again);
  const ProcessResult run = work->run({"figures", "mixed", "--output", "drawn"});
  EXPECT_EQ(run.exit_code, 65) << to_string(run);
  EXPECT_NE(run.err.find("'certificates' and 'h1'"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(work->path() / "drawn"));
}

TEST_F(ResultsTree, IsDrawnTheSameTwice) {
  for (const char* folder : {"one", "two"}) {
    const ProcessResult run = work->run({"figures", "made", "--output", folder});
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
    if (std::string(folder) == "one") {
      EXPECT_NE(run.err.find("pareto is left out"), std::string::npos) << run.err;
    }
  }
  const std::vector<std::string> files = work->files("one");
  EXPECT_EQ(files, work->files("two"));
  bool drawn = false;
  for (const std::string& file : files) {
    EXPECT_EQ(work->read("one/" + file), work->read("two/" + file)) << file;
    drawn = drawn || file == "roc.svg";
  }
  for (const char* name : {"roc.vl.json", "roc.csv", "roc.gp", "speed_by_algorithm.csv"}) {
    EXPECT_NE(std::find(files.begin(), files.end(), name), files.end()) << name;
  }
  if (!drawn) {
    GTEST_SKIP() << "no SVG and PDF: gnuplot is not installed";
  }
  EXPECT_NE(work->read("one/roc.svg").find("SYNTHETIC"), std::string::npos);
  EXPECT_EQ(work->read("one/roc.pdf").substr(0, 5), "%PDF-");
}

TEST_F(ResultsTree, DrawsRocCurvesWhoseAreasAreTheAucsOfTheTable) {
  const table::DataTable roc = *table::read_data_table(work->path() / "made/h1/h1_roc.csv").table;
  const table::DataTable h1 = *table::read_data_table(work->path() / "made/h1/h1.csv").table;
  const auto key = [](const table::DataTable& table, std::size_t row) {
    const table::Factor& panel = table.find("panel")->text;
    const table::Factor& predictor = table.find("predictor")->text;
    return panel.levels[panel.codes[row]] + '/' + predictor.levels[predictor.codes[row]];
  };
  std::map<std::string, double> area;
  const std::vector<double>& sensitivity = roc.find("sensitivity")->numbers;
  const std::vector<double>& specificity = roc.find("specificity")->numbers;
  for (std::size_t row = 1; row < roc.rows; ++row) {
    if (key(roc, row) == key(roc, row - 1)) {
      area[key(roc, row)] += (specificity[row] - specificity[row - 1]) *
                             (sensitivity[row] + sensitivity[row - 1]) / 2.0;
    }
  }
  ASSERT_GT(h1.rows, 0U);
  for (std::size_t row = 0; row < h1.rows; ++row) {
    EXPECT_NEAR(area[key(h1, row)], h1.find("auc")->numbers[row], 1e-12) << key(h1, row);
  }
}

TEST_F(ResultsTree, KeepsTheGraphOfEveryTrial) {
  const table::DataTable certificates =
      *table::read_data_table(work->path() / "made/certificates/certificates.csv").table;
  const table::DataColumn& ids = *certificates.find("trial_id");
  for (std::size_t row = 0; row < certificates.rows; ++row) {
    const std::string& id = ids.text.levels[ids.text.codes[row]];
    const table::DataTable edges =
        *table::read_data_table(work->path() / "made/certificates/edges" / (id + ".csv")).table;
    EXPECT_EQ(static_cast<double>(edges.rows), certificates.find("edges")->numbers[row]) << id;
    const double bottleneck = certificates.find("bottleneck_edge")->numbers[row];
    if (!std::isnan(bottleneck)) {
      const auto at = static_cast<std::size_t>(bottleneck);
      EXPECT_EQ(edges.find("margin_m")->numbers[at],
                certificates.find("certificate_m")->numbers[row])
          << id << ": the bottleneck is the edge that decides T_t";
    }
  }
}

TEST_F(ResultsTree, HasEveryTableInEveryFormat) {
  const std::vector<std::string> files = work->files("made/h1");
  for (const char* name : {"h1.csv",
                           "h1.json",
                           "h1.tex",
                           "h1.md",
                           "h1.txt",
                           "h1_roc.csv",
                           "h1_calibration.json",
                           "h1_incidence_curve.csv",
                           "issued.json",
                           "report.json",
                           "manifest.json"}) {
    EXPECT_NE(std::find(files.begin(), files.end(), name), files.end()) << name;
  }
}

}  // namespace
}  // namespace tcert
