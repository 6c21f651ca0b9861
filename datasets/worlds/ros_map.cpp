#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <table/file_kind.hpp>
#include <table/trimmed.hpp>
#include <tcert/elementary.hpp>

#include "datasets/png_image.hpp"
#include "datasets/worlds/raster_world.hpp"
#include "datasets/worlds/world_files.hpp"

namespace tcert {
namespace {

using table::trimmed;

std::string_view unquoted(std::string_view text) {
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front()) {
    return text.substr(1, text.size() - 2);
  }
  return text;
}

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && stop == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// What was expected, or null: "[x, y, yaw]".
const char* read_origin(std::string_view text, RosMap& map) {
  constexpr const char* kExpected = "[x, y, yaw] in metres and radians, on one line or a line each";
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') {
    return kExpected;
  }
  text = text.substr(1, text.size() - 2);
  std::array<double, 3> values{};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t comma = k + 1 < values.size() ? text.find(',') : text.size();
    if (comma == std::string_view::npos) {
      return kExpected;
    }
    const auto value = number_of(trimmed(text.substr(0, comma)));
    if (!value) {
      return kExpected;
    }
    values[k] = *value;
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  map.origin = {values[0], values[1]};
  map.yaw_rad = values[2];
  constexpr double kMostYaw = 100.0;
  return std::abs(values[2]) <= kMostYaw ? nullptr : kExpected;
}

constexpr const char* kUnknownKey =
    "image, resolution, origin, negate, occupied_thresh, free_thresh or mode; this has no effect";

/// What was expected of the value, or null if it is fine.
const char* read_key(std::string_view key, std::string_view value, RosMap& map) {
  const auto number = number_of(value);
  if (key == "image") {
    map.image = std::string(unquoted(value));
    return map.image.empty() ? "the name of an image" : nullptr;
  }
  if (key == "resolution") {
    map.resolution_m = number.value_or(0.0);
    return map.resolution_m > 0.0 ? nullptr : "metres a cell, above 0";
  }
  if (key == "origin") {
    return read_origin(value, map);
  }
  if (key == "negate") {
    map.negate = value == "1" || value == "true";
    return map.negate || value == "0" || value == "false" ? nullptr : "0 or 1";
  }
  if (key == "occupied_thresh" || key == "free_thresh") {
    (key == "free_thresh" ? map.free_threshold : map.occupied_threshold) = number.value_or(-1.0);
    return number && *number >= 0.0 && *number <= 1.0 ? nullptr : "a number from 0 to 1";
  }
  if (key == "mode") {
    return value == "trinary" ? nullptr : "trinary, the only mode with free and occupied";
  }
  return kUnknownKey;
}

/// "- 1.5" as the next number of a list that began with a key alone: "origin:".
bool continue_list(std::string_view line, std::string& list) {
  if (line.front() != '-' || (line.size() > 1 && line[1] != ' ' && line[1] != '\t')) {
    return false;
  }
  list += (list.empty() ? "" : ", ") + std::string(trimmed(line.substr(1)));
  return true;
}

/// Header fields and plain pixels of a PGM: whole numbers between blanks and # comments.
class PgmText {
 public:
  explicit PgmText(std::string_view text) : text_(text) {}

  [[nodiscard]] std::optional<std::size_t> number() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
        ++at_;
      } else {
        break;
      }
    }
    std::size_t value = 0;
    const auto [stop, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc{}) {
      return std::nullopt;
    }
    at_ = static_cast<std::size_t>(stop - text_.data());
    return value;
  }

  [[nodiscard]] std::string_view rest() const { return text_.substr(std::min(at_, text_.size())); }
  void skip(std::size_t bytes) { at_ += bytes; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

struct Pgm {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t most = 0;
  std::vector<std::uint16_t> pixels;
  std::vector<std::uint8_t> unknown;  // of a PNG, not 0 where it is transparent; or empty
};

/// Colours are averaged, as map_server does it. Empty iff the image was read.
std::string read_png_pixels(std::string_view bytes, Pgm& image) {
  const PngResult png = read_png(bytes, kMostRasterCells);
  image.columns = png.image.columns;
  image.rows = png.image.rows;
  image.most = 765;  // Three channels of 255.
  const std::vector<std::uint8_t>& rgba = png.image.pixels;
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    image.pixels.push_back(static_cast<std::uint16_t>(rgba[i] + rgba[i + 1] + rgba[i + 2]));
    image.unknown.push_back(rgba[i + 3] == 0 ? 1 : 0);
  }
  return png.problem;
}

/// Empty iff the pixels were read; else what was expected: `wanted`, and what is wrong.
std::string read_plain(PgmText& fields, const std::string& wanted, Pgm& image) {
  const std::size_t count = image.columns * image.rows;
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = fields.number();
    if (!value || *value > image.most) {
      return wanted + ", but pixel " + std::to_string(i) + " is missing or too large";
    }
    image.pixels.push_back(static_cast<std::uint16_t>(*value));
  }
  if (fields.number() || !trimmed(fields.rest()).empty()) {
    return wanted + ", and then the end of the file: one map a file";
  }
  return {};
}

/// Likewise, of bytes.
std::string read_raw(std::string_view raw, const std::string& wanted, Pgm& image) {
  const std::size_t count = image.columns * image.rows;
  const std::size_t width = image.most > 255 ? 2 : 1;
  if (raw.size() != count * width) {
    return wanted + " in " + std::to_string(count * width) + " bytes, but there are " +
           std::to_string(raw.size());
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto high = static_cast<unsigned char>(raw[i * width]);
    const unsigned value =
        width == 1 ? high : high * 256U + static_cast<unsigned char>(raw[i * width + 1]);
    if (value > image.most) {
      return wanted + ", but pixel " + std::to_string(i) + " is too large";
    }
    image.pixels.push_back(static_cast<std::uint16_t>(value));
  }
  return {};
}

