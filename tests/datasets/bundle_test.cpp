#include "datasets/bundle.hpp"

#include <gtest/gtest.h>
#include <zip.h>

#include <string>
#include <vector>

#include "datasets/bundle_json.hpp"
#include "datasets/trial_reader.hpp"
#include "datasets/trial_table.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

using Messages = std::vector<std::string>;
using test_support::TemporaryFolder;

constexpr const char* kSmallest = R"({"format":"tcert-bundle","version":1,"robot":{},
"rays":[{"name":"left","bearing_rad":1.5,"reach_m":0.6,"kind":"range"}]})";

constexpr const char* kFull = R"({
  "format": "tcert-bundle", "version": 1, "synthetic": true, "seed": 18446744073709551615,
  "provenance": "synthetic, seed 7",
  "robot": {"body_width_m":0.4,"min_turn_radius_m":0.3,"tracking_buffer_m":0.01,"curvature_buffer_per_m":0.02},
  "rays": [{"name":"left","mount_x_m":0.2,"mount_y_m":0.1,"bearing_rad":1.5708,"reach_m":0.6,"kind":"bend",
            "calibration":{"bend_rad":[0,1.2],"clearance_m":[0.6,0.0]}},
           {"name":"b0","bearing_rad":0,"reach_m":8,"kind":"range","no_return":[0,"inf",-1],"range_min_m":0.1,
            "range_max_m":60}],
  "course": {"start":{"disc":{"x_m":1,"y_m":2,"radius_m":0.5}}, "goal":{"polygon":[[0,0],[1,0],[1,1]]}},
  "lighting": ["Dark","Indoor"], "trial_limit_s": 180, "max_gap_s": 2.5, "start_at": "pose",
  "columns": {"pose.csv":{"x":"x_m"}},
  "parameters": {"edge_length_m": 1.5, "curvature": "none"}
})";

Messages messages(std::vector<table::Diagnostic> diagnostics) {
  Messages out;
  for (const table::Diagnostic& diagnostic : diagnostics) {
    out.push_back(table::to_string(diagnostic));
  }
  return out;
}

Messages json_problems(std::string_view text) {
  table::DiagnosticGroups problems;
  const auto info = parse_bundle_json(text, problems);
  EXPECT_NE(info.has_value(), problems.has_error());
  return messages(problems.take());
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(ParseBundleJson, ReadsEveryKey) {
  table::DiagnosticGroups problems;
  const auto info = parse_bundle_json(kFull, problems);
  ASSERT_TRUE(info) << ::testing::PrintToString(messages(problems.take()));
  EXPECT_TRUE(info->synthetic);
  EXPECT_EQ(info->seed, 18446744073709551615U);
  EXPECT_EQ(info->robot.body_width_m, 0.4);
  EXPECT_EQ(info->robot.rays[0].calibration.clearance_m, (std::vector<double>{0.6, 0.0}));
  EXPECT_EQ(info->robot.rays[1].kind, RayKind::range);
  EXPECT_EQ(std::get<Disc>(*info->course.start).centre, (Point{1, 2}));
  EXPECT_EQ(std::get<Polygon>(*info->course.goal).vertices.size(), 3U);
  EXPECT_EQ(info->trial_limit_s, 180);
  EXPECT_EQ(info->max_gap_s, 2.5);
  EXPECT_EQ(info->start_at, StartAt::pose);
  EXPECT_EQ(info->range_keys[1].no_return, (std::vector<double>{0, -1}));
  EXPECT_EQ(info->range_keys[1].range_min_m, 0.1);
  EXPECT_EQ(info->range_keys[1].range_max_m, 60);
  EXPECT_EQ(info->columns.at("pose.csv").at("x"), "x_m");
  EXPECT_EQ(info->parameters.at("edge_length_m"), "1.5");
  EXPECT_EQ(info->parameters.at("curvature"), "none");
}

TEST(ParseBundleJson, TakesDefaultsForWhatIsOptional) {
  table::DiagnosticGroups problems;
  const auto info = parse_bundle_json(kSmallest, problems);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->robot.body_width_m, 0.45);
  EXPECT_EQ(info->max_gap_s, 1.0);
  EXPECT_FALSE(info->course.goal);
}

TEST(ParseBundleJson, ReadsBackWhatItWrites) {
  table::DiagnosticGroups problems;
  for (const char* text : {kSmallest, kFull}) {
    const std::string written = to_bundle_json(*parse_bundle_json(text, problems));
    EXPECT_EQ(to_bundle_json(*parse_bundle_json(written, problems)), written);
  }
}

