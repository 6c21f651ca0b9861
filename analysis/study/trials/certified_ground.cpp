#include "analysis/study/trials/certified_ground.hpp"

#include <cmath>
#include <stdexcept>
#include <terrain/pursuit.hpp>

namespace tcert::study {

CertifiedGround::CertifiedGround(const TerrainGrid& safe, double body_width_m)
    : frame_(safe.frame), grid_{safe.rows, safe.columns} {
  if (!frame_.is_declared || !frame_.is_square()) {
    throw std::invalid_argument(
        "the ground needs map coordinates and square cells: an ESRI ASCII grid, or points x, y, "
        "value");
  }
  terrain::CellSet ground(safe.values.size());
  for (std::size_t i = 0; i < ground.size(); ++i) {
    ground[i] = safe.values[i] == 1.0 ? 1 : 0;
  }
  terrain::Body body;
  body.kind = terrain::Body::Kind::disc;
  body.radius = 0.5 * body_width_m / frame_.x_step;
  standing_ = terrain::standing_cells(grid_, ground, terrain::Footprint(body));
}

terrain::Position CertifiedGround::cells_of(const Point& p) const {
  const double first = (p.x_m - frame_.east) / frame_.x_step;
  const double second =
      (frame_.rows_run_south ? frame_.north - p.y_m : p.y_m - frame_.north) / frame_.x_step;
  return frame_.rows_run_south ? terrain::Position(second, first)
                               : terrain::Position(first, second);
}

bool CertifiedGround::holds(const Point& p, const Point& q) const {
  const terrain::Position a = cells_of(p);
  const terrain::Position b = cells_of(q);
  return terrain::is_near(a) && terrain::is_near(b) &&
         terrain::stays_on_ground(grid_, standing_, a, b);
}

TickTable CertifiedGround::ticks_on(const TickTable& ticks) const {
  TickTable kept;
  kept.rays = ticks.rays;
  bool was_kept = false;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const Point at = ticks.poses[i].position;
    const bool keep = holds(at, at);
    if (keep) {
      const Point before = i > 0 ? ticks.poses[i - 1].position : at;
      const bool broken = (i > 0 && !was_kept) || !holds(before, at);
      const Tick tick = ticks[i];
      kept.time_ns.push_back(tick.time_ns);
      kept.poses.push_back(tick.pose);
      kept.readings.insert(kept.readings.end(), tick.rays.begin(), tick.rays.end());
      kept.stale.push_back(ticks.stale[i]);
      if (!ticks.footing.empty()) {
        kept.footing.push_back(ticks.footing[i]);
      }
      kept.segment_start.push_back(broken || tick.segment_start ? 1 : 0);
      kept.speed_cmd_mps.push_back(ticks.speed_cmd_mps[i]);
      kept.yaw_rate_cmd_rps.push_back(ticks.yaw_rate_cmd_rps[i]);
    }
    was_kept = keep;
  }
  return kept;
}

}  // namespace tcert::study
