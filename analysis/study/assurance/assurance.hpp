#pragma once
/// \file
/// What rules are worth over all trials: detection, always beside false alarms, delay and progress.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <string>
#include <vector>

#include "analysis/study/assurance/assured_trial.hpp"
#include "analysis/study/verdict.hpp"

namespace tcert::study {

struct AssuranceOptions {
  double level = 0.95;
  double claim = 0.9;  ///< Share of unsafe episodes that the paper says are detected.
  std::size_t replicates = 2000;
  std::uint64_t seed = 1;
};

struct ShareEstimate {
  std::size_t found = 0;
  std::size_t of = 0;
  std::optional<double> value;
  std::optional<statistics::Interval> interval;  ///< Days resampled; none with fewer than ten.
};

/// One rule, or all together.
struct MonitorScore {
  std::string monitor;
  ShareEstimate episodes;        ///< Unsafe episodes that were detected.
  ShareEstimate ahead;           ///< Those with a wall within the stopping way.
  ShareEstimate force;           ///< Those with too large a force.
  std::size_t trials = 0;        ///< With an unsafe episode.
  std::size_t trials_whole = 0;  ///< Of them those of which every episode is detected.
  std::optional<statistics::Interval> trials_interval;  ///< Of their share, Clopper and Pearson's.
  std::optional<double> false_share;     ///< Of all time: under an alarm that is false.
  std::optional<double> false_per_hour;  ///< NA without any truth.
  std::optional<double> alarms_per_hour;
  std::optional<double> median_delay_s;  ///< Of the episodes detected.
  ShareEstimate progress;  ///< Share of the forward way driven under an alarm; value alone.
  Verdict claim = Verdict::not_decided;  ///< By the interval of `episodes`.
};

/// Faults of one kind, as all rules together, or one, see them.
struct FaultScore {
  std::string kind;
  std::string monitor;
  ShareEstimate faults;
  ShareEstimate
      controls;  ///< Times as long, without a fault, that an alarm meets: what chance does.
  std::optional<double> median_delay_s;
};

/// Looks ahead whose stated chance of a collision lies in [from, to).
struct RiskBin {
  double from = 0.0;
  double to = 0.0;
  double mean_stated = 0.0;
  ShareEstimate met;  ///< Those at which the body would have met a wall on that way.
};

struct Assurance {
  AssuranceOptions options;
  std::size_t trials = 0;
  std::size_t without_truth = 0;
  std::size_t clusters = 0;
  double hours = 0.0;
  std::vector<MonitorScore> monitors;  ///< One a rule, then "any".
  std::vector<RiskBin> risk;           ///< Those with a look; none without a risk field.
  std::vector<FaultScore> faults;      ///< By kind: "any", then the rules that saw one.
};

/// \pre all trials have a record a rule and one for all.
[[nodiscard]] Assurance assurance_of(const std::vector<AssuredTrial>& trials,
                                     const std::vector<std::string>& rules,
                                     const AssuranceOptions& options);

}  // namespace tcert::study