TEST(ParseBundleJson, NamesUnknownKeysWithTheNearestKnownOne) {
  EXPECT_EQ(
      json_problems(with(with(kFull, "body_width_m", "body_widht_m"), "lighting", "lightning")),
      (Messages{
          "bundle.json: error: column 'lightning': expected a known key; did you mean "
          "'lighting'?",
          "bundle.json: error: column 'robot.body_widht_m': expected a known key; did you mean "
          "'body_width_m'?"}));
}

TEST(ParseBundleJson, NamesABodyThatIsNotInMetres) {
  EXPECT_EQ(json_problems(with(kFull, R"("body_width_m":0.4)", R"("body_width_m":400)")),
            (Messages{"bundle.json: warning: column 'robot.body_width_m': found '400', expected "
                      "metres: millimetres, centimetres?"}));
}

TEST(ParseBundleJson, NamesEveryWrongValue) {
  EXPECT_EQ(
      json_problems(R"({"format":"other","version":2,"robot":{"body_width_m":"wide"},
      "rays":[{"name":"a b","reach_m":1,"kind":"sonar","bearing_rad":0}],
      "course":{"start":{}},"seed":-1,"max_gap_s":0})"),
      (Messages{"bundle.json: error: column 'format': found '\"other\"', expected "
                "\"tcert-bundle\"",
                "bundle.json: error: column 'version': found '2', expected 1",
                "bundle.json: error: column 'seed': found '-1', expected a whole number, 0 or "
                "more",
                "bundle.json: error: column 'robot.body_width_m': found '\"wide\"', expected a "
                "number",
                "bundle.json: error: column 'rays[0].name': found '\"a b\"', expected letters, "
                "digits and _ . - only: it is part of column names",
                "bundle.json: error: column 'rays[0].kind': found '\"sonar\"', expected "
                "\"bend\" or \"range\"",
                "bundle.json: error: column 'course.start': found '{}', expected either a disc "
                "or a polygon",
                "bundle.json: error: column 'max_gap_s': found '0.0', expected a number above "
                "0"}));
}

TEST(ParseBundleJson, RefusesACourseWhoseRegionsOverlap) {
  const auto messages = json_problems(
      with(kFull, R"("polygon":[[0,0],[1,0],[1,1]])", R"("polygon":[[0,0],[1.2,1.6],[1,0]])"));
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("expected a region apart from 'start'"), std::string::npos);
}

TEST(ParseBundleJson, NamesWhatARangeCannotMean) {
  const std::string keys = R"("no_return":[0,"inf",-1],"range_min_m":0.1)";
  EXPECT_EQ(json_problems(with(kFull, keys, R"("no_return":[0,"none"],"range_min_m":-1)")),
            (Messages{"bundle.json: error: column 'rays[1].no_return': found '[0,\"none\"]', "
                      "expected a list of at most 16 numbers and \"inf\"",
                      "bundle.json: error: column 'rays[1].range_min_m': found '-1.0', expected a "
                      "number from 0"}));
  EXPECT_EQ(json_problems(with(kFull, "\"range_min_m\":0.1", "\"range_min_m\":60")).size(), 1U);
  EXPECT_EQ(json_problems(with(kFull, R"("reach_m":0.6,)", R"("reach_m":0.6,"no_return":[0],)")),
            (Messages{"bundle.json: error: column 'rays[0].no_return': found '[0]', expected none: "
                      "only a ray of kind range reads ranges"}));
  EXPECT_EQ(
      json_problems(with(kFull, R"("start_at": "pose")", R"("start_at": "touch")")),
      (Messages{"bundle.json: error: column 'start_at': found '\"touch\"', expected \"both\" or "
                "\"pose\""}));
}

TEST(ParseBundleJson, SaysWhatTheRobotCannotBe) {
  EXPECT_EQ(json_problems(with(kFull, "[0,1.2]", "[1.2,0]")).size(), 1U);
  EXPECT_EQ(json_problems(with(kFull, "\"b0\"", "\"Left\"")),
            (Messages{"bundle.json: error: column 'rays[1].name': found '\"Left\"', expected ray "
                      "names that differ when case is folded"}));
}

TEST(ParseBundleJson, NamesTheLineOfASyntaxErrorAndAKeyGivenTwice) {
  EXPECT_TRUE(
      json_problems("{\n\"format\": oops}")[0].starts_with("bundle.json:2: error: found '"));
  EXPECT_EQ(json_problems(with(kSmallest, "\"version\":1", "\"version\":1,\"version\":1")),
            (Messages{"bundle.json: error: column 'version': expected each key once"}));
  EXPECT_EQ(json_problems("[]"),
            (Messages{"bundle.json: error: found '[]', expected an object {...}"}));
}

struct Opened {
  BundleResult result;
  Messages messages;
};

