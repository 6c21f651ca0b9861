#include "analysis/study/assurance/assurance.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/quantile.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <table/not_a_number.hpp>

namespace tcert::study {
namespace {

constexpr std::uint32_t kAssuranceStream = 0x4153;  // of this analysis' draws
constexpr std::size_t kFewestClusters = 10;
constexpr int kRiskBins = 10;

/// Counts of each trial, in their order.
struct Counts {
  std::vector<double> found;
  std::vector<double> of;
};

std::vector<std::uint32_t> codes_of(const std::vector<AssuredTrial>& trials) {
  std::map<std::string, std::uint32_t> codes;
  std::vector<std::uint32_t> of_trials;
  for (const AssuredTrial& trial : trials) {
    const auto next = static_cast<std::uint32_t>(codes.size());
    of_trials.push_back(codes.emplace(trial.cluster, next).first->second);
  }
  return of_trials;
}

/// Sum over sum, trials of a day drawn together.
ShareEstimate share_of(const Counts& counts,
                       const std::vector<std::uint32_t>& clusters,
                       const AssuranceOptions& options) {
  ShareEstimate share;
  double found = 0.0;
  double of = 0.0;
  for (std::size_t i = 0; i < counts.of.size(); ++i) {
    found += counts.found[i];
    of += counts.of[i];
  }
  share.found = static_cast<std::size_t>(found);
  share.of = static_cast<std::size_t>(of);
  if (!(of > 0.0)) {
    return share;
  }
  share.value = found / of;
  std::set<std::uint32_t> with_one;
  for (std::size_t i = 0; i < counts.of.size(); ++i) {
    if (counts.of[i] > 0.0) {
      with_one.insert(clusters[i]);
    }
  }
  const std::size_t days = with_one.size();
  if (days < kFewestClusters) {
    return share;
  }
  const auto shared = std::make_shared<const Counts>(counts);
  const statistics::Statistic statistic =
      statistics::scalar_statistic(counts.of.size(), [shared]() {
        return [shared](std::span<const std::uint32_t> multiplicity) {
          double sum = 0.0;
          double all = 0.0;
          for (std::size_t i = 0; i < multiplicity.size(); ++i) {
            sum += multiplicity[i] * shared->found[i];
            all += multiplicity[i] * shared->of[i];
          }
          return all > 0.0 ? sum / all : table::kNaN;
        };
      });
  const auto resampled =
      statistics::bootstrap(statistic,
                            statistics::ResamplingPlan::of_clusters(clusters),
                            {options.replicates, options.seed, kAssuranceStream, {}});
  share.interval = statistics::bootstrap_intervals(resampled, 0, options.level).expanded;
  if (found == 0.0 || found == of) {
    // No resample differs: the exact bound over days is what is left, as if each were one try.
    share.interval = statistics::clopper_pearson(found == 0.0 ? 0 : days, days, options.level);
  }
  if (share.interval) {
    share.interval->low = std::max(share.interval->low, 0.0);
    share.interval->high = std::min(share.interval->high, 1.0);
  }
  return share;
}

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) {
    return std::nullopt;
  }
  std::ranges::sort(values);
  return statistics::quantile(values, 0.5);
}

/// Episodes of a monitor that `counts` says yes to.
template <class Counted>
ShareEstimate episodes_of(const std::vector<AssuredTrial>& trials,
                          std::size_t monitor,
                          const std::vector<std::uint32_t>& clusters,
                          const AssuranceOptions& options,
                          Counted counted) {
  Counts counts;
  for (const AssuredTrial& trial : trials) {
    double found = 0.0;
    double of = 0.0;
    for (std::size_t i = 0; i < trial.episodes.size(); ++i) {
      if (counted(trial.episodes[i])) {
        of += 1.0;
        found += trial.monitors[monitor].episodes[i].detected ? 1.0 : 0.0;
      }
    }
    counts.found.push_back(found);
    counts.of.push_back(of);
  }
  return share_of(counts, clusters, options);
}

MonitorScore score_of(const std::vector<AssuredTrial>& trials,
                      std::size_t monitor,
                      const std::vector<std::uint32_t>& clusters,
                      const AssuranceOptions& options) {
  MonitorScore score;
  score.episodes =
      episodes_of(trials, monitor, clusters, options, [](const UnsafeEpisode&) { return true; });
  score.ahead = episodes_of(
      trials, monitor, clusters, options, [](const UnsafeEpisode& e) { return e.ahead; });
  score.force = episodes_of(
      trials, monitor, clusters, options, [](const UnsafeEpisode& e) { return e.force; });
  double hours = 0.0;
  double true_hours = 0.0;
  double false_alarms = 0.0;
  double false_s = 0.0;
  double alarms = 0.0;
  double way_m = 0.0;
  double alarmed_m = 0.0;
  std::vector<double> delays;
  for (const AssuredTrial& trial : trials) {
    const MonitorRecord& record = trial.monitors[monitor];
    hours += trial.hours;
    true_hours += trial.has_truth ? trial.hours : 0.0;
    false_alarms += static_cast<double>(record.false_alarms);
    false_s += record.false_s;
    alarms += static_cast<double>(record.alarms.size());
    way_m += trial.forward_m;
    alarmed_m += record.alarmed_m;
    const bool whole = std::ranges::all_of(record.episodes, &Detection::detected);
    score.trials += trial.episodes.empty() ? 0 : 1;
    score.trials_whole += !trial.episodes.empty() && whole ? 1 : 0;
    for (const Detection& episode : record.episodes) {
      if (episode.detected) {
        delays.push_back(episode.delay_s);
      }
    }
  }
  score.trials_interval =
      statistics::clopper_pearson(score.trials_whole, score.trials, options.level);
  score.false_share =
      true_hours > 0.0 ? std::optional(false_s / (3600.0 * true_hours)) : std::nullopt;
  score.false_per_hour = true_hours > 0.0 ? std::optional(false_alarms / true_hours) : std::nullopt;
  score.alarms_per_hour = hours > 0.0 ? std::optional(alarms / hours) : std::nullopt;
  score.median_delay_s = median_of(std::move(delays));
  score.progress.value = way_m > 0.0 ? std::optional(alarmed_m / way_m) : std::nullopt;
  if (const auto& interval = score.episodes.interval) {
    score.claim = interval->low > options.claim    ? Verdict::supported
                  : interval->high < options.claim ? Verdict::contradicted
                                                   : Verdict::not_decided;
  }
  return score;
}

