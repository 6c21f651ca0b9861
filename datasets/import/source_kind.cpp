#include "datasets/import/source_kind.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <table/bytes.hpp>
#include <table/cell_reading.hpp>
#include <table/file_kind.hpp>
#include <table/text_file.hpp>
#include <vector>

#include "datasets/import/bag.hpp"

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLinesLookedAt = 20;  // lines

std::vector<std::string_view> first_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < kLinesLookedAt) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    if (!line.empty() && line.front() != '#') {
      lines.push_back(line);
    }
  }
  return lines;
}

std::vector<std::string_view> words_of_line(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
      return words;
    }
    line.remove_prefix(first);
    words.push_back(line.substr(0, line.find_first_of(" \t")));
    line.remove_prefix(words.back().size());
  }
}

bool is_carmen(const std::vector<std::string_view>& lines) {
  constexpr std::array<std::string_view, 9> kRecords = {"PARAM",
                                                        "ODOM",
                                                        "FLASER",
                                                        "RLASER",
                                                        "ROBOTLASER1",
                                                        "ROBOTLASER2",
                                                        "RAWLASER1",
                                                        "SYNC",
                                                        "NMEAGGA"};
  return !lines.empty() && std::ranges::all_of(lines, [&](std::string_view line) {
    const auto words = words_of_line(line);
    return !words.empty() && std::ranges::find(kRecords, words.front()) != kRecords.end();
  });
}

/// `world success collided timeout time [metric]`, of the three exactly one.
bool is_barn(const std::vector<std::string_view>& lines) {
  const auto is_flag = [](std::string_view word) {
    return word == "0" || word == "1" || word == "True" || word == "False";
  };
  return !lines.empty() && std::ranges::all_of(lines, [&](std::string_view line) {
    const auto words = words_of_line(line);
    const auto is_number = [](std::string_view word) {
      return table::read_cell(word).meaning == table::CellMeaning::number;
    };
    return (words.size() == 5 || words.size() == 6) && is_flag(words[1]) && is_flag(words[2]) &&
           is_flag(words[3]) && is_number(words[0]) && is_number(words[4]) &&
           words[0].find('.') == std::string_view::npos;
  });
}

bool has_csv_files(const fs::path& folder) {
  std::error_code error;
  std::size_t seen = 0;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator() && seen < 10'000; at.increment(error)) {
    std::error_code ignored;
    ++seen;
    if (at->is_regular_file(ignored) && source_kind(at->path()) == SourceKind::csv) {
      return true;
    }
  }
  return false;
}

}  // namespace

SourceKind source_kind(const fs::path& path) {
  std::error_code ignored;
  if (bag_kind(path) != BagKind::none) {
    return SourceKind::bag;
  }
  if (fs::is_directory(path, ignored)) {
    if (fs::exists(path / "bundle.json", ignored)) {
      return SourceKind::bundle;
    }
    return has_csv_files(path) ? SourceKind::csv_folder : SourceKind::bundle;
  }
  const table::BytesResult file = table::read_text_file(path);
  if (!file.bytes) {
    return SourceKind::unreadable;
  }
  const std::string_view text = file.bytes->view();
  if (text.starts_with("PK\x03\x04")) {
    return SourceKind::bundle;
  }
  if (const auto kind = table::kind_of_binary(text, ""); kind && kind->name != table::kBinaryFile) {
    return SourceKind::binary;
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const std::size_t second =
      first == std::string_view::npos ? first : text.find_first_not_of(" \t\r\n", first + 1);
  // "[s]" is the name of a column, "[1" and "[{" are not.
  const bool is_list =
      second != std::string_view::npos && text[first] == '[' &&
      std::string_view("{[\"-0123456789]").find(text[second]) != std::string_view::npos;
  if (is_list || (first != std::string_view::npos && text[first] == '{')) {
    return SourceKind::json;
  }
  const std::vector<std::string_view> lines = first_lines(text);
  if (is_carmen(lines)) {
    return SourceKind::carmen;
  }
  return is_barn(lines) ? SourceKind::barn : SourceKind::csv;
}

std::string_view writer_of(const std::vector<std::string>& names, std::size_t header_line) {
  const auto has = [&](std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  };
  const auto any_begins = [&](std::string_view begin) {
    return std::ranges::any_of(names, [&](const std::string& n) { return n.starts_with(begin); });
  };
  if (has("%time")) {
    return "an export of rostopic echo -p";
  }
  if (has("__time")) {
    return "an export of PlotJuggler";
  }
  if (has("Time") && (has("header.seq") || has("linear.x") || has("data") || has("force.x"))) {
    return "an export of bagpy";
  }
  if (has("rosbagTimestamp")) {
    return "an export of rosbag_to_csv";
  }
  if (any_begins("p_RS_R_x")) {
    return "an EuRoC trajectory";
  }
  if (has("tx") && has("qw")) {
    return "a TUM trajectory";
  }
  if (header_line == 0 && names.size() == 8) {
    return "a TUM trajectory: time, x, y, z and a quaternion";
  }
  if (has("timestamp") && (has("timestamp_sample") || has("vx") || has("q[0]"))) {
    return "an export of ulog2csv";
  }
  return "";
}

}  // namespace tcert::recording