Opened open_with_trials(std::string_view trials, const BundleOptions& options = {}) {
  const TemporaryFolder folder;
  folder.write("bundle.json", kFull);
  folder.write("trials.csv", trials);
  Opened opened;
  opened.result = open_bundle(folder.path(), options);
  opened.messages = messages(opened.result.diagnostics);
  return opened;
}

TEST(OpenBundle, ReadsTrialsAndCarriesFurtherColumnsThrough) {
  const Opened opened = open_with_trials(
      "trial_id,success,time_s,wheel,lighting,end_reason,distance_m\n"
      "t1,True,61.5,\"a,b\",Dark,goal,12\n"
      "t2,,,x,,,\n");
  EXPECT_EQ(opened.messages, Messages{});
  ASSERT_TRUE(opened.result.bundle);
  const Bundle& bundle = *opened.result.bundle;
  EXPECT_EQ(bundle.extra_columns, (std::vector<std::string>{"wheel"}));
  ASSERT_EQ(bundle.trials.size(), 2U);
  EXPECT_EQ(bundle.trials[0].success, true);
  EXPECT_EQ(bundle.trials[0].time_s, 61.5);
  EXPECT_EQ(bundle.trials[0].end_reason, EndReason::goal);
  EXPECT_EQ(bundle.trials[0].extra, (std::vector<std::string>{"a,b"}));
  EXPECT_EQ(bundle.trials[1].success, std::nullopt);
  EXPECT_EQ(bundle.trials[1].time_s, std::nullopt);
}

TEST(OpenBundle, ReadsWordsAsEveryOtherTableDoes) {
  const Opened opened = open_with_trials(
      "trial_id,success,time_s,lighting,distance_m,end_reason\n"
      "t1,s,-nan,NA,nan(ind),NA\nt2,fail,12,Dark,3,\nt3,OK,1e1,,0x8,goal\nt4,-nan,1,Dark,3,\n"
      "t5,N/A,1,,,\nt6,1,null,,,\nt7,1,+inf,,,\n");
  ASSERT_TRUE(opened.result.bundle);
  const auto& trials = opened.result.bundle->trials;
  ASSERT_EQ(trials.size(), 4U);
  EXPECT_EQ(trials[0].success, true);
  EXPECT_EQ(trials[0].time_s, std::nullopt);
  EXPECT_EQ(trials[0].lighting, "");
  EXPECT_EQ(trials[0].end_reason, EndReason::unknown);
  EXPECT_EQ(trials[1].success, false);
  EXPECT_EQ(trials[2].success, true);
  EXPECT_EQ(trials[2].time_s, 10.0);
  EXPECT_EQ(trials[2].distance_m, 8.0);
  EXPECT_EQ(trials[3].success, std::nullopt);
  ASSERT_EQ(opened.messages.size(), 2U);
  EXPECT_EQ(opened.messages[0].find("trials.csv:6: error: column 'success': found 'N/A'"), 0U);
  EXPECT_EQ(opened.messages[1],
            "trials.csv:7: error: column 'time_s': found 'null', expected a finite number, 0 or "
            "more (a missing cell is empty, NA or nan); the trial is rejected (and 1 more)");
}

TEST(OpenBundle, RejectsTrialsWithASuccessThatIsNeitherOrANegativeTime) {
  const Opened opened =
      open_with_trials("trial_id,success,time_s\nt1,maybe,1\nt2,1,-1\nt3,0,5\n../t4,1,1\nt5,1\n");
  EXPECT_EQ(
      opened.messages,
      (Messages{
          "trials.csv:6: error: found '2 fields', expected 3 fields",
          "trials.csv:2: error: column 'success': found 'maybe', expected 1 or 0, true or false, "
          "success or failure, s or f, ok or fail, pass or fail, yes or no, in any case (a missing "
          "cell is empty, NA or nan); the trial is rejected",
          "trials.csv:3: error: column 'time_s': found '-1', expected a finite number, 0 or "
          "more (a missing cell is empty, NA or nan); the trial is rejected",
          "trials.csv:5: error: column 'trial_id': found '../t4', expected a name that "
          "can be that of a file: not empty, without / and \\ and control characters, no '.' at "
          "its "
          "beginning, at most 230 bytes; the trial is rejected"}));
  ASSERT_TRUE(opened.result.bundle);
  ASSERT_EQ(opened.result.bundle->trials.size(), 1U);
  EXPECT_EQ(opened.result.bundle->trials[0].trial_id, "t3");
}

TEST(OpenBundle, RejectsAllRowsOfATrialIdGivenTwice) {
  const Opened opened = open_with_trials("trial_id,success,time_s\nt1,1,1\nt2,1,1\nt1,0,2\n");
  EXPECT_EQ(
      opened.messages,
      (Messages{"trials.csv:4: error: column 'trial_id': found 't1', expected a trial_id that "
                "no other row has; all rows of it are rejected"}));
  ASSERT_EQ(opened.result.bundle->trials.size(), 1U);
}

