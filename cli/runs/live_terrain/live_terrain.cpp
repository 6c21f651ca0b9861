#include "cli/runs/live_terrain/live_terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <terrain/limits.hpp>
#include <terrain/session.hpp>

#include "cli/runs/explore_config.hpp"
#include "cli/runs/explore_flags.hpp"
#include "cli/runs/explore_rasters.hpp"
#include "cli/runs/explore_setup.hpp"
#include "cli/runs/explore_summary.hpp"
#include "cli/runs/explore_units.hpp"
#include "cli/runs/live_terrain/robot_lines.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/terrain_input.hpp"
#include "cli/runs/written_options.hpp"
#include "datasets/terrain/measurement_line.hpp"
#include "reports/terrain/explore_table.hpp"

namespace tcert::cli {
namespace {

/// Options of `explore` that are of no use without a terrain.
[[nodiscard]] bool is_for_a_robot(const std::string& name) {
  constexpr std::array<std::string_view, 11> kOthers{"config",
                                                     "header",
                                                     "mode",
                                                     "expanders",
                                                     "noise-variance",
                                                     "kernel-mean",
                                                     "baseline",
                                                     "start-radius",
                                                     "frames",
                                                     "seed",
                                                     "output"};
  return std::find(kOthers.begin(), kOthers.end(), name) == kOthers.end();
}

/// Where the cells lie, and which are blocked; the values of a layout are not looked at.
[[nodiscard]] TerrainGrid layout_of(const LiveTerrainRequest& request, Progress& progress) {
  const ExploreRequest& o = request.explore;
  if (!o.terrain.empty()) {
    if (request.rows != 0 || request.columns != 0) {
      throw UsageError("--rows and --columns are those of LAYOUT: leave them out");
    }
    return read_terrain_or_throw(
        o.terrain, terrain_file_options("auto", o.format, o.nodata), progress);
  }
  if (request.rows < 2 || request.columns < 2 || request.rows > terrain::kMostSide ||
      request.columns > terrain::kMostSide) {
    throw UsageError(fmt::format(
        "needs LAYOUT, a terrain file of which size, place and gaps count, or --rows and --columns "
        "from 2 to {}",
        terrain::kMostSide));
  }
  TerrainGrid layout;
  layout.rows = static_cast<int>(request.rows);
  layout.columns = static_cast<int>(request.columns);
  layout.values.assign(
      static_cast<std::size_t>(request.rows) * static_cast<std::size_t>(request.columns), 0.0);
  return layout;
}

/// Rows as they were told, and what they were told of.
struct Log {
  std::vector<LiveRow> rows;
  std::vector<TakenMeasurement> taken;
  std::vector<terrain::Position> path;
  std::optional<SyntheticLabel> label;  ///< Of the layout, or of what was measured.
};

/// The row as CSV; the header with the first.
[[nodiscard]] std::string text_of(const LiveRow& row,
                                  const std::optional<SyntheticLabel>& label,
                                  bool with_header) {
  const std::string text = render(live_table({row}, label), TableFormat::csv);
  return with_header ? text : text.substr(text.find('\n') + 1);
}

void write_record(const LiveTerrainRequest& request,
                  const Log& log,
                  const terrain::Session& session,
                  const TerrainGrid& layout) {
  ResultFolder folder(request.record, "live terrain");
  folder.write("series.csv", render(live_table(log.rows, log.label), TableFormat::csv));
  folder.write(
      "path.csv",
      render(path_table(log.path, log.label, map_of(request.explore, layout)), TableFormat::csv));
  folder.write("measurements.csv",
               render(measurement_table(log.taken, log.label), TableFormat::csv));
  const RasterFormats rasters = raster_formats_of(request.explore.rasters);
  if (rasters.any() && session.explorer() != nullptr) {
    write_rasters(folder, rasters, layout, session.explorer()->layers());
  }
  Manifest manifest;
  manifest.command = "live terrain";
  record(written(request), manifest);
  manifest.synthetic = log.label;
  for (const std::string& file :
       {request.explore.terrain, request.explore.obstacles, request.explore.known}) {
    if (!file.empty()) {
      manifest.inputs.push_back({name_of(file), digest_file(file)});
    }
  }
  folder.commit(std::move(manifest));
}

/// The robot's lines, one after the other.
class Loop {
 public:
  /// `settled` is called with the first plan.
  Loop(terrain::Session& session,
       RobotLines& robot,
       Progress& progress,
       const std::optional<SyntheticLabel>& label,
       std::function<void(const terrain::ExploreSetup&)> settled)
      : session_(session), robot_(robot), progress_(progress), settled_(std::move(settled)) {
    log_.label = label;
    for (const terrain::Measurement& m : session.setup().known) {
      log_.taken.push_back({m, false});
    }
    log_.path.push_back(terrain::position(session.setup().start));
  }

  /// Until it is over, one way or another. \throws BadData for a start that cannot be.
  void run() {
    while (!end_ && is_read_) {
      const std::optional<std::string> line = robot_.next();
      if (!line) {
        return;
      }
      ++number_;
      const MeasurementReading reading = lines_.read(*line);
      if (reading.measurement) {
        take(*reading.measurement);
      } else if (!reading.problem.empty()) {
        skip(reading.problem);
      }
    }
  }

  [[nodiscard]] const Log& log() const noexcept { return log_; }
  [[nodiscard]] const std::optional<terrain::End>& end() const noexcept { return end_; }
  [[nodiscard]] bool skipped_any() const noexcept { return bad_ > 0 || robot_.too_long() > 0; }

