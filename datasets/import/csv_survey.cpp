#include "datasets/import/csv_survey.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <table/csv_header.hpp>
#include <table/file_kind.hpp>
#include <table/nearest_name.hpp>
#include <table/text_file.hpp>
#include <utility>

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostSurveyed = 10'000;
constexpr int kDeepestSurveyed = 8;

bool is_word_byte(char c) noexcept {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::vector<std::string> names_below(const fs::path& source) {
  std::vector<std::string> names;
  std::error_code error;
  if (!fs::is_directory(source, error)) {
    return {source.filename().string()};
  }
  fs::recursive_directory_iterator at(source, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator() && names.size() < kMostSurveyed;
       at.increment(error)) {
    if (at.depth() >= kDeepestSurveyed) {
      at.disable_recursion_pending();
    }
    std::error_code ignored;
    const std::string name = at->path().filename().string();
    if (at->is_regular_file(ignored) && !name.starts_with('.') && !name.ends_with(".json") &&
        !name.ends_with(".yaml") && !name.ends_with(".md")) {
      names.push_back(at->path().lexically_relative(source).generic_string());
    }
  }
  std::ranges::sort(names);
  return names;
}

/// Names of the columns; none if it is no table.
std::vector<std::string> columns_of(const fs::path& path, bool decimal_comma) {
  const table::BytesResult file = table::read_text_file(path);
  if (!file.bytes || table::kind_of_binary(file.bytes->view(), "")) {
    return {};
  }
  table::CsvOptions csv;
  csv.decimal_comma = decimal_comma;
  table::DiagnosticGroups ignored;
  const auto header = table::guess_header(file.bytes->view(), csv, ignored);
  return header && header->names.size() > 1 ? header->names : std::vector<std::string>{};
}

bool names_outcomes(const std::vector<std::string>& columns) {
  static const std::set<std::string> words{"success",
                                           "outcome",
                                           "result",
                                           "status",
                                           "reached",
                                           "ok",
                                           "end_reason",
                                           "finished",
                                           "collided",
                                           "verdict"};
  return std::ranges::any_of(
      columns, [](const std::string& name) { return words.contains(table::case_folded(name)); });
}

}  // namespace

std::string pattern_of(const std::vector<std::string>& names) {
  std::string begin = names.front();
  std::string end = names.front();
  for (const std::string& name : names) {
    const auto differ = std::mismatch(begin.begin(), begin.end(), name.begin(), name.end()).first;
    begin.erase(differ, begin.end());
    const auto differ_back =
        std::mismatch(end.rbegin(), end.rend(), name.rbegin(), name.rend()).first;
    end.erase(end.begin(), differ_back.base());
  }
  if (begin == names.front()) {
    return begin;
  }
  while (!begin.empty() && is_word_byte(begin.back())) {
    begin.pop_back();
  }
  while (!end.empty() && is_word_byte(end.front())) {
    end.erase(0, 1);
  }
  // Where folders differ, the trial is the whole name of one.
  if (const std::size_t slash = end.find('/'); slash != std::string::npos) {
    begin.resize(begin.rfind('/') == std::string::npos ? 0 : begin.rfind('/') + 1);
    end.erase(0, slash);
  }
  return begin + "{trial}" + end;
}

std::vector<CsvGroup> survey_csv(const fs::path& source,
                                 bool decimal_comma,
                                 const std::string& clock,
                                 table::DiagnosticGroups& problems) {
  std::error_code ignored;
  const bool is_folder = fs::is_directory(source, ignored);
  std::map<std::vector<std::string>, std::vector<std::string>> alike;
  for (const std::string& name : names_below(source)) {
    const std::vector<std::string> columns =
        columns_of(is_folder ? source / name : source, decimal_comma);
    if (!columns.empty()) {
      alike[columns].push_back(name);
    }
  }
  std::vector<CsvGroup> groups;
  for (const auto& [columns, names] : alike) {
    CsvGroup group;
    group.pattern = pattern_of(names);
    for (const std::string& name : names) {
      group.files.push_back(is_folder ? source / name : source);
    }
    table::CsvOptions csv;
    csv.decimal_comma = decimal_comma;
    const bool has_clock = std::ranges::find(columns, clock) != columns.end();
    table::CsvCheckResult checked =
        table::check_csv_file(group.files.front(), 1.0, csv, has_clock ? clock : "");
    if (!checked.check) {
      continue;
    }
    group.check = std::move(*checked.check);
    group.is_of_trials = names_outcomes(columns) && names.size() == 1;
    for (table::Diagnostic& problem : checked.diagnostics) {
      problems.add(std::move(problem));
    }
    groups.push_back(std::move(group));
  }
  std::ranges::stable_sort(
      groups, [](const CsvGroup& a, const CsvGroup& b) { return a.files.size() > b.files.size(); });
  return groups;
}

}  // namespace tcert::recording
