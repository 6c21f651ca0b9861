#include "reports/witness_json.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <tcert/certifier.hpp>

#include "analysis/study/trials/certify_trial.hpp"
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

enum class Of { trial, trial_and_edges, edges };

/// A run through a random world without noise, and its witness.
Case proven(std::uint64_t index, Of of = Of::trial) {
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
  Certifier certifier(made.info.robot, made.info.course, {});
  const study::TrialSeries series = study::certify_trial(certifier, *made.log.merged);
  const study::Proof proof =
      study::prove(study::witness_samples(made.log, made.info.robot, parameters, {}),
                   made.info.robot,
                   made.info.course,
                   parameters,
                   {},
                   of == Of::trial ? nullptr : &series);
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
  if (of != Of::trial) {
    made.document.edges = WitnessedEdges{
        CertificateParameters{}.merge_radius_m, series.nodes, series.edges, proof.edges->found};
  }
  if (of == Of::edges) {
    made.document.path.clear();
    made.document.stated = {};
  }
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

TEST(WitnessJson, EdgesReadBackAndStandWithAPathAndWithout) {
  const std::string plain = to_json(proven(2).document);
  for (const Of of : {Of::trial_and_edges, Of::edges}) {
    const Case made = proven(2, of);
    const std::string text = to_json(made.document);
    const WitnessDocument read = witness_from_json(text, kRoom);
    ASSERT_TRUE(read.edges);
    EXPECT_GT(read.edges->edges.size(), 4U);
    EXPECT_EQ(to_json(read), text);
    EXPECT_EQ(fault_of_witness(read, made.info, made.parameters, made.log, kLog), "");
    if (of == Of::trial_and_edges) {  // it begins with the file without them
      EXPECT_EQ(text.substr(0, plain.size() - 2), plain.substr(0, plain.size() - 2));
    }
  }
}

TEST(WitnessJson, SaysWhatIsWrongWithAnEdge) {
  const Case made = proven(2, Of::edges);
  const auto fault = [&](const auto& change) {
    WitnessDocument other = made.document;
    change(*other.edges);
    return fault_of_witness(other, made.info, made.parameters, made.log, kLog);
  };
  const std::size_t e = 2;
  EXPECT_EQ(fault([&](WitnessedEdges& edges) { edges.found.paths[e]->checked.margin_m += 1e-12; }),
            "edge 2: the checker measures another margin");
  EXPECT_EQ(fault([&](WitnessedEdges& edges) {
              edges.found.waypoints[edges.edges[e].ends[0].node].yaw_rad += 1e-6;
            }).substr(6),
            ": the checker refuses it: the path does not lead from waypoint to waypoint");
  EXPECT_EQ(fault([&](WitnessedEdges& edges) { edges.found.waypoints[3].position.x_m += 1.0; }),
            "a waypoint lies too far from its node");
  const char* const other_run = "its edges are those of another run";
  EXPECT_EQ(fault([&](WitnessedEdges& edges) { edges.nodes[3].pose.position.x_m += 1e-9; }),
            other_run);
  EXPECT_EQ(fault([&](WitnessedEdges& edges) { edges.merge_radius_m = 0.2; }), other_run);
  EXPECT_EQ(fault([&](WitnessedEdges& edges) { edges.edges[e].ends[0].side = Side::back; }),
            other_run);
  WitnessDocument nothing = made.document;
  nothing.edges = std::nullopt;
  EXPECT_EQ(fault_of_witness(nothing, made.info, made.parameters, made.log, kLog),
            "it has no path");
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

/// Changes digits of the text from `from` on, of which there are claims, a thousand times.
void expect_tampering_refused(const Case& made, std::size_t from, unsigned seed) {
  const std::string text = to_json(made.document);
  const auto lies_between = [&](std::size_t at, const char* begin, const char* end) {
    return at > text.find(begin) && at < text.find(end);
  };
  std::mt19937 engine(seed);
  int tampered = 0;
  while (tampered < 1000) {
    const std::size_t at = from + engine() % (text.size() - from);
    if (text[at] < '0' || text[at] > '9') {
      continue;
    }
    const bool is_claim = lies_between(at, "\"log_sha256\"", "\"assumptions\"") ||
                          lies_between(at, "\"rays\"", "\"rule\"") || at > text.find("\"path\"");
    const std::size_t begin = text.find_last_not_of("0123456789", at);
    const std::size_t end = text.find_first_not_of("0123456789", at);
    const bool is_tiny = text.compare(end, 2, "e-") == 0 || text.compare(begin - 1, 2, "e-") == 0;
    const bool is_late = (text[begin] == '.' && at - begin > 4) || is_tiny;
    if (!is_claim || is_late) {
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

TEST(WitnessJson, AThousandTamperedProofsAreRefused) { expect_tampering_refused(proven(2), 0, 4); }

TEST(WitnessJson, AThousandTamperedProofsOfEdgesAreRefused) {
  const Case made = proven(2, Of::edges);
  expect_tampering_refused(made, to_json(made.document).find("\"edges\""), 5);
}

}  // namespace
}  // namespace tcert
