#pragma once
/// \file
/// One driven trial, control step by control step: whoever holds it decides what is commanded.

#include <cstdint>
#include <deque>
#include <optional>
#include <table/random.hpp>
#include <tcert/senses.hpp>

#include "datasets/driven/body.hpp"
#include "datasets/driven/camera.hpp"
#include "datasets/driven/driven_design.hpp"
#include "datasets/driven/driven_sensors.hpp"
#include "datasets/driven/referee.hpp"
#include "datasets/driven/truth_stream.hpp"
#include "datasets/resampler.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

/// ```
/// DrivenRun run(design);
/// while (const policies::Senses* senses = run.next()) {
///   run.take(policy(*senses));
/// }
/// ```
///
/// Time goes on in steps of step_s, cut where a command begins to act, which is the latency after
/// its control step, so that no latency is rounded. Control steps are the multiples of control_s
/// from when both streams have begun. Their tick is what resample() makes of the log so far: the
/// newest pose, the median of each ray's three newest samples, stale after a silence. The same
/// design and the same commands give the same run, bit for bit.
class DrivenRun {
 public:
  /// \throws std::invalid_argument as validate(design), or if the body does not fit at its start.
  explicit DrivenRun(DrivenDesign design);
  DrivenRun(const DrivenRun&) = delete;
  DrivenRun& operator=(const DrivenRun&) = delete;

  /// Drives on to the next control step; null when the trial has ended. Valid until the next call.
  [[nodiscard]] const policies::Senses* next();

  /// What the policy commands at this control step; a command that is not finite is one to stand.
  /// In G the robot stands whatever it is, see Referee. At most once after each next().
  void take(const policies::Command& command);

  [[nodiscard]] const DrivenDesign& design() const noexcept { return design_; }
  [[nodiscard]] double now_s() const noexcept { return 1e-9 * static_cast<double>(now_ns_); }
  /// The truth, which is nothing for a policy.
  [[nodiscard]] const Body& body() const noexcept { return body_; }
  [[nodiscard]] const Referee& referee() const noexcept { return referee_; }
  /// Every sample so far, at native rates.
  [[nodiscard]] const TrialLog& log() const noexcept { return log_; }
  /// Null unless the design asks for it.
  [[nodiscard]] const TruthRecorder* truth() const noexcept { return truth_ ? &*truth_ : nullptr; }

 private:
  struct Pending {
    std::int64_t from_ns = 0;
    policies::Command command;
  };

  void drive_until(std::int64_t until_ns);
  void step_to(std::int64_t to_ns);
  void sense();

  DrivenDesign design_;
  std::int64_t step_ns_;
  std::int64_t control_ns_;
  WallIndex walls_;
  Body body_;
  Referee referee_;
  DrivenSensors sensors_;
  std::optional<Camera> camera_;
  std::optional<TruthRecorder> truth_;
  table::RandomStream latency_random_;
  TrialLog log_;
  Resampler resampler_;
  std::int64_t now_ns_ = 0;
  std::int64_t next_control_ns_ = 0;
  policies::Command acting_;
  std::deque<Pending> pending_;
  policies::Senses senses_;
};

}  // namespace tcert
