#pragma once
/// \file
/// The record of a live run.

#include <cstdint>
#include <optional>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/robot.hpp>

#include "analysis/study/trials/parameters.hpp"
#include "cli/runs/live/patient_output.hpp"
#include "datasets/bundle_recorder.hpp"
#include "datasets/tick_line.hpp"

namespace tcert::cli {

/// bundle.json of a record: with everything in it that certifying the ticks again needs.
[[nodiscard]] BundleInfo info_of_record(BundleInfo info,
                                        const Robot& robot,
                                        study::ParameterSet parameters);

/// A record that may fail without ending the run: what went wrong is said.
class LiveRecord {
 public:
  /// \throws WriteError if the folder cannot be made.
  LiveRecord(const std::string& folder, BundleInfo info);

  void add(const TickLine& line, const CertifiedTick& certified, StatusLines& status);

  /// False if it could not be written. Whether a run that did not reach G failed is for people to
  /// say: its success is left open.
  [[nodiscard]] bool close(StatusLines& status);

 private:
  void give_up(const table::WriteError& error, StatusLines& status);

  std::string folder_;
  std::optional<BundleRecorder> recorder_;
  std::optional<std::int64_t> first_ns_;
  std::optional<std::int64_t> goal_ns_;
  std::size_t lost_ = 0;  ///< Ticks since recording ended.
  std::int64_t last_ns_ = 0;
};

}  // namespace tcert::cli
