#include "datasets/perturb/read_injections.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <table/csv.hpp>

#include "datasets/bundle_files.hpp"

namespace tcert::perturb {
namespace {

constexpr const char* kFile = "injections.csv";

std::optional<double> seconds_from(std::string_view cell) {
  double value = 0.0;
  const char* const end = cell.data() + cell.size();
  const auto read = std::from_chars(cell.data(), end, value);
  return read.ec == std::errc{} && read.ptr == end && std::isfinite(value) ? std::optional(value)
                                                                           : std::nullopt;
}

}  // namespace

InjectionsResult read_injections(const Bundle& bundle) {
  InjectionsResult result;
  const BundleFiles files(bundle.path);
  if (!files.problem().empty() || !files.find(kFile)) {
    return result;
  }
  table::DiagnosticGroups problems;
  const table::BytesResult bytes = files.read(kFile);
  table::CsvOptions csv;
  csv.file = kFile;
  if (!bytes.bytes) {
    problems.add({table::Severity::error, kFile, 0, "", "", "a readable file: " + bytes.problem});
  } else if (const auto rows = table::read_text_table(
                 *bytes.bytes, csv, {"trial_id", "kind", "stream", "start_s", "end_s"}, problems)) {
    const auto cell = [&](std::size_t row, std::string_view column) -> const std::string& {
      return rows->at(row, *rows->find(column));
    };
    for (std::size_t i = 0; i < rows->rows(); ++i) {
      const auto start_s = seconds_from(cell(i, "start_s"));
      const auto end_s = seconds_from(cell(i, "end_s"));
      if (!start_s || !end_s || *end_s < *start_s) {
        problems.add({table::Severity::error,
                      kFile,
                      rows->lines[i],
                      start_s ? "end_s" : "start_s",
                      cell(i, start_s ? "end_s" : "start_s"),
                      "a time in seconds, the end not before the start"});
        continue;
      }
      result.of_trial[cell(i, "trial_id")].push_back(
          {cell(i, "kind"), cell(i, "stream"), *start_s, *end_s});
    }
  }
  result.diagnostics = problems.take();
  return result;
}

}  // namespace tcert::perturb
