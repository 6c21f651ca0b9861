#include "reports/ray_calibration_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "datasets/robot_json.hpp"
#include "reports/columns_of.hpp"
#include "reports/findings.hpp"
#include "reports/table_json.hpp"

namespace tcert {
namespace {

/// Of metres and radians.
constexpr int kRayDecimals = 4;

Table knots_table(const study::RayCalibration& made) {
  struct Knot {
    std::string ray;
    double bend_rad;
    double clearance_m;
    double curve_m;
  };
  std::vector<Knot> knots;
  for (std::size_t ray = 0; ray < made.rays.size(); ++ray) {
    const Calibration& usable = made.usable[ray];
    for (std::size_t i = 0; i < usable.bend_rad.size(); ++i) {
      knots.push_back({made.rays[ray],
                       usable.bend_rad[i],
                       usable.clearance_m[i],
                       calibrated_clearance(made.curves[ray].calibration, usable.bend_rad[i])});
    }
  }
  Table table = ColumnsOf<Knot>()
                    .text("ray", "ray", &Knot::ray)
                    .fixed("bend_rad", "bend", "rad", kRayDecimals, &Knot::bend_rad)
                    .fixed("clearance_m", "clearance", "m", kRayDecimals, &Knot::clearance_m)
                    .fixed("curve_m", "curve", "m", kRayDecimals, &Knot::curve_m)
                    .table("ray_knots", "Knots of the calibrations", knots);
  table.footnotes = {
      made.bound ? "clearance: the lower bound, the curve less q, at least 0; curve: the isotonic "
                   "fit, thinned."
                 : "clearance: the curve itself, the isotonic fit, thinned; it is no bound."};
  return table;
}

Table curves_table(const study::RayCalibration& made) {
  struct Row {
    std::string ray;
    const study::RayCurve* curve;
    double longest_m;
  };
  std::vector<Row> rows;
  for (std::size_t ray = 0; ray < made.rays.size(); ++ray) {
    const std::vector<double>& clearance = made.usable[ray].clearance_m;
    rows.push_back({made.rays[ray], &made.curves[ray], std::ranges::max(clearance)});
  }
  const auto of = [](auto member) {
    return [member](const Row& row) { return row.curve->*member; };
  };
  Table table =
      ColumnsOf<Row>()
          .text("ray", "ray", &Row::ray)
          .text("trend",
                "more bend means",
                [](const Row& row) {
                  return row.curve->trend == statistics::Trend::falling ? std::string("less")
                                                                        : std::string("more");
                })
          .integer("pairs", "pairs", of(&study::RayCurve::pairs))
          .integer("knots",
                   "knots",
                   [](const Row& row) { return row.curve->calibration.bend_rad.size(); })
          .fixed("residual_m",
                 "residual, root mean square",
                 "m",
                 kRayDecimals,
                 of(&study::RayCurve::residual_m))
          .fixed("thinning_m",
                 "largest error of thinning",
                 "m",
                 kRayDecimals,
                 of(&study::RayCurve::thinning_m))
          .fixed("longest_m", "longest that it states", "m", kRayDecimals, &Row::longest_m)
          .table("ray_curves", "The curves", rows);
  table.footnotes = {
      fmt::format("Fitted to {} days: {}.", made.fitted.size(), fmt::join(made.fitted, ", "))};
  if (made.bound) {
    table.footnotes.emplace_back("Thinning is part of the curve, and so of the scores and of q.");
  }
  return table;
}

Table days_table(const study::RayCalibration& made) {
  using Day = study::DayScore;
  Table table = ColumnsOf<Day>()
                    .text("day", "day", &Day::day)
                    .integer("pairs", "pairs", &Day::pairs)
                    .fixed("score_m", "score", "m", kRayDecimals, &Day::score_m)
                    .text("ray", "at the ray", [&](const Day& day) { return made.rays[day.ray]; })
                    .fixed("bend_rad", "at the bend", "rad", kRayDecimals, &Day::bend_rad)
                    .fixed("clearance_m", "measured", "m", kRayDecimals, &Day::clearance_m)
                    .table("ray_days", "The days that the bound is from", made.bound->days);
  table.footnotes = {
      "score: the most by which a curve overstates a clearance, over all rays and ticks of the "
      "day; "
      "q is the score of rank " +
      std::to_string(made.bound->rank) + "."};
  return table;
}

Table summary_of(const study::RayCalibration& made, const study::RayCalibrationOptions& options) {
  Record record("summary", made.bound ? "The bound" : "The curves");
  record.integer("rays", "rays", made.rays.size())
      .integer("fitted_days", "days that curves are fitted to", made.fitted.size());
  if (made.bound) {
    const study::RayBound& bound = *made.bound;
    record.integer("bound_days", "days that the bound is from, n", bound.days.size())
        .integer("rank", "rank of q among their scores", bound.rank)
        .number("alpha", "alpha", options.alpha)
        .number("q_m", "q, m", bound.quantile_m)
        .number("coverage", "chance that a new day is covered", bound.coverage)
        .number("coverage_low", "19 of 20 such bounds cover more than", bound.coverage_low)
        .integer("bound_pairs", "pairs on the days of the bound", bound.pairs)
        .number("pairs_above", "share of them measured at the bound or above", bound.pairs_above)
        .number("median_slack_m", "median of measured less bound, m", bound.median_slack_m)
        .integer("seed", "seed of the order of days", options.seed);
  }
  return std::move(record).table();
}

Table findings_of_rays(const study::RayCalibration& made) {
  if (!made.bound) {
    return findings_table(
        {{"Rays",
          "",
          "The curves are means: about half of the clearances are below them. No bound was asked "
          "for; one needs days that the curves are not fitted to."}});
  }
  const study::RayBound& bound = *made.bound;
  std::vector<Finding> findings{
      {"Rays, lower bound",
       "",
       fmt::format(
           "Curve - q, q = {:.{}f} m, is at most the clearance at all ticks and rays of a new day "
           "with probability {:.3g} or more (rank {} of {} days; 19 of 20 bounds made like this "
           "one "
           "cover more than {:.3g} of all days).",
           bound.quantile_m,
           kRayDecimals,
           bound.coverage,
           bound.rank,
           bound.days.size(),
           bound.coverage_low)}};
  for (std::size_t ray = 0; ray < made.rays.size(); ++ray) {
    if (std::ranges::max(made.usable[ray].clearance_m) <= 0.0) {
      findings.push_back({"Ray '" + made.rays[ray] + "'",
                          "",
                          "The bound leaves nothing of its curve: it states 0 m always."});
    }
  }
  return findings_table(
      findings,
      {"The promise is for days that are exchangeable with these: the same robot, "
       "sensors and kind of course, no drift from day to day."});
}

std::string rays_json(const CalibratedRays& rays) {
  std::string text = "[";
  for (std::size_t i = 0; i < rays.rays.size(); ++i) {
    OrderedJson one = ray_json(rays.rays[i], {});  // rays that bend have no keys of ranges
    if (!rays.of_a_bundle) {
      for (const char* const key : {"mount_x_m", "mount_y_m", "bearing_rad", "reach_m"}) {
        one.erase(key);
      }
    }
    text += i == 0 ? "\n " : ",\n ";
    std::string line = dumped(one, -1);
    line.pop_back();  // the line end
    text += line;
  }
  return text + "\n]\n";
}

}  // namespace

FitReport ray_calibration_report(const study::RayCalibration& calibration,
                                 const study::RayCalibrationOptions& options,
                                 const CalibratedRays& rays) {
  FitReport report;
  report.model = "calibrate rays";
  report.findings = findings_of_rays(calibration);
  report.summary = summary_of(calibration, options);
  report.tables = {knots_table(calibration), curves_table(calibration)};
  if (calibration.bound) {
    report.tables.push_back(days_table(calibration));
  }
  report.attachments = {{"rays",
                         rays.of_a_bundle ? "For bundle.json, the list 'rays':"
                                          : "For bundle.json, what each of its 'rays' needs:",
                         rays_json(rays)}};
  return report;
}

}  // namespace tcert
