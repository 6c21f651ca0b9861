#include "datasets/corpus/write_bundle.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <mutex>
#include <string_view>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/csv_write.hpp>

#include "datasets/bundle_json.hpp"
#include "datasets/tick_columns.hpp"
#include "datasets/trial_table.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;

/// The folder is synced as a whole before it gets its name, so a file needs no sync of its own.
void write_file(const fs::path& path, std::string_view bytes) {
  struct Close {
    void operator()(std::FILE* file) const noexcept {
      std::fclose(file);  // after an error only: what it says could not be more than that error
    }
  };
  std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "wbx"));
  const bool written =
      file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  if (!written || std::fclose(file.release()) != 0) {
    throw table::WriteError(fmt::format(
        "cannot write '{}': {}", path.string(), std::generic_category().message(errno)));
  }
}

std::string control_csv(const ControlStream& stream, std::string_view first_line) {
  std::string text(first_line);
  text.reserve(text.size() + 32 * (stream.time_ns.size() + 2));
  text += "time_s,speed_cmd_mps,yaw_rate_cmd_rps,loop_latency_ms\n";
  for (std::size_t i = 0; i < stream.time_ns.size(); ++i) {
    table::append_seconds(text, stream.time_ns[i]);
    table::append_cell(text, stream.speed_cmd_mps[i]);
    table::append_cell(text, stream.yaw_rate_cmd_rps[i]);
    table::append_cell(text, stream.loop_latency_ms[i]);
    text += '\n';
  }
  return text;
}

std::string pose_csv(const PoseStream& stream, std::string_view first_line) {
  std::string text(first_line);
  text.reserve(text.size() + 32 * (stream.time_ns.size() + 2));
  text += "time_s,x_m,y_m,yaw_rad";
  text += stream.footing.empty() ? "\n" : ",pitch_rad,roll_rad,step_m,slip\n";
  for (std::size_t i = 0; i < stream.time_ns.size(); ++i) {
    const Pose& pose = stream.poses[i];
    table::append_seconds(text, stream.time_ns[i]);
    table::append_cell(text, pose.position.x_m);
    table::append_cell(text, pose.position.y_m);
    table::append_cell(text, pose.yaw_rad);
    if (!stream.footing.empty()) {
      const Footing& footing = stream.footing[i];
      for (const double value :
           {footing.pitch_rad, footing.roll_rad, footing.step_m, footing.slip}) {
        table::append_cell(text, value);
      }
    }
    text += '\n';
  }
  return text;
}

/// True if a joint moves the ray.
bool moves(const TactileStream& stream, std::size_t ray) {
  for (std::size_t i = ray; i < stream.readings.size(); i += stream.rays) {
    if (!std::isnan(stream.readings[i].bearing_rad)) {
      return true;
    }
  }
  return false;
}

std::string tactile_csv(const TactileStream& stream,
                        const std::vector<Ray>& rays,
                        std::string_view first_line) {
  std::string text(first_line);
  text.reserve(text.size() + 16 * (1 + rays.size()) * (stream.time_ns.size() + 2));
  text += "time_s";
  std::vector<bool> has_joint;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    has_joint.push_back(moves(stream, k));
    text += fmt::format(",{0}_bend_rad,{0}_fsr_n", rays[k].name);
    text += has_joint[k] ? ',' + bearing_column(rays[k]) : "";
  }
  text += '\n';
  for (std::size_t i = 0; i < stream.time_ns.size(); ++i) {
    table::append_seconds(text, stream.time_ns[i]);
    for (std::size_t k = 0; k < stream.rays; ++k) {
      const RayReading& reading = stream.readings[i * stream.rays + k];
      table::append_cell(text, reading.value);
      table::append_cell(text, reading.fsr_n);
      if (has_joint[k]) {
        table::append_cell(text, reading.bearing_rad);
      }
    }
    text += '\n';
  }
  return text;
}

void write_trial(const fs::path& folder,
                 const SimulatedTrial& trial,
                 const std::vector<Ray>& rays,
                 std::string_view first_line) {
  const std::string& id = trial.row.trial_id;
  const fs::path logs = folder / "logs" / id;
  fs::create_directory(logs);
  write_file(logs / "control.csv", control_csv(trial.log.control, first_line));
  write_file(logs / "pose.csv", pose_csv(trial.log.pose, first_line));
  write_file(logs / "tactile.csv", tactile_csv(trial.log.tactile, rays, first_line));
  for (const auto& [name, text] : trial.more_logs) {
    write_file(logs / name, std::string(first_line) + text);
  }
  if (trial.owns_world) {
    write_file(folder / "worlds" / (trial.world.name + ".json"), to_json(trial.world));
  }
}

}  // namespace

void write_simulated_bundle(const fs::path& folder,
                            const SimulatedBundle& bundle,
                            const TrialProgress& progress,
                            bool replace) {
  table::AtomicFolder output(folder, replace);
  const fs::path& staging = output.staging();
  fs::create_directory(staging / "logs");
  fs::create_directory(staging / "worlds");
  const std::string first_line =
      fmt::format("# synthetic, seed {}\n", bundle.info.seed.value_or(0));

  std::vector<TrialRow> rows(bundle.trials);
  std::mutex counting;
  std::uint64_t done = 0;
  tbb::parallel_for(std::uint64_t{0}, bundle.trials, [&](std::uint64_t i) {
    SimulatedTrial trial = bundle.simulate(i);
    write_trial(staging, trial, bundle.info.robot.rays, first_line);
    rows[i] = std::move(trial.row);
    if (progress) {
      const std::lock_guard lock(counting);
      progress(++done, bundle.trials);
    }
  });
  write_file(staging / "bundle.json", to_bundle_json(bundle.info));
  write_file(staging / "trials.csv", first_line + to_trials_csv(rows, bundle.extra_columns));
  output.commit();
}

}  // namespace tcert
