#include "datasets/import/csv_streams.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <table/cell_reading.hpp>
#include <table/csv_header.hpp>
#include <table/file_kind.hpp>
#include <table/text_file.hpp>
#include <utility>

#include "datasets/import/csv_stream.hpp"

namespace tcert::recording {
namespace {

using table::Severity;

/// A file with its header, which points into its bytes.
struct OpenedCsv {
  table::Bytes bytes;
  table::CsvHeader header;
};

/// True if all columns of the stream are named by their position: then the header does not matter.
bool is_by_position(const StreamSource& stream, const std::string& trial_column) {
  const auto is_position = [](const std::string& column) { return column.starts_with('#'); };
  std::vector<ValueSource> sources = stream.values;
  for (const MappedRay& ray : stream.rays) {
    sources.push_back(ray.value);
    sources.push_back(ray.force);
  }
  return !stream.scan && trial_column.empty() && !stream.time.columns.empty() &&
         std::ranges::all_of(stream.time.columns, is_position) &&
         std::ranges::all_of(sources, [&](const ValueSource& source) {
           return std::ranges::all_of(source.columns, is_position);
         });
}

/// Of a file whose first line names another number of columns than its rows have.
std::optional<table::CsvHeader> header_below_first_line(std::string_view text,
                                                        const table::CsvOptions& csv,
                                                        table::DiagnosticGroups& problems) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  auto header = table::guess_header(text.substr(std::min(end + 1, text.size())), csv, problems);
  if (header) {
    ++header->data.line;
  }
  return header;
}

std::optional<OpenedCsv> open_csv(const std::filesystem::path& path,
                                  const CsvReadOptions& options,
                                  bool by_position,
                                  table::DiagnosticGroups& problems) {
  const auto fail = [&](std::string found, std::string expectation) {
    problems.add(
        {Severity::error, path.string(), 0, "", std::move(found), std::move(expectation), 1});
  };
  table::BytesResult file = table::read_text_file(path);
  if (!file.bytes) {
    fail(file.problem, "a readable file");
    return std::nullopt;
  }
  if (const auto kind = table::kind_of_binary(file.bytes->view(), path.filename().string())) {
    fail(kind->name, "a CSV file; " + kind->way_out);
    return std::nullopt;
  }
  table::CsvOptions csv;
  csv.file = path.string();
  csv.decimal_comma = options.decimal_comma;
  table::DiagnosticGroups of_header;
  auto header = table::guess_header(file.bytes->view(), csv, of_header);
  bool good = header && !of_header.has_error();
  if (!good && by_position) {
    of_header = table::DiagnosticGroups();
    header = header_below_first_line(file.bytes->view(), csv, of_header);
    good = header && !of_header.has_error();
  }
  for (table::Diagnostic& problem : of_header.take()) {
    problems.add(std::move(problem));
  }
  if (!good) {
    return std::nullopt;
  }
  return OpenedCsv{std::move(*file.bytes), std::move(*header)};
}

/// The first number of the column whose name is `pattern` with its last word replaced:
/// "field.ranges{i}" and angle_min is "field.angle_min".
std::optional<double> first_number(const OpenedCsv& csv,
                                   const std::string& pattern,
                                   const std::string& word) {
  const std::string before = pattern.substr(0, pattern.find("ranges"));
  const auto column = csv.header.find(before + word);
  table::CsvCursor cursor = csv.header.data;
  std::vector<std::string> row;
  if (!column || !table::skip_to_record(cursor) ||
      !table::scan_record(cursor, csv.header.dialect.separator, row) || *column >= row.size()) {
    return std::nullopt;
  }
  const auto reading = table::read_cell(row[*column], csv.header.dialect.decimal_point);
  const bool is_number =
      reading.meaning == table::CellMeaning::number && std::isfinite(reading.value);
  return is_number ? std::optional(reading.value) : std::nullopt;
}

std::optional<RayLayout> scan_layout(const OpenedCsv& csv,
                                     const std::string& file,
                                     const StreamSource& stream,
                                     const std::string& key,
                                     const std::string& prefix,
                                     table::DiagnosticGroups& problems) {
  const ScanSource& scan = *stream.scan;
  const auto fail = [&](std::string found, std::string expectation) {
    problems.add({Severity::error, file, 0, key, std::move(found), std::move(expectation), 1});
    return std::nullopt;
  };
  if (scan.ranges.find("{i}") == std::string::npos) {
    return fail("ranges '" + scan.ranges + "'",
                "'rays' in the map, or 'ranges' with {i} for the number of the beam");
  }
  if (scan.offset.by_transforms) {
    return fail("offset tf_static",
                "an object with x_m, y_m and yaw_rad: a CSV file has no topics");
  }
  ScanGeometry geometry;
  StreamSource every_beam = stream;
  every_beam.scan->every = 1;
  geometry.beams = sources_of(every_beam, csv.header).size() / 2;
  const auto angle_min =
      scan.angle_min_rad ? scan.angle_min_rad : first_number(csv, scan.ranges, "angle_min");
  const auto increment = scan.angle_increment_rad
                             ? scan.angle_increment_rad
                             : first_number(csv, scan.ranges, "angle_increment");
  geometry.range_min_m = first_number(csv, scan.ranges, "range_min");
  geometry.range_max_m = first_number(csv, scan.ranges, "range_max");
  geometry.offset = scan.offset;
  if (geometry.beams == 0) {
    return fail("no column '" + scan.ranges + "' with i = 0", "columns of the scan, from 0 on");
  }
  if (!angle_min || !increment || (!scan.reach_m && !geometry.range_max_m)) {
    return fail("a scan without its angles or its reach",
                "angle_min_rad, angle_increment_rad and reach_m in the map");
  }
  geometry.angle_min_rad = *angle_min;
  geometry.angle_increment_rad = *increment;
  return layout_of(stream, geometry, prefix);
}

bool is_control(const LogMap& map, std::size_t stream) { return stream > map.rays.size(); }

/// In front of the number of a beam, if there are several streams of rays.
std::string beam_prefix(const LogMap& map, std::size_t stream) {
  return map.rays.size() > 1 ? "s" + std::to_string(stream - 1) + "_b" : "b";
}

/// Whether the file is of the scanner of the first trial; else why not, as an error.
bool has_scan_of(const RayLayout& first,
                 const OpenedCsv& csv,
                 const std::filesystem::path& file,
                 const LogMap& map,
                 std::size_t stream,
                 table::DiagnosticGroups& problems) {
  const auto found = scan_layout(csv,
                                 file.string(),
                                 stream_at(map, stream),
                                 key_of(map, stream),
                                 beam_prefix(map, stream),
                                 problems);
  const bool fits = found && are_same_rays(first, *found);
  if (found && !fits) {
    problems.add({Severity::error,
                  file.string(),
                  csv.header.line,
                  key_of(map, stream),
                  "another scanner: " + in_words(*found->geometry),
                  in_words(*first.geometry) + ", as in the first trial; the trial is rejected",
                  1});
  }
  return fits;
}

}  // namespace

