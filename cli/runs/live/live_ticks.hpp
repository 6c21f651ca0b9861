#pragma once
/// \file
/// What becomes of the ticks of a live run.

#include <optional>
#include <string>
#include <tcert/runtime.hpp>

#include "analysis/study/trials/parameters.hpp"
#include "cli/runs/live/live.hpp"
#include "cli/runs/live/live_audit.hpp"
#include "cli/runs/live/live_record.hpp"
#include "cli/runs/live/live_witness.hpp"
#include "cli/runs/live/patient_output.hpp"
#include "datasets/bundle.hpp"
#include "datasets/tick_line.hpp"
#include "reports/series.hpp"

namespace tcert::cli {

/// Certifies each, judges it by the guards, records and audits it where that is asked for.
class LiveTicks {
 public:
  /// `when_late`: of a search for a witness.
  /// \throws UsageError, BadData, WriteError.
  LiveTicks(const LiveRequest& request,
            const BundleInfo& info,
            LiveWitness::WhenLate when_late,
            Progress& progress);

  LiveTicks(const LiveTicks&) = delete;  // the witness holds on to robot and parameters
  LiveTicks& operator=(const LiveTicks&) = delete;

  [[nodiscard]] const Robot& robot() const noexcept { return robot_; }
  /// The row above the first tick's.
  [[nodiscard]] std::string header() const { return series_header(format_, robot_); }

  /// The row of the next tick; valid until the one after it.
  [[nodiscard]] const std::string& row_of(const TickLine& line, StatusLines& status);

  /// At the end: finishes record and audit, and says what witnesses prove. False if either lacks
  /// rows.
  [[nodiscard]] bool close(StatusLines& status);

 private:
  study::ParameterSet parameters_;
  Robot robot_;
  SeriesFormat format_;
  Runtime runtime_;
  std::optional<LiveAudit> audit_;
  std::optional<LiveRecord> record_;
  std::optional<LiveWitness> witness_;
  std::string row_;
};

}  // namespace tcert::cli
