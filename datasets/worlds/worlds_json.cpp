#include <nlohmann/json.hpp>
#include <string_view>
#include <table/json_shape.hpp>

#include "datasets/worlds/world_files.hpp"

namespace tcert {
namespace {

class Worlds {
 public:
  explicit Worlds(std::string file) : file_(std::move(file)) {}

  /// `line` is 0 if it is not known; `number` counts from 0 and names a world that has no name.
  void add(std::string_view text, std::size_t line, std::size_t number) {
    try {
      World world = world_from_json(text);
      if (world.name.empty()) {
        world.name = "#" + std::to_string(number);
      }
      result_.worlds.push_back(std::move(world));
    } catch (const WorldFormatError& error) {
      result_.diagnostics.push_back({table::Severity::error,
                                     file_,
                                     line,
                                     "#" + std::to_string(number),
                                     "",
                                     std::string("a world; ") + error.what(),
                                     1});
    }
  }

  [[nodiscard]] WorldsResult take() { return std::move(result_); }

 private:
  std::string file_;
  WorldsResult result_;
};

/// One world a line, unless there is only one line with text.
bool is_one_a_line(std::string_view text) {
  std::size_t lines = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string_view::npos) {
      if (line[first] != '{' || line[line.find_last_not_of(" \t\r")] != '}') {
        return false;
      }
      ++lines;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines > 1;
}

}  // namespace

WorldsResult worlds_from_json(const table::Bytes& bytes, const std::string& file) {
  Worlds worlds(file);
  std::string_view text = bytes.view();
  std::size_t number = 0;
  if (is_one_a_line(text)) {
    for (std::size_t line = 1; !text.empty(); ++line) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      if (text.substr(0, end).find('{') != std::string_view::npos) {
        worlds.add(text.substr(0, end), line, number++);
      }
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return worlds.take();
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] == '[' &&
      table::json_shape_problem(text).empty()) {
    const auto array = nlohmann::ordered_json::parse(text, nullptr, false);
    if (!array.is_discarded()) {
      for (const auto& world : array) {
        worlds.add(world.dump(), 0, number++);
      }
      return worlds.take();
    }
  }
  worlds.add(text, 0, 0);
  return worlds.take();
}

}  // namespace tcert
