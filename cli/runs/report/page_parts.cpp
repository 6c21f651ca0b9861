#include "cli/runs/report/page_parts.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <table/bytes.hpp>
#include <table/json_shape.hpp>

#include "cli/runs/errors.hpp"
#include "reports/html/packed.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRows = 200;

/// Tables to be read first, in this order, whatever result they are of.
constexpr std::array<std::string_view, 26> kMainTables = {
    "table1",     "speed",       "issuance",       "tc_early",   "h1",
    "h1_within",  "h1_time",     "h1_time_within", "h1_mixed",   "h2",
    "h2_within",  "h2_equality", "h2_interaction", "h3",         "h3_baseline",
    "h3_driven",  "h3_events",   "gate",           "gate_slope", "cells",
    "ablation",   "sweep",       "monitors",       "risk",       "guard_front",
    "guard_folds"};

std::size_t rank_of(const std::string& name) {
  return static_cast<std::size_t>(std::find(kMainTables.begin(), kMainTables.end(), name) -
                                  kMainTables.begin());
}

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// A table of ours by its format word; other documents are not for the page.
bool is_table(const fs::path& path) {
  const table::BytesResult file = table::read_raw_file(path);
  if (!file.bytes) {
    throw BadData("'" + path.string() + "': " + file.problem);
  }
  if (const auto shape = table::json_shape_problem(file.bytes->view()); !shape.empty()) {
    throw BadData("'" + path.string() + "': " + std::string(shape));
  }
  const auto json = nlohmann::json::parse(file.bytes->view(), nullptr, false);
  return json.is_object() && json.contains("columns") && json.contains("rows") &&
         json.contains("table");
}

std::string picture_type(const fs::path& path) {
  if (path.extension() == ".svg") {
    return "image/svg+xml";
  }
  return path.extension() == ".png" ? "image/png" : "";
}

}  // namespace

std::vector<PageTable> page_tables(const Results& results, std::vector<std::string>& left_out) {
  std::vector<PageTable> tables;
  for (const Result& result : results.all) {
    std::vector<fs::path> files = files_of(result.folder);
    std::stable_sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
      return rank_of(a.stem().string()) < rank_of(b.stem().string());
    });
    for (const fs::path& path : files) {
      if (path.extension() != ".json" || path.filename() == "manifest.json" || !is_table(path)) {
        continue;
      }
      std::optional<Table> table = result_table(result, path.stem().string());
      if (table && path.stem() == "findings" && is_findings_table(*table)) {
        continue;  // In the summary.
      }
      if (table && table->rows.size() <= kMostRows) {
        tables.push_back({result.name == "." ? "results" : result.name,
                          rank_of(path.stem().string()) < kMainTables.size(),
                          std::move(*table),
                          result_title(result)});
      } else if (table) {
        left_out.push_back("The table '" + table->title + "' has " +
                           std::to_string(table->rows.size()) + " rows: it is in " + result.name +
                           "/" + path.filename().string() + ".");
      }
    }
  }
  return tables;
}

std::vector<PageFindings> page_findings(const Results& results) {
  std::vector<PageFindings> findings;
  for (const Result& result : results.all) {
    std::optional<Table> table = result_table(result, "findings");
    if (table && !table->rows.empty() && is_findings_table(*table)) {
      findings.push_back({result_title(result), result_question(result), std::move(*table)});
    }
  }
  return findings;
}

std::vector<PageFrames> page_frames(const Results& results, PageData& page) {
  std::vector<PageFrames> sets;
  for (const Result& result : results.all) {
    PageFrames set;
    set.title = result.name == "." ? "Frames" : "Frames of " + result.name;
    for (const fs::path& path : files_of(result.folder / "frames")) {
      const std::string type = picture_type(path);
      if (type.empty()) {
        continue;
      }
      const table::BytesResult bytes = table::read_raw_file(path);
      if (!bytes.bytes) {
        throw BadData("'" + path.string() + "': " + bytes.problem);
      }
      set.frames.push_back({path.stem().string(), type, page.frames.size()});
      const nlohmann::json frame = {{"base64", base64(bytes.bytes->view())}};
      page.frames.push_back(packed(frame.dump()));
    }
    if (!set.frames.empty()) {
      sets.push_back(std::move(set));
    }
  }
  return sets;
}

}  // namespace tcert::cli