TEST(OpenBundle, WarnsOfATimeBeyondTenTrialLimitsAndOfAnUnknownTier) {
  const Opened opened = open_with_trials("trial_id,success,time_s,lighting\nt1,0,1801,Dusk\n");
  EXPECT_EQ(opened.messages,
            (Messages{"trials.csv:2: warning: column 'time_s': found '1801', expected at most ten "
                      "times the trial limit",
                      "trials.csv:2: warning: column 'lighting': found 'Dusk', expected one of the "
                      "tiers of bundle.json"}));
  EXPECT_EQ(opened.result.bundle->trials.size(), 1U);
}

TEST(OpenBundle, HasNoBundleWithoutTrialsOrWithoutARequiredColumn) {
  const Opened none = open_with_trials("trial_id,success,time_s\n");
  EXPECT_FALSE(none.result.bundle);
  EXPECT_EQ(none.messages,
            (Messages{"trials.csv: error: found 'no rows', expected at least one trial"}));
  const Opened missing = open_with_trials("trial_id,success\nt1,1\n");
  EXPECT_FALSE(missing.result.bundle);
  EXPECT_EQ(missing.messages,
            (Messages{"trials.csv:1: error: column 'time_s': expected a column of this name in the "
                      "header; rename a foreign one under 'columns' in bundle.json"}));
}

TEST(OpenBundle, TakesADecimalCommaWhenAskedFor) {
  const Opened opened =
      open_with_trials("trial_id;success;time_s\nt1;1;61,5\n", BundleOptions{true});
  ASSERT_TRUE(opened.result.bundle);
  EXPECT_EQ(opened.result.bundle->trials[0].time_s, 61.5);
}

TEST(OpenBundle, NamesWhatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_EQ(messages(open_bundle(folder.path()).diagnostics),
            (Messages{"bundle.json: error: expected this file in the bundle",
                      "trials.csv: error: expected this file in the bundle"}));
  EXPECT_EQ(
      messages(open_bundle("/no/such").diagnostics),
      (Messages{"/no/such: error: found 'No such file or directory', expected a folder or a .zip "
                "with a bundle.json"}));
  const auto text = folder.write("a.zip", "not a zip");
  EXPECT_EQ(messages(open_bundle(text).diagnostics),
            (Messages{text.string() + ": error: found 'Not a zip archive', expected a folder or a "
                                      ".zip with a bundle.json"}));
}

TEST(OpenBundle, ReadsAZipWithOrWithoutAFolderInIt) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> contents{
      {"bundle.json", kSmallest},
      {"trials.csv", "trial_id,success,time_s\nt1,1,1\n"},
      {"logs/t1/pose.csv", "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n1,1,0,0\n"},
      {"logs/t1/tactile.csv", "time_s,left_range_m\n0,0.5\n1,0.5\n"}};
  for (const std::string prefix : {"", "my bundle/"}) {
    const std::string path = (folder.path() / (prefix.empty() ? "a.zip" : "b.zip")).string();
    zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
    for (const auto& [name, text] : contents) {
      zip_source_t* source = zip_source_buffer(archive, text.data(), text.size(), 0);
      zip_file_add(archive, (prefix + name).c_str(), source, 0);
    }
    ASSERT_EQ(zip_close(archive), 0);
    const BundleResult opened = open_bundle(path);
    ASSERT_TRUE(opened.bundle) << ::testing::PrintToString(messages(opened.diagnostics));
    const TrialResult trial = read_trial(*opened.bundle, opened.bundle->trials[0]);
    ASSERT_TRUE(trial.log) << ::testing::PrintToString(messages(trial.diagnostics));
    EXPECT_EQ(trial.log->pose.time_ns.size(), 2U);
  }
}

TEST(ToTrialsCsv, ReadsBackAsTheSameRows) {
  const Opened opened = open_with_trials(
      "trial_id,algorithm,lighting,day,batch,success,time_s,distance_m,end_reason,note\n"
      "t1,CB-V,Dark,d1,b1,1,61.53,,goal,\"a,\"\"b\"\"\"\nt2,,,,,,,,,\n");
  ASSERT_TRUE(opened.result.bundle);
  const Bundle& bundle = *opened.result.bundle;
  const std::string text = to_trials_csv(bundle.trials, bundle.extra_columns);
  const Opened again = open_with_trials(text);
  ASSERT_TRUE(again.result.bundle);
  EXPECT_EQ(to_trials_csv(again.result.bundle->trials, again.result.bundle->extra_columns), text);
}

}  // namespace
}  // namespace tcert
