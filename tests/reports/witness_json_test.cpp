#include "reports/witness_json.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>

#include "analysis/study/witness/felt_samples.hpp"
#include "analysis/study/witness/prove_trial.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/random_run.hpp"
#include "reports/witness_check.hpp"

namespace tcert {
namespace {

constexpr std::size_t kRoom = std::size_t{1} << 24U;
const std::string kLog(64, 'a');

struct Case {
  BundleInfo info;
  study::ParameterSet parameters;
  TrialLog log;
  WitnessDocument document;
};

/// A run through a random world without noise, and its witness.
Case proven(std::uint64_t index) {
  const RandomWorld drawn = draw_random_world(WorldFamily::discs, 9, index);
  const WallIndex walls = feelable_walls(drawn);
  Case made;
  made.log.merged = true_ticks(follow_legs(drawn, walls, 9, index), walls);
  made.info.robot = corpus_robot();
  made.info.course = {drawn.world.start, drawn.world.goal};
  made.info.synthetic = true;
  made.info.seed = 9;
  made.parameters.witness.witness_cell_m = 0.01;  // a smaller file
  const witness::WitnessParameters& parameters = made.parameters.witness;
  const study::Proof proof =
      study::prove(study::witness_samples(made.log, made.info.robot, parameters, {}),
                   made.info.robot,
                   made.info.course,
                   parameters,
                   {});
  if (!proof.witness) {
    throw std::runtime_error(proof.reason);
  }
  made.document = {SyntheticLabel{9},
                   "t1",
                   kLog,
                   made.info.robot,
                   proof.start,
                   *made.info.course.goal,
                   parameters.pose_bridge_s,
                   witness::free_space_options(parameters, {}),
                   proof.cells,
                   proof.witness->path,
                   proof.witness->checked};
  return made;
}

TEST(WitnessJson, ReadsBackToTheSameBytesAndStands) {
  const Case made = proven(2);
  const std::string text = to_json(made.document);
  const WitnessDocument read = witness_from_json(text, kRoom);
  EXPECT_TRUE(read.cells == made.document.cells);
  EXPECT_EQ(read.path, made.document.path);
  EXPECT_EQ(to_json(read), text);
  EXPECT_EQ(fault_of_witness(read, made.info, made.parameters, made.log, kLog), "");
}

TEST(WitnessJson, SaysWhatIsWrong) {
  Case made = proven(2);
  EXPECT_EQ(
      fault_of_witness(made.document, made.info, made.parameters, made.log, std::string(64, 'b')),
      "it is of another log");
  Case other = made;
  other.info.robot.rays[0].bearing_rad += 0.1;
  EXPECT_EQ(fault_of_witness(made.document, other.info, other.parameters, made.log, kLog),
            "it states another robot, course, rule or label than the run");
  other = made;
  other.log.merged->readings[10].value += 0.5;  // a log that was edited
  other.log.merged->readings[13].value += 0.5;
  EXPECT_EQ(fault_of_witness(made.document, made.info, made.parameters, other.log, kLog),
            "the free space built from the log is another");
  made.document.stated.margin_m += 1e-12;
  EXPECT_EQ(fault_of_witness(made.document, made.info, made.parameters, made.log, kLog),
            "the checker measures another margin");
  EXPECT_THROW((void)witness_from_json("{}", kRoom), WitnessFormatError);
  EXPECT_THROW((void)witness_from_json("nonsense", kRoom), WitnessFormatError);
  EXPECT_THROW((void)witness_from_json(to_json(proven(2).document), 100), WitnessFormatError);
}

TEST(WitnessJson, RefusesRulesAndNumbersThatAreNone) {
  const std::string text = to_json(proven(2).document);
  const auto with = [&](const std::string& key, const std::string& value) {
    const std::size_t at = text.find('"' + key + "\":") + key.size() + 3;
    return text.substr(0, at) + value + text.substr(text.find_first_of(",}", at));
  };
  EXPECT_NO_THROW((void)witness_from_json(with("reading_bound_m", "0.01"), kRoom));
  for (const auto& [key, value] : {std::pair("reading_bound_m", "-0.05"),
                                   std::pair("lost_share", "-1"),
                                   std::pair("least_obstacle_m", "-1e-9"),
                                   std::pair("pose_bridge_s", "-1"),
                                   std::pair("tracking_buffer_m", "-1"),
                                   std::pair("first_x", "18446744073709551615"),
                                   std::pair("columns", "18446744073709551615")}) {
    EXPECT_THROW((void)witness_from_json(with(key, value), kRoom), WitnessFormatError) << key;
  }
  EXPECT_THROW((void)witness_from_json(std::string(1U << 24U, '['), kRoom), WitnessFormatError);
}

/// True if a text that was tampered with is refused.
bool is_refused(const std::string& text, const Case& made) {
  try {
    return !fault_of_witness(
                witness_from_json(text, kRoom), made.info, made.parameters, made.log, kLog)
                .empty();
  } catch (const WitnessFormatError&) {
    return true;
  } catch (const std::length_error&) {
    return true;
  }
}

// Any digit of the margin, the rays, S, G, the path, the free space or a digest may be changed. The
// texts are not read. A change of less than a
// ten-thousandth may leave another path that proves the same, so that the later places are let be.
// Whoever draws them would have endless work.
TEST(WitnessJson, RefusesPiecesThatAreNoPath) {
  const WitnessDocument good = proven(2).document;
  for (const double far_m : {1e9, 1e308}) {
    WitnessDocument other = good;
    other.path.back().to = {far_m, 0.0};
    EXPECT_THROW((void)witness_from_json(to_json(other), kRoom), WitnessFormatError);
  }
  for (const double turn_rad : {3.1, -1e300}) {
    WitnessDocument other = good;
    other.path.front().turn_rad = turn_rad;
    EXPECT_THROW((void)witness_from_json(to_json(other), kRoom), WitnessFormatError);
  }
}

TEST(WitnessJson, AThousandTamperedProofsAreRefused) {
  const Case made = proven(2);
  const std::string text = to_json(made.document);
  const auto lies_between = [&](std::size_t at, const char* from, const char* to) {
    return at > text.find(from) && at < text.find(to);
  };
  std::mt19937 engine(4);
  int tampered = 0;
  while (tampered < 1000) {
    const std::size_t at = engine() % text.size();
    const bool is_claim = lies_between(at, "\"log_sha256\"", "\"assumptions\"") ||
                          lies_between(at, "\"rays\"", "\"rule\"") || at > text.find("\"path\"");
    const std::size_t begin = text.find_last_not_of("0123456789", at);
    const bool is_late = text[begin] == '.' && at - begin > 4;
    if (!is_claim || is_late || text[at] < '0' || text[at] > '9') {
      continue;
    }
    std::string other = text;
    other[at] =
        static_cast<char>('0' + (text[at] - '0' + 1 + static_cast<int>(engine() % 9U)) % 10);
    bool is_same = false;
    try {
      WitnessDocument read = witness_from_json(other, kRoom);
      read.synthetic = made.document.synthetic;
      is_same = to_json(read) == text;  // digits beyond what a double holds
    } catch (const WitnessFormatError&) {
    }
    if (is_same) {
      continue;
    }
    ++tampered;
    EXPECT_TRUE(is_refused(other, made)) << other.substr(at - std::min<std::size_t>(at, 40), 60);
  }
}

}  // namespace
}  // namespace tcert
