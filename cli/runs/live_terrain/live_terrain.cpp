#include "cli/runs/live_terrain/live_terrain.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <stdexcept>
#include <terrain/limits.hpp>
#include <terrain/session.hpp>

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
  for (const char* const other : {"config",
                                  "header",
                                  "mode",
                                  "expanders",
                                  "noise-variance",
                                  "kernel-mean",
                                  "baseline",
                                  "frames",
                                  "seed",
                                  "output"}) {
    if (name == other) {
      return false;
    }
  }
  return true;
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
};

/// The row as CSV; the header with the first.
[[nodiscard]] std::string text_of(const LiveRow& row, bool with_header) {
  const std::string text = render(live_table({row}), TableFormat::csv);
  return with_header ? text : text.substr(text.find('\n') + 1);
}

void write_record(const LiveTerrainRequest& request,
                  const Log& log,
                  const terrain::Session& session,
                  const TerrainGrid& layout) {
  ResultFolder folder(request.record, "live terrain");
  folder.write("series.csv", render(live_table(log.rows), TableFormat::csv));
  terrain::ExploreResult path;
  path.path = log.path;
  folder.write("path.csv", render(path_table(path, std::nullopt), TableFormat::csv));
  folder.write("measurements.csv",
               render(measurement_table(log.taken, std::nullopt), TableFormat::csv));
  const RasterFormats rasters = raster_formats_of(request.explore.rasters);
  if (rasters.any() && session.explorer() != nullptr) {
    write_rasters(folder, rasters, layout, session.explorer()->layers());
  }
  Manifest manifest;
  manifest.command = "live terrain";
  record(written(request), manifest);
  for (const std::string& file :
       {request.explore.terrain, request.explore.obstacles, request.explore.known}) {
    if (!file.empty()) {
      manifest.inputs.push_back({name_of(file), digest_file(file)});
    }
  }
  folder.commit(std::move(manifest));
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
  ExploreRequest o = request.explore;
  if (o.rules != "certified" && o.rules != "band") {
    throw UsageError("--rules: found '" + o.rules + "', expected certified or band");
  }
  if (o.rules == "band" && !is_given(o.given, "beta")) {
    o.beta = terrain::kTrustedBeta;
  }
  TerrainGrid layout = layout_of(request, progress);
  o = in_cells(o, layout);
  o.output.path = request.record;  // Where rasters go.
  o.terrain = o.terrain.empty() ? "-" : o.terrain;
  check(o, progress);
  const terrain::Grid grid{layout.rows, layout.columns};
  const Places places = places_of(o, grid);
  terrain::CellSet blocked = blocked_cells(
      layout, o.obstacles, terrain_file_options("auto", o.format, o.nodata), progress);
  require_free(grid, layout, blocked, places.start, places.goals);
  if (!request.record.empty()) {
    require_own_folder(request.record, "live terrain");
  }
  const terrain::Told told = told_of(o);
  terrain::ExploreSetup setup = unsettled_setup(o, grid, std::move(blocked));
  settle_noise(setup, o, progress);
  if (told.lipschitz) {
    setup.rules.lipschitz = lipschitz_of(o);
  } else {
    setup.confidence = o.confidence;
  }
  terrain::Session session(grid, setup, told);
  Log log;
  for (const terrain::Measurement& m : setup.known) {
    log.taken.push_back({m, false});
  }
  log.path.push_back(terrain::position(setup.start));
  RobotLines robot(request.listen, progress);
  std::size_t bad = 0;
  std::size_t number = 0;
  std::optional<terrain::End> end;
  while (!end) {
    const std::optional<std::string> line = robot.next();
    if (!line) {
      break;
    }
    ++number;
    const MeasurementReading reading = read_measurement(*line);
    std::string problem = reading.problem;
    if (reading.measurement) {
      const MeasurementLine& m = *reading.measurement;
      const terrain::Position at(m.x, m.y);
      try {
        if (!m.plan) {
          session.take({m.x, m.y}, m.value);
          log.taken.push_back({{at, m.value}, false});
          continue;
        }
        const bool is_first = session.explorer() == nullptr;
        const terrain::Decision& decision = session.plan({m.x, m.y}, m.value);
        log.taken.push_back({{at, m.value}, true});
        if (log.path.back() != at) {
          log.path.push_back(at);
        }
        log.path.insert(log.path.end(), decision.way.begin(), decision.way.end());
        log.rows.push_back({decision.row, decision.way, decision.end});
        end = decision.end;
        if (!robot.answer(text_of(log.rows.back(), is_first))) {
          break;
        }
        continue;
      } catch (const std::invalid_argument& error) {
        if (session.explorer() == nullptr && m.plan) {
          throw BadData(error.what());
        }
        problem = error.what();
      } catch (const std::domain_error& error) {
        problem = error.what();
      }
    }
    if (!problem.empty()) {
      ++bad;
      progress.say(fmt::format("line {}: {}; it is skipped", number, problem));
    }
  }
  if (!request.record.empty()) {
    write_record(request, log, session, layout);
  }
  if (!end) {
    progress.say("the measurements ended before the exploration did.");
  }
  return bad > 0 || robot.too_long() > 0 ? exit_rejected : end ? exit_code_of(*end) : exit_done;
}

}  // namespace tcert::cli