/// Empty iff the image was read; else what was expected.
std::string read_image(std::string_view text, const std::string& file, Pgm& image) {
  const auto kind = table::kind_of_binary(text, file);
  if (kind && kind->name == "a PNG image") {
    return read_png_pixels(text, image);
  }
  const bool plain = text.substr(0, 2) == "P2";
  if (!plain && text.substr(0, 2) != "P5") {
    return "a PGM image, P2 or P5, or a PNG image" +
           (kind ? ", but this is " + kind->name + ": convert it to PGM (convert " + file +
                       " map.pgm) and name that in the YAML"
                 : std::string());
  }
  PgmText fields(text.substr(2));
  for (std::size_t* const field : {&image.columns, &image.rows, &image.most}) {
    const auto value = fields.number();
    if (!value || *value == 0) {
      return "width, height and largest value, all above 0";
    }
    *field = *value;
  }
  if (image.most > 65535 || image.columns > kMostRasterCells / image.rows) {
    return "at most 100 million pixels of at most 65535";
  }
  const std::string wanted = std::to_string(image.columns) + " x " + std::to_string(image.rows) +
                             " pixels, as the header says";
  if (plain) {
    return read_plain(fields, wanted, image);
  }
  fields.skip(1);
  return read_raw(fields.rest(), wanted, image);
}

Point turned_back(Point p, const RosMap& map) {
  const double c = elementary::cos(map.yaw_rad);
  const double s = elementary::sin(map.yaw_rad);
  const Point d = p - map.origin;
  return map.origin + Point{c * d.x_m + s * d.y_m, c * d.y_m - s * d.x_m};
}

/// A region of the map's frame in the axes of its image.
std::optional<Region> turned_back(std::optional<Region> region, const RosMap& map) {
  if (!region || map.yaw_rad == 0.0) {
    return region;
  }
  if (auto* const disc = std::get_if<Disc>(&*region)) {
    disc->centre = turned_back(disc->centre, map);
  } else {
    for (Point& vertex : std::get<Polygon>(*region).vertices) {
      vertex = turned_back(vertex, map);
    }
  }
  return region;
}

}  // namespace

std::optional<RosMap> read_ros_yaml(const table::Bytes& bytes,
                                    const std::string& file,
                                    std::vector<table::Diagnostic>& diagnostics) {
  RosMap map;
  std::string_view text = bytes.view();
  bool good = true;
  const auto take = [&](std::string_view key, std::string_view value, std::size_t number) {
    if (const char* const expected = read_key(key, value, map)) {
      const bool unknown = expected == kUnknownKey;
      diagnostics.push_back({unknown ? table::Severity::warning : table::Severity::error,
                             file,
                             number,
                             table::shortened(key),
                             table::shortened(value),
                             expected,
                             1});
      good = good && unknown;
    }
  };
  // A list a line each, from the line of its key on; ended by whatever is no member.
  std::string list_key;
  std::string list;
  std::size_t list_line = 0;
  const auto end_list = [&] {
    if (!list_key.empty()) {
      take(list_key, list.empty() ? "" : '[' + list + ']', list_line);
    }
    list_key.clear();
    list.clear();
  };
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = trimmed(line.substr(0, std::min(line.find('#'), line.size())));
    if (line.empty() || line == "---") {
      continue;
    }
    if (!list_key.empty() && continue_list(line, list)) {
      continue;
    }
    const std::size_t colon = std::min(line.find(':'), line.size());
    const std::string_view key = trimmed(line.substr(0, colon));
    const std::string_view value = trimmed(line.substr(std::min(colon + 1, line.size())));
    end_list();
    if (value.empty()) {
      list_key = key;
      list_line = number;
    } else {
      take(key, value, number);
    }
  }
  end_list();
  if (good && (map.image.empty() || !(map.resolution_m > 0.0))) {
    diagnostics.push_back({table::Severity::error, file, 0, "", "", "image and resolution", 1});
    good = false;
  }
  return good ? std::optional(map) : std::nullopt;
}

WorldsResult world_from_image(const table::Bytes& bytes,
                              const std::string& file,
                              const RosMap& map,
                              const WorldFrame& frame) {
  WorldsResult result;
  Pgm image;
  const std::string expected = read_image(bytes.view(), file, image);
  if (!expected.empty()) {
    result.diagnostics.push_back({table::Severity::error, file, 0, "", "", expected, 1});
    return result;
  }
  Raster raster{image.columns, image.rows, {}};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double share = static_cast<double>(image.pixels[i]) / static_cast<double>(image.most);
    const double occupancy = map.negate ? share : 1.0 - share;
    const bool is_known = image.unknown.empty() || image.unknown[i] == 0;
    raster.occupied.push_back(is_known && occupancy < map.free_threshold ? 0 : 1);
  }
  World world = raster_world(raster, map.origin, map.resolution_m);
  world.start = turned_back(frame.start, map);
  world.goal = turned_back(frame.goal, map);
  result.worlds.push_back(std::move(world));
  if (map.yaw_rad != 0.0) {
    result.diagnostics.push_back({table::Severity::warning,
                                  file,
                                  0,
                                  "origin",
                                  std::to_string(map.yaw_rad),
                                  "nothing else; the map is turned by so many radians: places are "
                                  "given in its own axes, and S and G were turned back into them",
                                  1});
  }
  return result;
}

}  // namespace tcert
