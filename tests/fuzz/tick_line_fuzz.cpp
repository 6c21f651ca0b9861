// Any lines as ticks on a pipe: never a throw; a CSV stream gives the same ticks line by line as
// the whole file does.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "datasets/tick_line.hpp"
#include "datasets/tick_table.hpp"
#include "fuzz/check.hpp"

namespace tcert {
namespace {

using fuzz::require;

Robot robot() {
  Robot robot;
  robot.rays = {{"left", {}, 1.5, 0.6, RayKind::bend, {{0.0, 1.0}, {0.6, 0.0}}},
                {"b0", {}, 0.0, 8.0, RayKind::range, {}}};
  return robot;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same(const Tick& a, const Tick& b) {
  bool equal = a.time_ns == b.time_ns && a.pose.position == b.pose.position &&
               a.pose.yaw_rad == b.pose.yaw_rad && a.stale == b.stale &&
               a.segment_start == b.segment_start;
  for (std::size_t k = 0; k < a.rays.size(); ++k) {
    equal =
        equal && same(a.rays[k].value, b.rays[k].value) && same(a.rays[k].fsr_n, b.rays[k].fsr_n);
  }
  return equal;
}

void parse_lines(std::string_view text, const TickTable* file) {
  const std::size_t first_end = std::min(text.find('\n'), text.size());
  table::DiagnosticGroups problems;
  TickLineParser parser(robot(), text.substr(0, first_end), {}, problems);
  require(parser.ready() != problems.has_error(), "not ready iff the header has an error");
  if (!parser.ready()) {
    return;
  }
  const bool is_csv = parser.format() == TickLineFormat::csv;
  std::string_view rest = text.substr(is_csv ? std::min(first_end + 1, text.size()) : 0);
  std::size_t ticks = 0;
  for (std::size_t line = is_csv ? 2 : 1; !rest.empty(); ++line) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    const auto tick = parser.parse(rest.substr(0, length), line);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    require(!tick || parser.problems().empty(), "a tick has no problems");
    if (tick && file != nullptr) {
      require(ticks < file->size(), "no more ticks by line than in the file");
      require(same(tick->tick, (*file)[ticks]), "the same tick by line as in the file");
    }
    ticks += tick ? 1 : 0;
  }
  require(file == nullptr || ticks == file->size(), "as many ticks by line as in the file");
}

}  // namespace
}  // namespace tcert

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // Quotes may hold line ends, and a header may follow a byte-order mark, blank lines, comments or
  // a preamble: there the file has more to go by than its lines, and only one is compared.
  const bool comparable = text.starts_with("time_s,") && text.find('"') == std::string_view::npos;
  table::DiagnosticGroups problems;
  table::CsvOptions csv;
  csv.separator = ',';
  csv.preamble_records = 0;
  const auto file = read_ticks_csv(table::Bytes::copy_of(text), robot(), csv, 1.0, problems);
  bool whole = true;
  for (const table::Diagnostic& diagnostic : problems.take()) {
    whole = whole && diagnostic.value != "a line cut short";
  }
  parse_lines(text, file && comparable && whole ? &*file : nullptr);
  return 0;
}