 private:
  void take(const MeasurementLine& m) {
    const bool is_first = session_.explorer() == nullptr;
    try {
      if (m.plan) {
        const terrain::Decision& decision = session_.plan({m.x, m.y}, m.value);
        if (is_first) {
          settled_(session_.setup());
          if (lines_.synthetic_seed()) {
            log_.label = SyntheticLabel{lines_.synthetic_seed()};
          }
        }
        tell(decision, {m.x, m.y}, is_first);
      } else {
        session_.take({m.x, m.y}, m.value);
      }
      log_.taken.push_back({{{m.x, m.y}, m.value}, m.plan});
    } catch (const std::invalid_argument& error) {
      if (is_first && m.plan && !robot_.is_connected()) {
        throw BadData(error.what());  // What follows was measured on a way from there.
      }
      skip(error.what());
    } catch (const std::domain_error& error) {
      skip(error.what());
    }
  }

  void tell(const terrain::Decision& decision, const terrain::Position& at, bool with_header) {
    if (log_.path.back() != at) {
      log_.path.push_back(at);
    }
    log_.path.insert(log_.path.end(), decision.way.begin(), decision.way.end());
    log_.rows.push_back({decision.row, decision.way, decision.end});
    end_ = decision.end;
    is_read_ = robot_.answer(text_of(log_.rows.back(), log_.label, with_header));
  }

  void skip(const std::string& problem) {
    ++bad_;
    const std::string text = fmt::format("line {}: {}; it is skipped", number_, problem);
    progress_.say(text);
    // Who waits for a row must not wait for ever.
    is_read_ = robot_.remark(text) && is_read_;
  }

  terrain::Session& session_;
  RobotLines& robot_;
  Progress& progress_;
  std::function<void(const terrain::ExploreSetup&)> settled_;
  MeasurementLines lines_;
  Log log_;
  std::optional<terrain::End> end_;
  bool is_read_ = true;
  std::size_t number_ = 0;
  std::size_t bad_ = 0;
};

/// In cells, with what the rules take unless it was given. \throws UsageError.
[[nodiscard]] ExploreRequest options_in_cells(const LiveTerrainRequest& request,
                                              TerrainGrid& layout,
                                              Progress& progress) {
  ExploreRequest o = request.explore;
  settle_beta(o, progress);
  o = in_cells(o, layout);
  o.output.path = request.record;  // Where rasters go.
  o.terrain = o.terrain.empty() ? "-" : o.terrain;
  check(o, progress);
  require_writable(raster_formats_of(o.rasters), layout);
  return o;
}

[[nodiscard]] terrain::ExploreSetup setup_of(const ExploreRequest& o,
                                             const TerrainGrid& layout,
                                             Progress& progress) {
  const terrain::Grid grid{layout.rows, layout.columns};
  const Places places = places_of(o, grid);
  terrain::CellSet blocked = blocked_cells(
      layout, o.obstacles, terrain_file_options("auto", o.format, o.nodata), progress);
  require_free(grid, layout, blocked, places.start, places.goals);
  terrain::ExploreSetup setup = unsettled_setup(o, grid, std::move(blocked));
  if (told_of(o).lipschitz) {
    setup.rules.lipschitz = lipschitz_of(o);
  }
  return setup;
}

}  // namespace

OptionTable options_of(LiveTerrainRequest& request) {
  OptionTable table(request.explore.given);
  table.argument({"LAYOUT", &request.explore.terrain, false, OptionRole::input});
  add_explore_options(table, request.explore);
  table.keep_own(is_for_a_robot);
  table.add("rows", request.rows, "N", "cells along x, without LAYOUT").within(0, 8192);
  table.add("columns", request.columns, "N", "cells along y").within(0, 8192);
  table.add_process("listen",
                    request.listen,
                    "WHERE",
                    "take measurements from the connection to unix:PATH, and answer there too");
  table.add_output("record",
                   request.record,
                   "DIR",
                   "series.csv, path.csv, measurements.csv and --rasters of the run");
  table.common();
  return table;
}

ExitCode live_terrain(const LiveTerrainRequest& request, Progress& progress) {
  if (request.explore.rules != "certified" && request.explore.rules != "band") {
    throw UsageError("--rules: found '" + request.explore.rules + "', expected certified or band");
  }
  if (motion_of(request.explore) == "jump") {
    throw UsageError("--motion jump: a robot goes its way; take pursuit, route or reactive");
  }
  TerrainGrid layout = layout_of(request, progress);
  const ExploreRequest o = options_in_cells(request, layout, progress);
  if (!request.record.empty()) {
    require_own_folder(request.record, "live terrain");
  }
  terrain::Session session(
      {layout.rows, layout.columns}, setup_of(o, layout, progress), told_of(o));
  RobotLines robot(request.listen, progress);
  Loop loop(session, robot, progress, label_of(layout), [&](const terrain::ExploreSetup& settled) {
    say_settled(settled, o, session.explorer()->planner().field_variance(), progress);
  });
  loop.run();
  if (!request.record.empty()) {
    write_record(request, loop.log(), session, layout);
  }
  if (!loop.end()) {
    progress.say("the measurements ended before the exploration did.");
  }
  if (loop.skipped_any()) {
    return exit_rejected;
  }
  return loop.end() ? exit_code_of(*loop.end()) : exit_done;
}

}  // namespace tcert::cli
