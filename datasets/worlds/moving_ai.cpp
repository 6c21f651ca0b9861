#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "datasets/worlds/raster_world.hpp"
#include "datasets/worlds/world_files.hpp"

namespace tcert {
namespace {

/// Lines of a text, counted; without the carriage return.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool next() {
    if (again_) {
      again_ = false;
      return true;
    }
    if (rest_.empty()) {
      return false;
    }
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number;
    const std::size_t last = line.find_last_not_of(" \t\r");
    line = line.substr(0, last == std::string_view::npos ? 0 : last + 1);
    return true;
  }

  /// The next line is this one.
  void again() { again_ = true; }

  std::string_view line;
  std::size_t number = 0;

 private:
  std::string_view rest_;
  bool again_ = false;
};

class MovingAiReader {
 public:
  MovingAiReader(const table::Bytes& bytes, std::string file)
      : lines_(bytes.view()), file_(std::move(file)) {}

  [[nodiscard]] bool read(Raster& raster) {
    return read_header(raster) && read_cells(raster) && read_end(raster);
  }

  [[nodiscard]] std::vector<table::Diagnostic> take() { return std::move(problems_); }

 private:
  bool fail(std::string expectation) {
    problems_.push_back({table::Severity::error,
                         file_,
                         lines_.number,
                         "",
                         table::shortened(lines_.line),
                         std::move(expectation),
                         1});
    return false;
  }

  [[nodiscard]] bool read_header(Raster& raster) {
    while (lines_.next()) {
      if (lines_.line == "map" || lines_.line == "MapData") {
        return fits(raster);
      }
      if (begins_cells(raster)) {
        lines_.again();
        return fits(raster);
      }
      if (!lines_.line.empty() && !read_field(raster)) {
        return false;
      }
    }
    return fail("a line 'map' or 'MapData' before the cells");
  }

  /// A line of the header: its name, and what it says.
  [[nodiscard]] bool read_field(Raster& raster) {
    const std::string_view line = lines_.line;
    const std::size_t split = line.find_first_of(" =");
    const std::string_view key = line.substr(0, split);
    if (key == "type") {
      return true;
    }
    if (key == "free" || key == "obstacle") {
      return read_signs(key == "free" ? free_ : obstacle_, line.substr(key.size()));
    }
    std::size_t* const value = key == "height" || key == "MapHeight" ? &raster.rows
                               : key == "width" || key == "MapWidth" ? &raster.columns
                                                                     : nullptr;
    if (value == nullptr || split == std::string_view::npos) {
      return fail("type, height, width, free, obstacle, map, or MapHeight=, MapWidth=, MapData");
    }
    const std::string_view digits = line.substr(split + 1);
    const auto [stop, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), *value);
    return (error == std::errc{} && stop == digits.data() + digits.size()) ||
           fail("a whole number of cells");
  }

  [[nodiscard]] bool fits(const Raster& raster) {
    if (raster.columns == 0 || raster.rows == 0) {
      return fail("height and width, both above 0, before the map");
    }
    if (raster.columns > kMostRasterCells / raster.rows) {
      return fail("at most 100 million cells");
    }
    return true;
  }

  /// Some headers end without a line 'map'.
  [[nodiscard]] bool begins_cells(const Raster& raster) const {
    return raster.rows > 0 && raster.columns > 0 && lines_.line.size() == raster.columns &&
           std::all_of(lines_.line.begin(), lines_.line.end(), [&](char c) {
             return is_free(c).has_value();
           });
  }

  /// "free ." and "obstacle @": further signs, one after the other or with blanks between.
  [[nodiscard]] bool read_signs(std::string& signs, std::string_view rest) {
    const std::size_t before = signs.size();
    for (const char c : rest) {
      if (c != ' ' && c != '\t' && c != '=') {
        signs += c;
      }
    }
    const auto is_both = [&](char c) { return signs_of_other(signs).find(c) != std::string::npos; };
    if (signs.size() == before) {
      return fail("a sign after 'free' or 'obstacle'");
    }
    if (std::any_of(signs.begin() + static_cast<std::ptrdiff_t>(before), signs.end(), is_both)) {
      return fail("a sign that is either free or an obstacle");
    }
    return true;
  }

  [[nodiscard]] const std::string& signs_of_other(const std::string& signs) const {
    return &signs == &free_ ? obstacle_ : free_;
  }

  /// What the header says of a sign goes before what it usually means.
  [[nodiscard]] std::optional<bool> is_free(char cell) const {
    for (const auto& [signs, free] : {std::pair{std::string_view(free_), true},
                                      {std::string_view(obstacle_), false},
                                      {std::string_view(".GS"), true},
                                      {std::string_view("@OTW"), false}}) {
      if (signs.find(cell) != std::string_view::npos) {
        return free;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] bool read_cells(Raster& raster) {
    for (std::size_t row = 0; row < raster.rows; ++row) {
      if (!lines_.next()) {
        return fail(std::to_string(raster.rows) + " rows, as the header says, but there are " +
                    std::to_string(row));
      }
      if (lines_.line.size() != raster.columns) {
        return fail(std::to_string(raster.columns) + " cells, as the header says, but there are " +
                    std::to_string(lines_.line.size()));
      }
      for (const char cell : lines_.line) {
        const std::optional<bool> free = is_free(cell);
        if (!free) {
          return fail("cells of . G S (free) and @ O T W, or of the header's free and obstacle");
        }
        raster.occupied.push_back(*free ? 0 : 1);
      }
    }
    return true;
  }

  [[nodiscard]] bool read_end(const Raster& raster) {
    while (lines_.next()) {
      if (!lines_.line.empty()) {
        return fail("the end of the file after " + std::to_string(raster.rows) +
                    " rows, as the header says: one map a file");
      }
    }
    return true;
  }

  Lines lines_;
  std::string file_;
  std::string free_;
  std::string obstacle_;
  std::vector<table::Diagnostic> problems_;
};

}  // namespace

WorldsResult world_from_moving_ai(const table::Bytes& bytes,
                                  const std::string& file,
                                  const WorldFrame& frame) {
  WorldsResult result;
  MovingAiReader reader(bytes, file);
  Raster raster;
  if (reader.read(raster)) {
    World world = raster_world(raster, {0.0, 0.0}, frame.cell_m);
    world.start = frame.start;
    world.goal = frame.goal;
    result.worlds.push_back(std::move(world));
  }
  result.diagnostics = reader.take();
  return result;
}

}  // namespace tcert
