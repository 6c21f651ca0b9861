// Any bytes as a map, a line, and a CSV file that it is the map of: never a throw, a map that is
// accepted keeps its keys, and every row is a sample, empty, or counted.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <table/bytes.hpp>
#include <table/csv_header.hpp>
#include <table/date_cell.hpp>
#include <table/text_file.hpp>
#include <table/time_unit.hpp>

#include "datasets/import/csv_stream.hpp"
#include "datasets/import/log_map.hpp"
#include "datasets/import/sample_order.hpp"
#include "fuzz/check.hpp"

namespace tcert {
namespace {

using fuzz::require;

void read_pose(const recording::StreamSource& stream, std::string_view text) {
  const table::Bytes bytes = table::as_text(table::Bytes::copy_of(text));
  table::DiagnosticGroups problems;
  const auto header = table::guess_header(bytes.view(), {}, problems);
  if (!header || problems.has_error()) {
    return;
  }
  std::size_t rows = 0;
  std::int64_t last_ns = 0;
  std::size_t passed = 0;
  recording::SampleOrder order(1'000'000'000, [&](const recording::Sample& sample) {
    require(passed++ == 0 || sample.time_ns > last_ns, "samples are in order of time");
    last_ns = sample.time_ns;
  });
  const auto sources = recording::sources_of(stream, *header);
  const bool read = recording::read_csv_stream(
      "a.csv",
      *header,
      stream,
      sources,
      "",
      [&](const recording::CsvSample& sample) {
        // A row of another length is shown without values and without a time.
        const bool is_whole = !sample.values.empty();
        require(is_whole ? sample.values.size() == sources.size() : !sample.time_ns,
                "a value a source, or none");
        ++rows;
        if (sample.time_ns) {
          order.add(*sample.time_ns, sample.values, sample.line);
        } else {
          order.count_unreadable();
        }
      },
      problems);
  const recording::StreamUse use = order.finish();
  require(read || rows == 0, "nothing is shown of a file without its columns");
  require(use.rows == rows && use.used == passed &&
              use.rows == use.used + use.same_time + use.set_back + use.unreadable,
          "every row is counted once");
}

}  // namespace
}  // namespace tcert

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  table::DiagnosticGroups problems;
  const auto map = recording::parse_log_map(text.substr(0, end), "map.json", problems);
  fuzz::require(map.has_value() != problems.has_error(), "rejected iff there is an error");
  for (const table::Diagnostic& diagnostic : problems.take()) {
    fuzz::require(table::to_string(diagnostic).find('\n') == std::string::npos,
                  "a message is one line");
  }
  const std::string_view rest = text.substr(std::min(end + 1, text.size()));
  if (map) {
    read_pose(map->pose, rest);
  }
  std::int64_t time_ns = 0;
  static_cast<void>(table::read_date(rest.substr(0, 64), time_ns));
  static_cast<void>(
      table::read_time(rest.substr(0, 64), table::TimeUnit::microseconds, '.', time_ns));
  return 0;
}
