#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <map>
#include <string>

#include "datasets/bundle.hpp"
#include "datasets/corpus/corpus.hpp"
#include "datasets/corpus/micro_study.hpp"
#include "datasets/trial_reader.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;

using test_support::read_text;

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
    }
  }
  return files;
}

CorpusOptions few_trials() {
  CorpusOptions options;
  options.seed = 7;
  options.trials = 700;
  options.subset = {0, 1, 2, 650, 661};
  return options;
}

TEST(SimulateCorpus, ReadsBackAsItWasSimulatedWithoutADiagnostic) {
  const test_support::TemporaryFolder folder;
  const fs::path path = folder.path() / "corpus";
  const CorpusOptions options = few_trials();
  simulate_corpus(path, options);
  const BundleResult result = open_bundle(path);
  ASSERT_TRUE(result.bundle);
  EXPECT_TRUE(result.diagnostics.empty()) << table::to_string(result.diagnostics.front());
  ASSERT_EQ(result.bundle->trials.size(), options.subset.size());
  EXPECT_TRUE(result.bundle->info.synthetic);
  EXPECT_EQ(result.bundle->info.seed, 7U);
  for (std::size_t i = 0; i < options.subset.size(); ++i) {
    const SimulatedTrial made = simulate_trial(design_trial(options, options.subset[i]));
    const TrialRow& row = result.bundle->trials[i];
    EXPECT_EQ(row.trial_id, made.row.trial_id);
    EXPECT_EQ(row.algorithm, made.row.algorithm);
    EXPECT_EQ(row.success, made.row.success);
    EXPECT_EQ(row.time_s, made.row.time_s);
    EXPECT_EQ(row.distance_m, made.row.distance_m);
    EXPECT_EQ(row.end_reason, made.row.end_reason);
    const TrialResult read = read_trial(*result.bundle, row);
    ASSERT_TRUE(read.log);
    EXPECT_TRUE(read.diagnostics.empty()) << table::to_string(read.diagnostics.front());
    EXPECT_EQ(read.log->pose.time_ns, made.log.pose.time_ns);
    EXPECT_EQ(read.log->tactile.time_ns, made.log.tactile.time_ns);
    EXPECT_EQ(read.log->control.speed_cmd_mps, made.log.control.speed_cmd_mps);
    EXPECT_EQ(read.log->control.loop_latency_ms, made.log.control.loop_latency_ms);
    ASSERT_EQ(read.log->tactile.readings.size(), made.log.tactile.readings.size());
    for (std::size_t j = 0; j < made.log.tactile.readings.size(); ++j) {
      ASSERT_EQ(read.log->tactile.readings[j].value, made.log.tactile.readings[j].value);
      ASSERT_EQ(read.log->tactile.readings[j].fsr_n, made.log.tactile.readings[j].fsr_n);
    }
    for (std::size_t j = 0; j < made.log.pose.poses.size(); ++j) {
      ASSERT_EQ(read.log->pose.poses[j].position, made.log.pose.poses[j].position);
    }
    const std::string world = read_text(path / "worlds" / (row.trial_id + ".json"));
    EXPECT_EQ(to_json(world_from_json(world)), world);
  }
}

TEST(SimulateCorpus, SaysInTheFirstLineOfEachFileThatItIsSynthetic) {
  const test_support::TemporaryFolder folder;
  simulate_corpus(folder.path() / "corpus", few_trials());
  simulate_micro_study(folder.path() / "gates", 7);
  const auto files = files_of(folder.path());
  EXPECT_EQ(files.size(), 2U + 5U * 4U + 2U + 60U * 4U);
  for (const auto& [name, text] : files) {
    const bool is_csv = fs::path(name).extension() == ".csv";
    const std::string head = text.substr(0, is_csv ? text.find('\n') : 200);
    EXPECT_NE(head.find("synthetic"), std::string::npos) << name;
    if (is_csv) {
      EXPECT_EQ(head, "# synthetic, seed 7") << name;
    }
  }
}

TEST(SimulateCorpus, GivesTheSameBytesForAnyNumberOfThreads) {
  const test_support::TemporaryFolder folder;
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const fs::path path = folder.path() / std::to_string(threads);
    simulate_corpus(path, few_trials());
    return files_of(path);
  };
  EXPECT_EQ(with_threads(1), with_threads(4));
}

TEST(SimulateCorpus, ReportsEachTrialOnce) {
  const test_support::TemporaryFolder folder;
  std::uint64_t calls = 0;
  std::uint64_t last = 0;
  simulate_corpus(
      folder.path() / "corpus", few_trials(), [&](std::uint64_t done, std::uint64_t total) {
        ++calls;
        EXPECT_EQ(done, calls);
        EXPECT_EQ(total, 5U);
        last = done;
      });
  EXPECT_EQ(last, 5U);
}

TEST(SimulateMicroStudy, ReadsBackWithItsColumns) {
  const test_support::TemporaryFolder folder;
  simulate_micro_study(folder.path() / "gates", 1);
  const BundleResult result = open_bundle(folder.path() / "gates");
  ASSERT_TRUE(result.bundle);
  EXPECT_TRUE(result.diagnostics.empty()) << table::to_string(result.diagnostics.front());
  EXPECT_EQ(result.bundle->trials.size(), 60U);
  EXPECT_EQ(result.bundle->extra_columns,
            (std::vector<std::string>{"true_margin_m", "gate_width_m", "entry_side"}));
}

}  // namespace
}  // namespace tcert