FaultScore fault_score(const std::vector<AssuredTrial>& trials,
                       std::size_t monitor,
                       const std::string& kind,
                       const std::vector<std::uint32_t>& clusters,
                       const AssuranceOptions& options) {
  FaultScore score;
  score.kind = kind;
  Counts counts;
  Counts controls;
  std::vector<double> delays;
  for (const AssuredTrial& trial : trials) {
    double found = 0.0;
    double of = 0.0;
    double alarmed = 0.0;
    double compared = 0.0;
    for (std::size_t i = 0; i < trial.faults.size(); ++i) {
      if (trial.faults[i].kind == kind) {
        const Control control = trial.monitors[monitor].controls[i];
        compared += control == Control::none ? 0.0 : 1.0;
        alarmed += control == Control::alarmed ? 1.0 : 0.0;
        const Detection& detection = trial.monitors[monitor].faults[i];
        of += 1.0;
        found += detection.detected ? 1.0 : 0.0;
        if (detection.detected) {
          delays.push_back(detection.delay_s);
        }
      }
    }
    counts.found.push_back(found);
    counts.of.push_back(of);
    controls.found.push_back(alarmed);
    controls.of.push_back(compared);
  }
  score.faults = share_of(counts, clusters, options);
  score.controls = share_of(controls, clusters, options);
  score.median_delay_s = median_of(std::move(delays));
  return score;
}

/// Ten bins of the chance that was stated, each with how often a wall was really met.
std::vector<RiskBin> risk_bins(const std::vector<AssuredTrial>& trials,
                               const std::vector<std::uint32_t>& clusters,
                               const AssuranceOptions& options) {
  std::vector<RiskBin> bins;
  for (int k = 0; k < kRiskBins; ++k) {
    RiskBin bin;
    bin.from = static_cast<double>(k) / kRiskBins;
    bin.to = static_cast<double>(k + 1) / kRiskBins;
    Counts counts;
    double stated = 0.0;
    for (const AssuredTrial& trial : trials) {
      double met = 0.0;
      double of = 0.0;
      for (const RiskLook& look : trial.risk) {
        if (std::min(static_cast<int>(look.stated * kRiskBins), kRiskBins - 1) == k) {
          of += 1.0;
          met += look.met ? 1.0 : 0.0;
          stated += look.stated;
        }
      }
      counts.found.push_back(met);
      counts.of.push_back(of);
    }
    bin.met = share_of(counts, clusters, options);
    if (bin.met.of > 0) {
      bin.mean_stated = stated / static_cast<double>(bin.met.of);
      bins.push_back(bin);
    }
  }
  return bins;
}

}  // namespace

Assurance assurance_of(const std::vector<AssuredTrial>& trials,
                       const std::vector<std::string>& rules,
                       const AssuranceOptions& options) {
  Assurance assurance;
  assurance.options = options;
  assurance.trials = trials.size();
  std::set<std::string> kinds;
  for (const AssuredTrial& trial : trials) {
    assurance.without_truth += trial.has_truth ? 0 : 1;
    assurance.hours += trial.hours;
    for (const InjectedFault& fault : trial.faults) {
      kinds.insert(fault.kind);
    }
  }
  const std::vector<std::uint32_t> clusters = codes_of(trials);
  assurance.clusters = std::set(clusters.begin(), clusters.end()).size();
  for (std::size_t r = 0; r <= rules.size(); ++r) {
    assurance.monitors.push_back(score_of(trials, r, clusters, options));
    assurance.monitors.back().monitor = r < rules.size() ? rules[r] : "any";
  }
  assurance.risk = risk_bins(trials, clusters, options);
  for (const std::string& kind : kinds) {
    for (std::size_t k = 0; k <= rules.size(); ++k) {
      const std::size_t r = k == 0 ? rules.size() : k - 1;
      FaultScore score = fault_score(trials, r, kind, clusters, options);
      score.monitor = assurance.monitors[r].monitor;
      if (k == 0 || score.faults.found > 0) {
        assurance.faults.push_back(std::move(score));
      }
    }
  }
  return assurance;
}

}  // namespace tcert::study
