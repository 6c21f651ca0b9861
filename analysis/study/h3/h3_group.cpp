#include "analysis/study/h3/h3_group.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/few_clusters.hpp>
#include <statistics/basics/quantile.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <table/not_a_number.hpp>
#include <tuple>
#include <utility>

#include "analysis/study/h1/withhold.hpp"
#include "analysis/study/h3/cluster_loss.hpp"
#include "analysis/study/h3/pareto.hpp"
#include "analysis/study/h3/rates_of_advance.hpp"

namespace tcert::study {
namespace {

constexpr std::uint32_t kH3Stream = 0x48330000;

/// What is computed of one lighting.
class Group {
 public:
  Group(const ReplayRows& rows,
        const std::vector<H3Trial>& trials,
        const std::set<CaseKey>& cases,
        const H3Options& options,
        const Watch& watch)
      : rows_(rows),
        trials_(trials),
        cases_(cases.begin(), cases.end()),
        options_(options),
        watch_(watch) {}

  H3Group result(std::string lighting) {
    group_.lighting = std::move(lighting);
    count();
    advance();
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      group_.cases.push_back(case_of(c));
    }
    mark_front();
    return std::move(group_);
  }

 private:
  [[nodiscard]] std::optional<double> median_of(bool baseline,
                                                const std::vector<double>& column,
                                                const CaseKey* key = nullptr) const {
    std::vector<double> values;
    for (const H3Trial& trial : trials_) {
      const double value = column[key == nullptr ? trial.any_row() : trial.row.at(*key)];
      if (trial.baseline == baseline && !std::isnan(value)) {
        values.push_back(value);
      }
    }
    return statistics::median(values);
  }

  void count() {
    for (const H3Trial& trial : trials_) {
      (trial.baseline ? group_.baseline_trials : group_.trials) += 1;
      (trial.baseline ? group_.baseline_successes : group_.successes) += trial.success ? 1 : 0;
    }
    group_.speed_cmd_mps = median_of(false, rows_.speed);
    group_.baseline_speed_cmd_mps = median_of(true, rows_.speed);
    group_.latency_ms = median_of(false, rows_.latency);
  }

  void advance() {
    auto data = std::make_shared<Advance>();
    data->gated_time.resize(cases_.size());
    std::map<std::string, std::uint32_t> codes;
    std::set<std::string> of_gated;
    std::set<std::string> of_baseline;
    std::map<std::string, std::size_t> lightings;
    std::vector<std::uint32_t> cluster;
    for (const H3Trial& trial : trials_) {
      const std::size_t row = trial.any_row();
      if (!trial.success || std::isnan(rows_.length[row]) || std::isnan(rows_.time[row])) {
        continue;
      }
      data->baseline.push_back(trial.baseline ? 1 : 0);
      data->lighting.push_back(
          lightings.emplace(rows_.lighting[row], lightings.size()).first->second);
      data->length.push_back(rows_.length[row]);
      data->time.push_back(rows_.time[row]);
      for (std::size_t c = 0; c < cases_.size(); ++c) {
        data->gated_time[c].push_back(rows_.gated_time[trial.row.at(cases_[c])]);
      }
      const auto code = static_cast<std::uint32_t>(codes.size());
      cluster.push_back(codes.emplace(rows_.cluster[row], code).first->second);
      (trial.baseline ? of_baseline : of_gated).insert(rows_.cluster[row]);
    }
    data->lightings = lightings.size();
    group_.clusters = codes.size();
    gated_clusters_ = of_gated.size();
    baseline_clusters_ = of_baseline.size();
    if (cluster.empty()) {
      group_.conditions.push_back({statistics::ConditionKind::no_rows,
                                   statistics::ConditionSeverity::warning,
                                   "success",
                                   "no trial succeeds"});
      return;
    }
    look_for_few();
    if (group_.withheld.empty()) {
      if (auto few = statistics::few_clusters(group_.clusters)) {
        group_.conditions.push_back(std::move(*few));
      }
    }
    statistics::Statistic statistic;
    statistic.rows = cluster.size();
    statistic.values = group_values + case_values * cases_.size();
    statistic.make_kernel = [data]() -> statistics::StatisticKernel {
      return [data](std::span<const std::uint32_t> multiplicity, std::span<double> values) {
        rates(*data, multiplicity, values);
      };
    };
    watch_.begin("lighting " + group_.lighting + ", resamples", options_.replicates);
    bootstrap_ =
        statistics::bootstrap(statistic,
                              statistics::ResamplingPlan::of_clusters(cluster),
                              {options_.replicates, options_.seed, kH3Stream, watch_.on_advance});
    group_.ungated = estimate(value_ungated);
    group_.baseline = estimate(value_baseline);
    group_.baseline_standardised = estimate(value_standardised);
    group_.gap = estimate(value_gap);
    group_.gap_as_run = estimate(value_gap_as_run);
  }

  /// Rates of an algorithm with so few successes have no intervals; with so few clusters nothing
  /// has.
  void look_for_few() {
    const std::size_t enough = kTooFewOutcomes;
    group_.withheld = too_few(options_.cluster, group_.clusters, enough, enough, kTooFewUntried);
    if (!group_.withheld.empty()) {
      few_gated_ = few_baseline_ = true;
      group_.conditions.push_back(withheld(group_.withheld));
      return;
    }
    few_gated_ = is_few(options_.gated, group_.trials, group_.successes);
    few_baseline_ = is_few(options_.baseline, group_.baseline_trials, group_.baseline_successes);
  }

  /// Says so, of an algorithm that has trials.
  bool is_few(const std::string& algorithm, std::size_t trials, std::size_t successes) {
    const bool few = successes < kTooFewOutcomes;
    if (few && trials > 0) {
      group_.conditions.push_back(withheld(std::to_string(successes) + " successes of '" +
                                           algorithm + "', fewer than " +
                                           std::to_string(kTooFewOutcomes)));
    }
    return few;
  }

