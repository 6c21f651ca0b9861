#include <algorithm>
#include <charconv>
#include <cmath>
#include <federation/submap_text.hpp>
#include <tcert/tick.hpp>
#include <utility>

namespace tcert::federation {
namespace {

constexpr double kMostMargin = 1e9;

void append(std::string& out, double value) {
  std::array<char, 32> digits{};
  auto* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

void append_cell(std::string& out, double value) {
  out += ',';
  if (std::isinf(value)) {
    out += '-';
  } else {
    append(out, value);
  }
}

std::string_view word_of(Side side) noexcept { return side == Side::front ? "front" : "back"; }

std::string_view place_of(const SubmapNode& node) noexcept {
  if (node.in_start) {
    return node.in_goal ? "SG" : "S";
  }
  return node.in_goal ? "G" : "-";
}

class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  ReadSubmap read() {
    if (rest_.size() > kMostBytes) {
      return refused(0,
                     std::to_string(rest_.size()) + " bytes",
                     "at most " + std::to_string(kMostBytes) + " bytes");
    }
    if (!next_line()) {
      return refused(0, "nothing", "tcert-submap,1");
    }
    if (cells_[0] != "tcert-submap" || !has(2)) {
      return refused(0, line_, "tcert-submap,1");
    }
    if (cells_[1] != "1") {
      return refused(2, cells_[1], "version 1, the only one that this reader knows");
    }
    while (next_line()) {
      if (!read_line()) {
        return {std::nullopt, std::move(problem_)};
      }
    }
    if (!has_agent_) {
      return refused(0, "the end", "a line 'agent'");
    }
    return {in_order(std::move(submap_)), {}};
  }

 private:
  static constexpr std::size_t kMostCells = 7;

  // To the next line that says something; false at the end.
  bool next_line() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      ++number_;
      if (line_.ends_with('\r')) {
        line_.remove_suffix(1);
      }
      if (!line_.empty() && line_.front() != '#') {
        split();
        return true;
      }
    }
    return false;
  }

  void split() {
    count_ = 0;
    std::string_view rest = line_;
    for (;;) {
      const std::size_t comma = rest.find(',');
      if (count_ < kMostCells) {
        cells_[count_] = rest.substr(0, comma);
      }
      ++count_;
      if (comma == std::string_view::npos) {
        return;
      }
      rest.remove_prefix(comma + 1);
    }
  }

  [[nodiscard]] bool has(std::size_t cells) const noexcept { return count_ == cells; }

  bool fail(std::size_t column, std::string expected) {
    const std::string_view found = column == 0 ? line_ : cells_[column - 1];
    problem_ = {number_, column, std::string(found.substr(0, 80)), std::move(expected)};
    return false;
  }

  ReadSubmap refused(std::size_t column, std::string_view found, std::string expected) {
    problem_ = {number_, column, std::string(found.substr(0, 80)), std::move(expected)};
    return {std::nullopt, std::move(problem_)};
  }

  bool read_line() {
    const std::string_view word = cells_[0];
    if (!has_agent_) {
      has_agent_ = word == "agent";
      return has_agent_            ? read_agent()
             : word == "synthetic" ? read_synthetic()
                                   : fail(0, "agent, before any source");
    }
    return word == "source" ? read_source()
           : word == "node" ? read_node()
           : word == "edge" ? read_edge()
                            : fail(1, "source, node or edge");
  }

