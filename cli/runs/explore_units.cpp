#include "cli/runs/explore_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/runs/data_file.hpp"

namespace tcert::cli {
namespace {

/// Changes what was given by flag.
class Conversion {
 public:
  Conversion(ExploreRequest& request, const TerrainGrid& terrain)
      : request_(request), terrain_(terrain), cell_(terrain.frame.x_step) {}

  void run() {
    places("start", request_.start);
    places("goal", request_.goal);
    length("kernel-length-scale", request_.kernel_length_scale);
    length("robot-radius", request_.robot_radius);
    length("simplification", request_.simplification);
    length("sub-goal-depth", request_.sub_goal_depth);
    if (request_.least_length_scale) {
      length("least-length-scale", *request_.least_length_scale);
    }
    if (given("lipschitz") && request_.lipschitz != "auto") {
      request_.lipschitz =
          fmt::format("{}", numbers("lipschitz", request_.lipschitz, 1)[0] * cell_);
    }
    if (given("gradient-prior")) {
      const std::vector<double> v = numbers("gradient-prior", request_.gradient_prior, 2);
      request_.gradient_prior = fmt::format("{},{}", v[0] * cell_, v[1]);
    }
    if (given("body")) {
      std::vector<double> v = numbers_of("body", request_.body);
      std::string text;
      for (std::size_t k = 0; k < v.size(); ++k) {
        // The third is an angle.
        text += (k > 0 ? "," : "") + fmt::format("{}", k < 2 ? v[k] / cell_ : v[k]);
      }
      request_.body = text;
    }
  }

 private:
  [[nodiscard]] bool given(std::string_view name) const { return is_given(request_.given, name); }

  void length(std::string_view name, double& value) const {
    if (given(name)) {
      value /= cell_;
    }
  }

  [[nodiscard]] static std::vector<double> numbers(const std::string& option,
                                                   const std::string& text,
                                                   std::size_t count) {
    std::vector<double> v = numbers_of(option, text);
    if (v.size() != count) {
      throw UsageError(fmt::format("--{}: found '{}', expected {} numbers", option, text, count));
    }
    return v;
  }

  void places(const std::string& option, std::string& text) const {
    if (!given(option)) {
      return;
    }
    std::string cells;
    std::size_t at = 0;
    while (at < text.size()) {
      const std::size_t end = std::min(text.find(';', at), text.size());
      cells += (cells.empty() ? "" : ";") + cell_at(option, text.substr(at, end - at));
      at = end + 1;
    }
    text = cells;
  }

  [[nodiscard]] std::string cell_at(const std::string& option, const std::string& text) const {
    const std::vector<double> v = numbers(option, text, 2);
    const MapFrame& frame = terrain_.frame;
    const double first = (v[0] - frame.east) / cell_;
    const double second = (frame.rows_run_south ? frame.north - v[1] : v[1] - frame.north) / cell_;
    const double x = std::round(frame.rows_run_south ? second : first);
    const double y = std::round(frame.rows_run_south ? first : second);
    if (!(x >= 0.0 && x < terrain_.rows && y >= 0.0 && y < terrain_.columns)) {
      const auto [west, east] = std::minmax(
          {frame.first_of(0, 0), frame.first_of(terrain_.rows - 1, terrain_.columns - 1)});
      const auto [south, north] = std::minmax(
          {frame.second_of(0, 0), frame.second_of(terrain_.rows - 1, terrain_.columns - 1)});
      throw UsageError(fmt::format(
          "--{}: found '{}', expected a place on the map, from {:.10g},{:.10g} to {:.10g},{:.10g}",
          option,
          text,
          west,
          south,
          east,
          north));
    }
    return fmt::format("{},{}", static_cast<int>(x), static_cast<int>(y));
  }

  ExploreRequest& request_;
  const TerrainGrid& terrain_;
  double cell_;
};

}  // namespace

std::optional<MapFrame> map_of(const ExploreRequest& request, const TerrainGrid& terrain) {
  return request.units == "metres" ? std::optional(terrain.frame) : std::nullopt;
}

ExploreRequest in_cells(const ExploreRequest& request, TerrainGrid& terrain) {
  ExploreRequest cells = request;
  const bool told = is_given(request.given, "cell-size");
  if (told && terrain.frame.is_declared) {
    throw UsageError(
        fmt::format("--cell-size has no effect on a file that says it itself, {:g}: leave it out",
                    terrain.frame.x_step));
  }
  if (told) {
    terrain.frame.x_step = terrain.frame.y_step = request.cell_size;
  }
  if (request.units != "metres") {
    return cells;
  }
  if (!terrain.frame.is_declared && !told) {
    throw UsageError(
        "--units metres: the terrain does not say how large its cells are; give "
        "--cell-size M");
  }
  if (!terrain.frame.is_square()) {
    throw UsageError(fmt::format(
        "--units metres: the cells are {:g} x {:g}, not square; resample them (gdalwarp -tr)",
        terrain.frame.x_step,
        terrain.frame.y_step));
  }
  Conversion(cells, terrain).run();
  return cells;
}

}  // namespace tcert::cli