  /// Which algorithms' trials a value is made of.
  struct Makers {
    bool gated = true;
    bool baseline = true;
  };

  [[nodiscard]] static Makers makers_of(std::size_t value) {
    if (value == value_baseline) {
      return {false, true};
    }
    const bool both =
        value == value_standardised || value == value_gap || value == value_gap_as_run ||
        (value >= group_values && (value - group_values) % case_values == value_recovered);
    return {true, both};
  }

  [[nodiscard]] bool is_withheld(std::size_t value) const {
    const Makers makers = makers_of(value);
    return (makers.gated && few_gated_) || (makers.baseline && few_baseline_);
  }

  /// The clusters that a value is made of; of two algorithms, those of the one that has fewer, as
  /// its rate is the less certain one.
  [[nodiscard]] std::size_t units_of(std::size_t value) const {
    const Makers makers = makers_of(value);
    if (makers.gated && makers.baseline) {
      return std::min(gated_clusters_, baseline_clusters_);
    }
    return makers.gated ? gated_clusters_ : baseline_clusters_;
  }

  [[nodiscard]] H3Estimate estimate(std::size_t value) {
    H3Estimate out;
    if (bootstrap_.observed.empty() || std::isnan(bootstrap_.observed[value])) {
      return out;
    }
    const statistics::BootstrapEstimate found = statistics::bootstrap_estimate(
        bootstrap_, value, options_.level, options_.interval, units_of(value));
    out.value = found.observed;
    if (is_withheld(value)) {
      return out;
    }
    out.interval = found.interval;
    out.intervals =
        statistics::bootstrap_intervals(bootstrap_, value, options_.level, units_of(value));
    for (const statistics::Condition& condition : found.conditions) {
      if (!statistics::has(group_.conditions, condition.kind)) {
        group_.conditions.push_back(condition);
      }
    }
    return out;
  }

  H3Case case_of(std::size_t c) {
    H3Case out;
    std::tie(out.law, out.beta_per_m) = cases_[c];
    const std::size_t first = group_values + c * case_values;
    out.gated = estimate(first + value_gated);
    out.gain = estimate(first + value_gain);
    out.gain_share = estimate(first + value_gain_share);
    const auto& gap = group_.gap.interval;
    if (gap && (gap->low > 0.0 || gap->high < 0.0)) {
      out.recovered = estimate(first + value_recovered);
    }
    out.speed_cmd_mps = median_of(false, rows_.gated_speed, &cases_[c]);
    std::vector<std::uint8_t> lost;
    std::vector<std::uint8_t> failed;
    std::vector<std::uint32_t> cluster;
    std::map<std::string, std::uint32_t> codes;
    for (const H3Trial& trial : trials_) {
      const std::size_t row = trial.row.at(cases_[c]);
      if (!trial.baseline) {
        lost.push_back(trial.success && rows_.kept[row] != 1.0 ? 1 : 0);
        failed.push_back(trial.success ? 0 : 1);
        const auto code = static_cast<std::uint32_t>(codes.size());
        cluster.push_back(codes.emplace(rows_.cluster[row], code).first->second);
        out.kept += trial.success && rows_.kept[row] == 1.0 ? 1 : 0;
        out.stalls += static_cast<std::size_t>(rows_.stalls[row]);
        out.stalled_trials += rows_.stalls[row] > 0.0 ? 1 : 0;
      }
    }
    out.lost = group_.successes - out.kept;
    if (group_.trials > 0) {
      out.lost_share = static_cast<double>(out.lost) / static_cast<double>(group_.trials);
    }
    if (group_.trials > 0 && group_.withheld.empty()) {
      const ClusterLoss loss =
          cluster_loss(lost, failed, cluster, options_.level, options_.loss_margin);
      out.design_effect = loss.design_effect;
      out.lost_lower = loss.lower;
      out.lost_upper = loss.upper;
      out.non_inferior = *loss.upper < options_.loss_margin;
    }
    if (group_.successes > 0) {
      out.retained = static_cast<double>(out.kept) / static_cast<double>(group_.successes);
      if (group_.withheld.empty()) {
        out.retained_interval =
            statistics::effective_wilson(static_cast<double>(out.kept) / out.design_effect,
                                         static_cast<double>(group_.successes) / out.design_effect,
                                         options_.level);
      }
    }
    return out;
  }

  void mark_front() {
    std::vector<GainAndRetention> points;
    for (const H3Case& one : group_.cases) {
      points.push_back(
          {one.gain_share.value.value_or(table::kNaN), one.retained.value_or(table::kNaN)});
    }
    const std::vector<bool> front = pareto_front(points);
    for (std::size_t c = 0; c < front.size(); ++c) {
      group_.cases[c].on_front = front[c];
    }
  }

  const ReplayRows& rows_;
  const std::vector<H3Trial>& trials_;
  std::vector<CaseKey> cases_;
  const H3Options& options_;
  const Watch& watch_;
  std::size_t gated_clusters_ = 0;     ///< Among the successes of the gated algorithm.
  std::size_t baseline_clusters_ = 0;  ///< Among those of the other.
  bool few_gated_ = false;
  bool few_baseline_ = false;
  H3Group group_;
  statistics::BootstrapResult bootstrap_;
};

}  // namespace

H3Group group_of(const ReplayRows& rows,
                 const std::vector<H3Trial>& trials,
                 const std::set<CaseKey>& cases,
                 const H3Options& options,
                 const Watch& watch,
                 const std::string& lighting) {
  return Group(rows, trials, cases, options, watch).result(lighting);
}

}  // namespace tcert::study