std::optional<std::vector<RayLayout>> find_layouts(const StreamFiles& files,
                                                   const LogMap& map,
                                                   const CsvReadOptions& options,
                                                   table::DiagnosticGroups& problems) {
  std::vector<RayLayout> layouts;
  for (std::size_t k = 0; k < map.rays.size(); ++k) {
    const StreamSource& stream = map.rays[k];
    if (!stream.scan) {
      layouts.push_back(layout_of(stream));
      continue;
    }
    const std::filesystem::path& path = files[k + 1];
    const auto csv = open_csv(path, options, false, problems);
    auto layout = csv ? scan_layout(*csv,
                                    path.string(),
                                    stream,
                                    key_of(map, k + 1),
                                    beam_prefix(map, k + 1),
                                    problems)
                      : std::nullopt;
    if (layout) {
      layouts.push_back(std::move(*layout));
    }
  }
  return layouts.size() == map.rays.size() ? std::optional(std::move(layouts)) : std::nullopt;
}

namespace {

/// Stream `i` of its file; false if it could not be read to its end.
bool read_stream_file(const std::filesystem::path& file,
                      std::size_t i,
                      const LogMap& map,
                      const std::vector<RayLayout>& layouts,
                      const CsvReadOptions& options,
                      const StreamsOfTrial& streams_of,
                      table::DiagnosticGroups& problems) {
  const StreamSource& stream = stream_at(map, i);
  const auto csv = open_csv(file, options, is_by_position(stream, map.trials.column), problems);
  if (!csv) {
    return false;
  }
  const std::vector<ValueSource> sources = sources_of(stream, csv->header);
  if (stream.scan && !has_scan_of(layouts[i - 1], *csv, file, map, i, problems)) {
    return false;
  }
  const auto take = [&](const CsvSample& sample) {
    const bool is_whole = !sample.values.empty();
    // Whose a broken row is cannot be told where a column would say it.
    StreamSet* const set =
        is_whole || map.trials.column.empty() ? streams_of(sample.trial) : nullptr;
    if (set != nullptr && is_whole) {
      set->take(i, sample.time_ns, sample.values, sample.line);
    } else if (set != nullptr) {
      set->take_unreadable(i);
    }
  };
  return read_csv_stream(
      file.string(), csv->header, stream, sources, map.trials.column, take, problems);
}

}  // namespace

bool read_csv_streams(const StreamFiles& files,
                      const LogMap& map,
                      const std::vector<RayLayout>& layouts,
                      const CsvReadOptions& options,
                      const StreamsOfTrial& streams_of,
                      table::DiagnosticGroups& problems) {
  bool all = true;
  for (std::size_t i = 0; i < number_of_streams(map); ++i) {
    if (files[i].empty()) {
      continue;
    }
    table::DiagnosticGroups of_file;
    const bool read = read_stream_file(files[i], i, map, layouts, options, streams_of, of_file);
    for (table::Diagnostic& problem : of_file.take()) {
      if (is_control(map, i) && problem.severity == Severity::error) {
        problem.severity = Severity::warning;
        problem.expectation += "; there are no commands without it";
      }
      problems.add(std::move(problem));
    }
    all = all && (read || is_control(map, i));
  }
  return all;
}

}  // namespace tcert::recording
