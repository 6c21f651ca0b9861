#include <terrain/components.hpp>
#include <terrain/controller.hpp>
#include <terrain/projection.hpp>
#include <terrain/pursuit.hpp>
#include <terrain/routes.hpp>
#include <terrain/ways.hpp>

namespace tcert::terrain {
namespace {

/// Over a route, to a cell or nowhere.
void walk(Way& way, const std::vector<Cell>& route, bool is_goal) {
  for (std::size_t k = 1; k < route.size(); ++k) {
    // The end is visited by the measurement there, if there is one.
    if (k + 1 < route.size() || is_goal) {
      way.cells.push_back(route[k]);
    }
    way.points.push_back(position(route[k]));
  }
  way.walked += route_length(route);
}

/// As far as the controller brings the robot; returns the cell where it stands.
Cell react(Way& way,
           const Grid& grid,
           const CellSet& ground,
           Position from,
           Cell to,
           const ExploreSetup& setup) {
  ControllerOptions options;
  options.robot_radius = setup.robot_radius;
  options.simplification = setup.simplification;
  Cell target = to;
  if (setup.sub_goal_depth > 0.0 && setup.rules.kind != RuleSet::published) {
    // Out of the rim that outlines give up, where the map has no sense; and not into it.
    const CellSet part = component_of(grid, ground, nearest_cell(from));
    target = nearest_deep(grid, part, to, setup.sub_goal_depth).value_or(to);
    const Cell deep = nearest_deep(grid, part, nearest_cell(from), setup.sub_goal_depth)
                          .value_or(nearest_cell(from));
    walk(way, shortest_route(grid, ground, nearest_cell(from), deep), true);
    from = position(deep);
  }
  const ReactiveWay driven = reactive_way(grid, ground, from, position(target), options);
  way.free_space = driven.free_space;
  Cell before = nearest_cell(from);
  for (std::size_t k = 1; k < driven.path.size(); ++k) {
    const Cell c = nearest_cell(driven.path[k]);
    way.driven.push_back((driven.path[k] - driven.path[k - 1]).norm());
    if (!(c == before)) {
      way.cells.push_back(c);
      before = c;
    }
    way.points.push_back(driven.path[k]);
  }
  way.fell_back = !driven.arrived;
  return before;
}

void pursue(Way& way, const std::vector<Position>& points, bool is_goal) {
  for (std::size_t k = 1; k < points.size(); ++k) {
    const std::vector<Cell> cells = cells_along(points[k - 1], points[k]);
    way.cells.insert(way.cells.end(), cells.begin(), cells.end());
    way.points.push_back(points[k]);
  }
  if (!is_goal && !way.cells.empty()) {
    way.cells.pop_back();  // The end is visited by the measurement there.
  }
  way.walked += length_of(points);
}

}  // namespace

Way way_to(const Grid& grid,
           const CellSet& ground,
           const Position& from,
           Cell to,
           bool is_goal,
           const ExploreSetup& setup) {
  Way way;
  if (setup.motion == Motion::pursuit) {
    const std::vector<Position> points = pursuit_way(grid, ground, from, to);
    if (!points.empty()) {
      pursue(way, points, is_goal);
      return way;
    }
  }
  Cell at = nearest_cell(from);
  if (setup.motion == Motion::reactive) {
    at = react(way, grid, ground, from, to, setup);
  }
  std::vector<Cell> route;
  if (setup.motion != Motion::jump) {
    route = shortest_route(grid, ground, at, to);
  }
  if (route.empty()) {
    route = {at, to};
  }
  walk(way, route, is_goal);
  return way;
}

}  // namespace tcert::terrain