  // Cell `column` (from 1) as a number within [low, high].
  bool number(std::size_t column, double low, double high, double& value) {
    const std::string_view cell = cells_[column - 1];
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !(value >= low) ||
        !(value <= high)) {
      std::string range = "a number from ";
      append(range, low);
      range += " to ";
      append(range, high);
      return fail(column, std::move(range));
    }
    return true;
  }

  bool bound(std::size_t column, double& value) {
    return cells_[column - 1] == "-" || number(column, 0.0, kLargestPose, value);
  }

  bool read_synthetic() {
    if (!has(2)) {
      return fail(0, "synthetic and a seed");
    }
    const std::string_view seed = cells_[1];
    const bool is_number = !seed.empty() && seed.size() <= 20 &&
                           std::ranges::all_of(seed, [](char c) { return c >= '0' && c <= '9'; });
    submap_.synthetic = seed;
    return is_number || seed == "-" || seed == "several" || fail(2, "a seed, - or several");
  }

  bool read_agent() {
    Agent& agent = submap_.agent;
    return (has(5) || fail(0, "agent and four numbers")) &&
           number(2, 1e-9, 1e4, agent.body_width_m) &&
           number(3, 0.0, 1e6, agent.min_turn_radius_m) &&
           number(4, 0.0, 1e4, agent.tracking_buffer_m) &&
           number(5, 0.0, 1e6, agent.curvature_buffer_per_m);
  }

  bool read_source() {
    if (!has(5)) {
      return fail(0, "source, a name, what margins are read by and two bounds of the frame");
    }
    Source source;
    if (!is_name(cells_[1])) {
      return fail(2, "1 to 100 letters, digits, '.', '_', '-' or '/'");
    }
    source.name = cells_[1];
    const std::optional<MarginKind> kind = margin_kind_from(cells_[2]);
    if (!kind) {
      return fail(3, "witness, swept, radial or width");
    }
    source.margins = *kind;
    if (!bound(4, source.frame_error_m) || !bound(5, source.frame_error_rad)) {
      return false;
    }
    submap_.sources.push_back(std::move(source));
    return true;
  }

  bool read_node() {
    if (submap_.sources.empty() || !has(6)) {
      return fail(
          0, submap_.sources.empty() ? "a source before it" : "node, a pose, a place and a margin");
    }
    SubmapNode node;
    if (!number(2, -kLargestPose, kLargestPose, node.pose.position.x_m) ||
        !number(3, -kLargestPose, kLargestPose, node.pose.position.y_m) ||
        !number(4, -kLargestPose, kLargestPose, node.pose.yaw_rad)) {
      return false;
    }
    const std::string_view place = cells_[4];
    if (place != "S" && place != "G" && place != "SG" && place != "-") {
      return fail(5, "S, G, SG or -");
    }
    node.in_start = place.front() == 'S';
    node.in_goal = place.back() == 'G';
    if (cells_[5] != "-" && !number(6, -kMostMargin, kMostMargin, node.margin_m)) {
      return false;
    }
    submap_.sources.back().nodes.push_back(node);
    return true;
  }

  bool end(std::size_t column, EdgeEnd& end) {
    const std::string_view cell = cells_[column - 1];
    const auto [last, error] = std::from_chars(cell.data(), cell.data() + cell.size(), end.node);
    const std::size_t nodes = submap_.sources.back().nodes.size();
    if (error != std::errc{} || last != cell.data() + cell.size() || end.node >= nodes) {
      return fail(column,
                  "a node of the source above it, of which there are " + std::to_string(nodes));
    }
    const std::string_view side = cells_[column];
    if (side != "front" && side != "back") {
      return fail(column + 1, "front or back");
    }
    end.side = side == "front" ? Side::front : Side::back;
    return true;
  }

  bool read_edge() {
    if (submap_.sources.empty() || !has(7)) {
      return fail(0,
                  submap_.sources.empty()
                      ? "a source before it"
                      : "edge, two nodes with a side each, a margin and a spread");
    }
    SubmapEdge edge;
    if (!end(2, edge.ends[0]) || !end(4, edge.ends[1]) ||
        !number(6, -kMostMargin, kMostMargin, edge.margin_m) || !bound(7, edge.spread_m)) {
      return false;
    }
    submap_.sources.back().edges.push_back(edge);
    return true;
  }

  std::string_view rest_;
  std::string_view line_;
  std::array<std::string_view, kMostCells> cells_;
  std::size_t count_ = 0;
  std::size_t number_ = 0;
  bool has_agent_ = false;
  Submap submap_;
  TextProblem problem_;
};

void append_source(std::string& out, const Source& source) {
  out += "source," + source.name + ',';
  out += name_of(source.margins);
  append_cell(out, source.frame_error_m);
  append_cell(out, source.frame_error_rad);
  out += '\n';
  for (const SubmapNode& node : source.nodes) {
    out += "node";
    append_cell(out, node.pose.position.x_m);
    append_cell(out, node.pose.position.y_m);
    append_cell(out, node.pose.yaw_rad);
    out += ',';
    out += place_of(node);
    append_cell(out, node.margin_m);
    out += '\n';
  }
  for (const SubmapEdge& edge : source.edges) {
    out += "edge";
    for (const EdgeEnd& end : edge.ends) {
      out += ',' + std::to_string(end.node) + ',';
      out += word_of(end.side);
    }
    append_cell(out, edge.margin_m);
    append_cell(out, edge.spread_m);
    out += '\n';
  }
}

}  // namespace

std::string to_string(const TextProblem& problem) {
  if (problem.line == 0) {
    return "found '" + problem.found + "', expected " + problem.expected;
  }
  std::string text = "line " + std::to_string(problem.line);
  if (problem.column > 0) {
    text += ", cell " + std::to_string(problem.column);
  }
  return text + ": found '" + problem.found + "', expected " + problem.expected;
}

ReadSubmap read_submap(std::string_view text) { return Reader(text).read(); }

std::string to_text(const Submap& submap) {
  std::string out = "tcert-submap,1\n";
  if (!submap.synthetic.empty()) {
    out += "synthetic," + submap.synthetic + '\n';
  }
  out += "agent";
  append_cell(out, submap.agent.body_width_m);
  append_cell(out, submap.agent.min_turn_radius_m);
  append_cell(out, submap.agent.tracking_buffer_m);
  append_cell(out, submap.agent.curvature_buffer_per_m);
  out += '\n';
  for (const Source& source : submap.sources) {
    append_source(out, source);
  }
  return out;
}

}  // namespace tcert::federation
