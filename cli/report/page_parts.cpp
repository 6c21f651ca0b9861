#include "cli/report/page_parts.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "cli/errors.hpp"
#include "datasets/bytes.hpp"
#include "reports/html/packed.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRows = 200;

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
  std::ifstream file(path, std::ios::binary);
  const auto json = nlohmann::json::parse(file, nullptr, false);
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
    for (const fs::path& path : files_of(result.folder)) {
      if (path.extension() != ".json" || path.filename() == "manifest.json" || !is_table(path)) {
        continue;
      }
      std::optional<Table> table = result_table(result, path.stem().string());
      if (table && table->rows.size() <= kMostRows) {
        tables.push_back({result.name == "." ? "" : result.name, std::move(*table)});
      } else if (table) {
        left_out.push_back("The table '" + table->title + "' has " +
                           std::to_string(table->rows.size()) + " rows: it is in " + result.name +
                           "/" + path.filename().string() + ".");
      }
    }
  }
  return tables;
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
      const BytesResult bytes = read_raw_file(path);
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
