#include "datasets/bundle_recorder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "datasets/bundle_json.hpp"
#include "datasets/trial_table.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path) {
  throw table::WriteError(
      fmt::format("cannot write '{}': {}", path.string(), std::generic_category().message(errno)));
}

/// As every CSV of data that was made by a program begins.
std::string first_line(const BundleInfo& info) {
  return info.synthetic ? fmt::format("# synthetic, seed {}\n", info.seed.value_or(0)) : "";
}

}  // namespace

BundleRecorder::BundleRecorder(const fs::path& folder, BundleInfo info, std::string trial_id)
    : info_(std::move(info)),
      trial_id_(std::move(trial_id)),
      folder_(folder, false, table::Leftover::kept),
      format_(info_.robot),
      file_(nullptr, std::fclose) {
  info_.columns.clear();
  info_.range_keys.clear();  // what a reading means is settled when it comes
  TrialRow open;
  open.trial_id = trial_id_;
  table::write_file_atomically(folder_.staging() / "bundle.json", to_bundle_json(info_));
  table::write_file_atomically(folder_.staging() / "trials.csv",
                               first_line(info_) + to_trials_csv({open}, {}));
  const fs::path path = folder_.staging() / "logs" / trial_id_ / "ticks.csv";
  fs::create_directories(path.parent_path());
  file_.reset(std::fopen(path.c_str(), "wbxe"));
  if (!file_) {
    fail(path);
  }
  write(first_line(info_));
}

BundleRecorder::~BundleRecorder() {
  if (ticks_ > 0) {
    folder_.abandon();
  }
}

void BundleRecorder::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
      std::fflush(file_.get()) != 0) {
    fail(folder_.staging());
  }
}

void BundleRecorder::add(const Tick& tick,
                         double speed_cmd_mps,
                         double yaw_rate_cmd_rps,
                         bool has_footing) {
  row_.clear();
  if (ticks_ == 0) {
    format_ = TickFormat(info_.robot, {}, has_footing);
    row_ = format_.header();
  }
  format_.append_row(row_, tick, speed_cmd_mps, yaw_rate_cmd_rps);
  write(row_);
  ++ticks_;
}

void BundleRecorder::close(TrialRow row) {
  row.trial_id = trial_id_;
  if (std::fclose(file_.release()) != 0) {
    fail(folder_.staging());
  }
  table::write_file_atomically(folder_.staging() / "trials.csv",
                               first_line(info_) + to_trials_csv({std::move(row)}, {}));
  folder_.commit();
  ticks_ = 0;
}

}  // namespace tcert
