// That the columns and keys which the help lists are those that the readers take.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "datasets/bundle_fields.hpp"
#include "datasets/bundle_json.hpp"
#include "datasets/trial_reader.hpp"
#include "datasets/world.hpp"
#include "datasets/world_fields.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::TemporaryFolder;

json whole_bundle() {
  return json::parse(R"({
    "format": "tcert-bundle", "version": 1, "synthetic": true, "seed": 1, "provenance": "a test",
    "robot": {"body_width_m": 0.45, "min_turn_radius_m": 0.35, "tracking_buffer_m": 0,
              "curvature_buffer_per_m": 0},
    "rays": [{"name": "a", "kind": "bend", "mount_x_m": 0, "mount_y_m": 0, "bearing_rad": 1,
              "reach_m": 1, "calibration": {"bend_rad": [0, 1], "clearance_m": [1, 0]}},
             {"name": "b", "kind": "range", "bearing_rad": -1, "reach_m": 1,
              "no_return": [0, "inf"], "range_min_m": 0.1, "range_max_m": 9}],
    "course": {"start": {"disc": {"x_m": 0, "y_m": 0, "radius_m": 1}},
               "goal": {"polygon": [[4, 0], [5, 0], [5, 1]]}},
    "lighting": ["Dark"], "trial_limit_s": 180, "max_gap_s": 1, "start_at": "pose",
    "columns": {"pose.csv": {"t": "time_s"}}, "parameters": {"edge_length_m": 0.25}})");
}

json whole_world() {
  return json::parse(R"({
    "synthetic": true, "seed": 1, "format": "tcert-world", "version": 1, "name": "w",
    "bounds": {"low": [0, 0], "high": [9, 9]},
    "start": {"disc": {"x_m": 1, "y_m": 1, "radius_m": 0.5}},
    "goal": {"polygon": [[7, 7], [8, 7], [8, 8]]},
    "obstacles": [{"disc": {"x_m": 4, "y_m": 4, "radius_m": 1}}]})");
}

bool reads_as_bundle(const json& document) {
  table::DiagnosticGroups problems;
  return parse_bundle_json(document.dump(), problems).has_value();
}

bool reads_as_world(const json& document) {
  try {
    (void)world_from_json(document.dump());
    return true;
  } catch (const WorldFormatError&) {
    return false;
  }
}

/// Where the objects of a place lie in the two documents.
json::json_pointer pointer_to(std::string_view place) {
  const std::map<std::string_view, const char*> pointers{{"bundle.json", ""},
                                                         {"world", ""},
                                                         {"robot", "/robot"},
                                                         {"ray", "/rays/0"},
                                                         {"course", "/course"},
                                                         {"calibration", "/rays/0/calibration"},
                                                         {"bounds", "/bounds"}};
  return json::json_pointer(pointers.at(place));
}

/// The object in which a key of a place stands: some keys are those of a ray of kind range alone.
json::json_pointer pointer_to(const json& whole, const std::string& place, std::string_view key) {
  const json::json_pointer at = pointer_to(place);
  const json::json_pointer range("/rays/1");
  return place == "ray" && !whole[at].contains(key) ? range : at;
}

/// Every key that is declared is in the document, and needed where that is said; others are
/// refused.
void expect_keys(const json& whole,
                 bool (*reads)(const json&),
                 const std::vector<std::string>& places,
                 std::span<const FileField> fields) {
  ASSERT_TRUE(reads(whole));
  for (const std::string& place : places) {
    std::set<std::string> keys;
    for (const FileField& field : fields_at(place, fields)) {
      const json::json_pointer at = pointer_to(whole, place, field.name);
      for (const auto& [key, value] : whole[at].items()) {
        keys.insert(key);
      }
      SCOPED_TRACE(place + ": " + std::string(field.name));
      json without = whole;
      // Of the ray with a calibration, which one of kind range has not.
      EXPECT_EQ(without[at].erase(std::string(field.name)), 1U);
      const bool needed = field.need == FieldNeed::required || field.name == "calibration";
      EXPECT_EQ(reads(without), !needed);
    }
    EXPECT_EQ(keys.size(), names_at(place, fields).size()) << place;
    json more = whole;
    more[pointer_to(place)]["one_more"] = 1;
    EXPECT_FALSE(reads(more)) << place;
  }
  // Regions are either of two.
  const std::vector<std::string> kinds = names_at("region", fields);
  EXPECT_EQ(kinds, (std::vector<std::string>{"disc", "polygon"}));
}

