#include "reports/results/results.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

Manifest manifest_of(const std::string& command, const std::string& log) {
  Manifest manifest;
  manifest.command = command;
  manifest.synthetic = SyntheticLabel{5};
  manifest.parameters = {{"edge_length_m", "0.25"}};
  manifest.inputs = {{"logs/", {1, 3, sha256(log)}}};
  return manifest;
}

void write_result(const fs::path& folder, Manifest manifest, const std::string& file = "a.csv") {
  write(folder / file, "x\n" + manifest.command + "\n");
  manifest.outputs = folder_outputs(folder);
  write(folder / "manifest.json", to_json(manifest));
}

Manifest hypothesis(const std::string& name, const fs::path& features) {
  Manifest manifest;
  manifest.command = "hypotheses";
  manifest.arguments = {{name}, {"--features"}, {"features.csv", true}};
  manifest.inputs = {{"features.csv", digest_file(features)}};
  return manifest;
}

TEST(Results, AreFoundByTheirManifests) {
  const test_support::TemporaryFolder folder;
  write_result(folder.path() / "b", manifest_of("replay", "1"), "replay.csv");
  write_result(folder.path() / "a", manifest_of("certify", "1"), "features.csv");
  write_result(folder.path() / "h", hypothesis("h1", folder.path() / "a/features.csv"));
  write(folder.path() / "c/notes.txt", "not a result");
  const Results results = read_results(folder.path());
  ASSERT_EQ(results.all.size(), 3U);
  EXPECT_EQ(results.all[0].name, "a");
  EXPECT_EQ(results.find(ResultKind::replays)->name, "b");
  EXPECT_EQ(results.find(ResultKind::h1)->name, "h");
  EXPECT_EQ(results.find(ResultKind::h2), nullptr);
  EXPECT_EQ(results.synthetic->seed, 5U);
  EXPECT_EQ(results.find(ResultKind::h1)->manifest.arguments->size(), 3U);
  EXPECT_TRUE(results.find(ResultKind::h1)->manifest.arguments->at(2).is_input);
  EXPECT_NO_THROW(require_same_inputs(results));
}

TEST(Results, MayBeOneFolder) {
  const test_support::TemporaryFolder folder;
  write_result(folder.path() / "a", manifest_of("certify", "1"));
  const Results results = read_results(folder.path() / "a");
  ASSERT_EQ(results.all.size(), 1U);
  EXPECT_EQ(results.all[0].name, ".");
}

TEST(Results, AreMissingWhereThereAreNone) {
  const test_support::TemporaryFolder folder;
  EXPECT_THROW((void)read_results(folder.path()), MissingResult);
  EXPECT_THROW((void)read_results(folder.path() / "nowhere"), MissingResult);
}

TEST(Results, OfDifferentLogsAreRefusedByName) {
  const test_support::TemporaryFolder folder;
  write_result(folder.path() / "a", manifest_of("certify", "1"));
  write_result(folder.path() / "b", manifest_of("replay", "2"));
  try {
    require_same_inputs(read_results(folder.path()));
    FAIL() << "nothing refused";
  } catch (const MixedResults& error) {
    const std::string words = error.what();
    EXPECT_NE(words.find("'a' and 'b'"), std::string::npos) << words;
    EXPECT_NE(words.find("'logs/'"), std::string::npos) << words;
  }
}

TEST(Results, OfDifferentParametersAreRefused) {
  const test_support::TemporaryFolder folder;
  write_result(folder.path() / "a", manifest_of("certify", "1"));
  Manifest other = manifest_of("replay", "1");
  other.parameters[0].second = "0.5";
  write_result(folder.path() / "b", other);
  EXPECT_THROW(require_same_inputs(read_results(folder.path())), MixedResults);
}

TEST(Results, OfTheMicroStudyHaveLogsOfTheirOwn) {
  const test_support::TemporaryFolder folder;
  write_result(folder.path() / "a", manifest_of("certify", "1"));
  write_result(folder.path() / "b", manifest_of("gate", "2"));
  EXPECT_NO_THROW(require_same_inputs(read_results(folder.path())));
}

TEST(Results, OfFeaturesThatWereMadeAnewAreRefused) {
  const test_support::TemporaryFolder folder;
  write_result(folder.path() / "a", manifest_of("certify", "1"), "features.csv");
  Manifest stale = hypothesis("h2", folder.path() / "a/features.csv");
  stale.inputs[0].digest.sha256 = sha256("other features");
  write_result(folder.path() / "h", stale);
  EXPECT_THROW(require_same_inputs(read_results(folder.path())), MixedResults);
}

TEST(Differences, AreNamedWithWhatHappened) {
  const test_support::TemporaryFolder folder;
  const fs::path a = folder.path() / "a";
  write(a / "gone.csv", "1");
  write(a / "series/t1.csv", "1");
  write_result(a, manifest_of("certify", "1"));
  const WrittenResult written = *read_manifest(a / "manifest.json");
  EXPECT_TRUE(differences(a, written).empty());
  fs::remove(a / "gone.csv");
  write(a / "a.csv", "edited");
  write(a / "series/t1.csv", "edited");
  write(a / "new.csv", "1");
  std::string found;
  for (const FileDifference& one : differences(a, written)) {
    found += one.path + ' ' + std::string(to_string(one.change)) + '\n';
  }
  EXPECT_EQ(found,
            "a.csv was changed\ngone.csv is missing\nnew.csv was added\nseries/ was changed\n");
}

}  // namespace
}  // namespace tcert
