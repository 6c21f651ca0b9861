#pragma once
/// \file
/// A bundle of one trial, written tick by tick while the trial runs.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <table/atomic_file.hpp>
#include <tcert/tick.hpp>

#include "datasets/bundle.hpp"
#include "datasets/tick_table.hpp"

namespace tcert {

/// Until it is closed the record lies in a hidden folder beside its name. That is a bundle too,
/// with every tick that was added: if the process dies it stays there and can be read. What a power
/// cut leaves of it is not known.
class BundleRecorder {
 public:
  /// bundle.json as `info` has it, without renamed columns; `trial_id` names the one trial.
  /// \throws WriteError if the name is taken or cannot be written.
  BundleRecorder(const std::filesystem::path& folder, BundleInfo info, std::string trial_id);

  /// Leaves the hidden folder where it is if it holds a tick and was not closed, else removes it.
  ~BundleRecorder();
  BundleRecorder(const BundleRecorder&) = delete;
  BundleRecorder& operator=(const BundleRecorder&) = delete;

  /// On its way to the disk when this returns; the first call settles whether the footing is kept.
  /// \pre time rises. \throws WriteError.
  void add(const Tick& tick,
           double speed_cmd_mps,
           double yaw_rate_cmd_rps,
           bool has_footing = false);

  /// Writes the trial's row and gives the folder its name. `row` says how the trial ended; its
  /// trial_id is that of the constructor. \throws WriteError.
  void close(TrialRow row);

  [[nodiscard]] std::size_t ticks() const noexcept { return ticks_; }
  [[nodiscard]] const std::filesystem::path& staging() const noexcept { return folder_.staging(); }

 private:
  void write(std::string_view bytes);

  BundleInfo info_;
  std::string trial_id_;
  table::AtomicFolder folder_;
  TickFormat format_;
  std::string row_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::size_t ticks_ = 0;
};

}  // namespace tcert