TEST(FileFields, OfBundleJsonAreThoseThatAreRead) {
  expect_keys(whole_bundle(),
              reads_as_bundle,
              {"bundle.json", "robot", "ray", "calibration", "course"},
              bundle_fields());
  for (const std::string& name : names_at("disc", bundle_fields())) {
    json without = whole_bundle();
    EXPECT_EQ(without["course"]["start"]["disc"].erase(name), 1U);
    EXPECT_FALSE(reads_as_bundle(without)) << name;
  }
}

TEST(FileFields, OfAWorldAreThoseThatAreRead) {
  expect_keys(whole_world(), reads_as_world, {"world", "bounds"}, world_fields());
  for (const std::string& name : names_at("disc", world_fields())) {
    json without = whole_world();
    EXPECT_EQ(without["start"]["disc"].erase(name), 1U);
    EXPECT_FALSE(reads_as_world(without)) << name;
  }
}

/// A cell that any column of its kind takes.
std::string cell_of(const std::string& column) {
  const std::map<std::string, std::string> words{{"trial_id", "t1"},
                                                 {"algorithm", "M3"},
                                                 {"lighting", "Dark"},
                                                 {"day", "d1"},
                                                 {"batch", "b1"},
                                                 {"end_reason", "goal"}};
  const auto word = words.find(column);
  return word == words.end() ? "1" : word->second;
}

/// The bundle of whole_bundle(), each file with the columns that are declared, but one.
class WrittenBundle {
 public:
  explicit WrittenBundle(std::string left_out_of = {}, std::string left_out = {})
      : file_(std::move(left_out_of)), column_(std::move(left_out)) {
    folder_.write("bundle.json", whole_bundle().dump());
    write("trials.csv", "trials.csv");
    for (const char* const file : {"pose.csv", "tactile.csv", "control.csv"}) {
      write(file, std::string("logs/t1/") + file);
    }
  }

  [[nodiscard]] bool reads() const {
    const BundleResult opened = open_bundle(folder_.path());
    if (!opened.bundle || !opened.bundle->extra_columns.empty()) {
      return false;
    }
    // Bad commands cost no trial, but they are not read.
    const TrialResult trial = read_trial(*opened.bundle, opened.bundle->trials.front(), {});
    return trial.log && !trial.log->control.time_ns.empty();
  }

 private:
  void write(const std::string& file, const std::string& path) {
    std::string header;
    std::string row;
    for (const std::string& declared : names_at(file, bundle_fields())) {
      std::vector<std::string> columns{declared};
      if (declared == kBendColumn) {
        columns = {"a_bend_rad"};
      } else if (declared == kRangeColumn) {
        columns = {"b_range_m"};
      } else if (declared == kForceColumn) {
        columns = {"a_fsr_n", "b_fsr_n"};
      }
      for (const std::string& column : columns) {
        if (file != file_ || declared != column_) {
          header += (header.empty() ? "" : ",") + column;
          row += (row.empty() ? "" : ",") + cell_of(column);
        }
      }
    }
    folder_.write(path, header + '\n' + row + '\n');
  }

  std::string file_;
  std::string column_;
  TemporaryFolder folder_;
};

TEST(FileFields, OfTablesAndStreamsAreThoseThatAreRead) {
  ASSERT_TRUE(WrittenBundle().reads());
  for (const char* const file : {"trials.csv", "pose.csv", "tactile.csv", "control.csv"}) {
    for (const FileField& field : fields_at(file, bundle_fields())) {
      EXPECT_EQ(WrittenBundle(file, std::string(field.name)).reads(),
                field.need == FieldNeed::optional)
          << file << ": " << field.name;
    }
  }
}

}  // namespace
}  // namespace tcert
