#include "cli/commands/field_listing.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "datasets/bundle_fields.hpp"
#include "datasets/import/map_fields.hpp"
#include "reports/columns_of.hpp"

namespace tcert::cli {
namespace {

std::string need_in_words(FieldNeed need) {
  switch (need) {
    case FieldNeed::required:
      return "required";
    case FieldNeed::may_be_empty:
      return "required, cells may be empty";
    case FieldNeed::optional:
      return "optional";
  }
  return "";
}

/// What a place is called in the listing.
std::string file_of(std::string_view place) {
  static const std::map<std::string_view, std::string> streams{
      {"pose.csv", "logs/<trial_id>/pose.csv"},
      {"tactile.csv", "logs/<trial_id>/tactile.csv"},
      {"control.csv", "logs/<trial_id>/control.csv"},
      {"ticks.csv", "logs/<trial_id>/ticks.csv"},
      {"robot", "bundle.json: robot"},
      {"ray", "bundle.json: rays, each"},
      {"calibration", "bundle.json: calibration"},
      {"course", "bundle.json: course"},
      {"region", "bundle.json: start, goal"},
      {"disc", "bundle.json: disc"}};
  const auto found = streams.find(place);
  return found == streams.end() ? std::string(place) : found->second;
}

struct Row : RowOf<FileField> {
  std::string file;
};

ColumnsOf<Row> field_columns() {
  const auto text = [](std::string_view FileField::*member) {
    return [member](const Row& row) { return std::string(row.of.*member); };
  };
  return ColumnsOf<Row>()
      .text("file", "file", &Row::file)
      .text("field", "column or key", text(&FileField::name))
      .text("unit", "unit", text(&FileField::unit))
      .text("needed", "needed", [](auto& row) { return need_in_words(row.of.need); })
      .text("doc", "what", text(&FileField::doc));
}

void add_fields(const std::string& file, std::span<const FileField> fields, Table& table) {
  static const ColumnsOf<Row> columns = field_columns();
  for (const FileField& field : fields) {
    table.add_row(columns.row({{field}, file}));
  }
}

void add_fields(const std::string& file, std::string_view place, Table& table) {
  add_fields(file, fields_at(place, bundle_fields()), table);
}

/// What ticks.csv has of the streams: the time once, and no arrival.
std::vector<FileField> fields_of_ticks() {
  std::vector<FileField> fields = fields_at("pose.csv", bundle_fields());
  for (const FileField& field : fields_at("tactile.csv", bundle_fields())) {
    if (field.name != fields.front().name) {
      fields.push_back(field);
    }
  }
  std::erase_if(fields, [](const FileField& field) { return field.is_time; });
  return fields;
}

/// In the order in which they are declared.
std::vector<std::string_view> places_of(std::span<const FileField> fields) {
  std::vector<std::string_view> places;
  for (const FileField& field : fields) {
    if (std::ranges::find(places, field.place) == places.end()) {
      places.push_back(field.place);
    }
  }
  return places;
}

}  // namespace

std::string fields_in_words(std::span<const FileField> fields) {
  const std::string_view whole = fields.front().place;
  std::string text;
  for (const FileField& field : fields) {
    std::string name(field.name);
    if (field.place != whole) {
      name.insert(0, std::string(field.place) + '.');
    }
    name += field.need == FieldNeed::required ? " *" : "";
    name.resize(std::max<std::size_t>(name.size() + 2, 18), ' ');
    text += "  " + name + std::string(field.doc) +
            (field.unit.empty() ? "" : " [" + std::string(field.unit) + "]") + '\n';
  }
  return text;
}

Table bundle_listing() {
  Table table =
      field_columns().table("bundle", "The log bundle, version 1: a folder, or a .zip of it");
  for (const std::string_view place : places_of(bundle_fields())) {
    if (place == "ticks.csv") {
      add_fields(file_of(place), fields_of_ticks(), table);
    }
    add_fields(file_of(place), place, table);
  }
  table.footnotes = {
      ("A bundle has bundle.json, trials.csv, and of each trial pose.csv and tactile.csv or, "
       "instead of all streams, ticks.csv, which is used as it is; control.csv is optional. "
       "worlds/<world>.json may hold the truth ('tcert help world')."),
      ("A CSV file may end in .gz or .zst, its columns may stand in any order; a further column of "
       "trials.csv goes into the table of features, one of a stream is left alone. <ray> is a "
       "ray's name: a ray of kind bend has a bend, one of kind range a range."),
      ("Frames: poses, S and G lie in one frame, in which the robot is tracked (of odometry, or of "
       "a map); the body's frame has x ahead and y to the left; angles are anticlockwise, in "
       "radians."),
      ("Clocks: time_s of the streams is one clock, which may begin anywhere; time_s of trials.csv "
       "is a length of time."),
      ("A missing cell is empty, NA or nan. An unknown key of bundle.json is an error. 'tcert "
       "check BUNDLE' names every problem with its line.")};
  return table;
}

Table map_listing() {
  Table table = field_columns().table(
      "map", "The map of a foreign log, version 1: a JSON object for 'tcert import log'");
  const std::span<const FileField> fields = recording::map_fields();
  for (const std::string_view place : places_of(fields)) {
    add_fields(std::string(place), fields_at(place, fields), table);
  }
  table.footnotes = {
      (R"(Of a bag: {"robot": {"body_width_m": 0.35}, "course": {"goal": {"disc": {"x_m": 6, )"
       R"("y_m": 2, "radius_m": 0.5}}}, "pose": {"from": "/odom"}, "rays": {"from": "/scan", )"
       R"("every": 4, "no_return": ["inf", 0], "offset": "tf_static"}, "control": {"from": )"
       R"("/cmd_vel"}})"),
      (R"(Of CSV files: {"pose": {"file": "{trial}/odom.csv", "time": {"column": "t", "unit": )"
       R"("ns"}, "x_m": {"column": "x", "unit": "mm"}, "y_m": {"column": "y", "unit": "mm"}, )"
       R"("yaw_rad": {"column": "heading", "unit": "deg"}}, "rays": {"file": "{trial}/touch.csv", )"
       R"("rays": [{"name": "left", "kind": "range", "bearing_deg": 90, "reach_m": 0.5, )"
       R"("range_m": {"column": "left_mm", "unit": "mm"}}]}, "trials": {"table": "outcomes.csv", )"
       R"("id": "run", "success": {"column": "result", "true": ["ok"]}}})"),
      ("Keys of bundle.json other than rays (robot, course, lighting, max_gap_s, parameters, ...) "
       "may stand in the map and go into the bundle: 'tcert help bundle'. A value is a column's "
       "name, or an object. An unknown key is an error."),
      ("Rows late by less than max_gap_s are put in order; of two of one time the first is used; a "
       "row without any value of a stream is no sample of it. A range that is not finite, 0 or "
       "less, or beyond its limits is missing, unless 'no_return' says that nothing was in reach; "
       "-inf is 0: nearer than the sensor can see."),
      "'tcert check SOURCE --write-map FILE' drafts a map."};
  return table;
}

}  // namespace tcert::cli
