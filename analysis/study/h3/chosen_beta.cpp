#include "analysis/study/h3/chosen_beta.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <statistics/basics/holm.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <stdexcept>
#include <table/not_a_number.hpp>

#include "analysis/study/h1/withhold.hpp"
#include "analysis/study/h3/cluster_loss.hpp"
#include "analysis/study/replay/replay.hpp"

namespace tcert::study {
namespace {

constexpr std::uint32_t kChoiceStream = 0x48330001;
constexpr double kStatedPower = 0.8;

using Choice = std::vector<std::vector<std::size_t>>;  // [law][fold]

/// Seconds and metres of a rate.
struct Advanced {
  double length = 0.0;
  double time = 0.0;

  void add(double times, double more_length, double more_time) {
    length += times * more_length;
    time += times * more_time;
  }
  [[nodiscard]] double rate() const { return rate_of_advance(length, time).value_or(table::kNaN); }
};

/// What a case would have driven and lost outside of each fold.
struct Training {
  std::vector<Advanced> driven;
  std::vector<double> lost;
};

Training training_of(const ChoiceRows& rows,
                     std::size_t one,
                     std::span<const std::uint32_t> multiplicity) {
  Training training{std::vector<Advanced>(rows.folds), std::vector<double>(rows.folds, 0.0)};
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    for (std::size_t f = 0; f < rows.folds && rows.baseline[i] == 0; ++f) {
      if (f != rows.fold[i]) {
        training.driven[f].add(multiplicity[i], rows.length[i], rows.gated_time[one][i]);
        training.lost[f] += multiplicity[i] * rows.lost[one][i];
      }
    }
  }
  return training;
}

/// The beta asked for, else the middle one.
std::size_t case_beforehand(const ChoiceRows& rows, std::size_t law, const H3Beta& beta) {
  const std::vector<std::size_t>& cases = rows.cases_of_law[law];
  const auto found = std::find_if(
      cases.begin(), cases.end(), [&](std::size_t one) { return rows.beta[one] == beta.per_m; });
  if (found != cases.end()) {
    return *found;
  }
  if (beta.asked) {
    std::string known;
    for (const std::size_t one : cases) {
      known += fmt::format("{}{:g}", known.empty() ? "" : ", ", rows.beta[one]);
    }
    throw std::invalid_argument(fmt::format("h3: law '{}' was not replayed at beta {:g}, but at {}",
                                            rows.laws[law],
                                            *beta.per_m,
                                            known));
  }
  return cases[(cases.size() - 1) / 2];
}

Choice chosen(const ChoiceRows& rows,
              const H3Options& options,
              std::span<const std::uint32_t> multiplicity) {
  if (!options.beta.per_m) {
    return chosen_by_folds(rows, options.loss_margin, multiplicity);
  }
  Choice choice;
  for (std::size_t law = 0; law < rows.laws.size(); ++law) {
    choice.emplace_back(rows.folds, case_beforehand(rows, law, options.beta));
  }
  return choice;
}

/// Gain and share of the gap, of each law under all lightings and each.
constexpr std::size_t kValues = 2;

/// Rates of one lighting.
struct OfLighting {
  Advanced own, lead;
  std::vector<Advanced> gated;  ///< By law.
};

void fill_values(const std::vector<OfLighting>& some, std::size_t law, std::span<double> values) {
  Advanced own;
  Advanced gated;
  Advanced lead;  // Its seconds, had it driven the metres of the gated algorithm.
  for (const OfLighting& one : some) {
    own.add(1.0, one.own.length, one.own.time);
    gated.add(1.0, one.gated[law].length, one.gated[law].time);
    if (one.own.length > 0.0) {
      lead.add(1.0, one.own.length, 60.0 * one.own.length / one.lead.rate());
    }
  }
  values[0] = gated.rate() - own.rate();
  values[1] = values[0] / (lead.rate() - own.rate());
}

void family_values(const ChoiceRows& rows,
                   const Choice& choice,
                   std::span<const std::uint32_t> multiplicity,
                   std::span<double> values) {
  std::vector<OfLighting> by_lighting(rows.lightings.size(),
                                      OfLighting{{}, {}, std::vector<Advanced>(rows.laws.size())});
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    OfLighting& here = by_lighting[rows.lighting[i]];
    (rows.baseline[i] != 0 ? here.lead : here.own)
        .add(multiplicity[i], rows.length[i], rows.time[i]);
    for (std::size_t law = 0; law < rows.laws.size() && rows.baseline[i] == 0; ++law) {
      here.gated[law].add(
          multiplicity[i], rows.length[i], rows.gated_time[choice[law][rows.fold[i]]][i]);
    }
  }
  const std::size_t groups = rows.lightings.size() > 1 ? rows.lightings.size() + 1 : 1;
  for (std::size_t law = 0; law < rows.laws.size(); ++law) {
    for (std::size_t g = 0; g < groups; ++g) {
      fill_values(g == 0 ? by_lighting : std::vector<OfLighting>{by_lighting[g - 1]},
                  law,
                  values.subspan((law * groups + g) * kValues, kValues));
    }
  }
}

/// One-sided p of no gain, by the clusters that the gated algorithm has trials in.
std::optional<double> gain_p_of(double gain, std::span<const double> left_out) {
  const statistics::ClusterT by_t = statistics::jackknife_estimate(gain, left_out, 0.95);
  return by_t.standard_error && by_t.df
             ? std::optional(statistics::t_p_value(
                   gain / *by_t.standard_error, *by_t.df, statistics::Alternative::greater))
             : std::nullopt;
}

/// Laws and lightings at one time.
class Family {
 public:
  Family(const ReplayRows& replays,
         const Grouped& grouped,
         const std::vector<H3Group>& groups,
         const H3Options& options)
      : rows_(std::make_shared<const ChoiceRows>(
            choice_rows(replays, grouped, options.beta.per_m ? 1 : options.beta.folds))),
        groups_(groups),
        options_(options),
        once_(rows_->rows(), 1),
        choice_(chosen(*rows_, options, once_)),
        independent_trials_(trials_for_power(
            options.true_loss, options.loss_margin, options.level, kStatedPower)) {}

  std::vector<H3Chosen> result(const Watch& watch) {
    resample(watch);
    std::vector<H3Chosen> all;
    for (std::size_t law = 0; law < rows_->laws.size(); ++law) {
      for (std::size_t g = 0; g < groups_.size(); ++g) {
        all.push_back(one(law, g));
      }
    }
    adjust(all);
    return all;
  }

 private:
  void resample(const Watch& watch) {
    statistics::Statistic statistic;
    statistic.rows = rows_->rows();
    statistic.values = rows_->laws.size() * groups_.size() * kValues;
    statistic.make_kernel = [rows = rows_, options = options_]() -> statistics::StatisticKernel {
      return
          [rows, options](std::span<const std::uint32_t> multiplicity, std::span<double> values) {
            family_values(*rows, chosen(*rows, options, multiplicity), multiplicity, values);
          };
    };
    watch.begin("chosen beta, resamples", options_.replicates);
    bootstrap_ = statistics::bootstrap(
        statistic,
        statistics::ResamplingPlan::of_clusters(rows_->cluster),
        {options_.replicates, options_.seed, kChoiceStream, watch.on_advance});
  }

  [[nodiscard]] bool is_in(std::size_t trial, std::size_t group) const {
    return group == 0 || rows_->lighting[trial] == group - 1;
  }

  /// Clusters in which an algorithm succeeds.
  [[nodiscard]] std::set<std::uint32_t> clusters_of(std::size_t group, bool baseline) const {
    std::set<std::uint32_t> clusters;
    for (std::size_t i = 0; i < rows_->rows(); ++i) {
      if (is_in(i, group) && (rows_->baseline[i] != 0) == baseline && rows_->length[i] > 0.0) {
        clusters.insert(rows_->cluster[i]);
      }
    }
    return clusters;
  }

  [[nodiscard]] H3Estimate estimate(std::size_t value, std::size_t units, bool has_interval) const {
    H3Estimate out;
    if (std::isnan(bootstrap_.observed[value])) {
      return out;
    }
    out.value = bootstrap_.observed[value];
    if (has_interval && units > 1) {
      out.interval = statistics::bootstrap_estimate(
                         bootstrap_, value, options_.level, options_.interval, units)
                         .interval;
      out.intervals = statistics::bootstrap_intervals(bootstrap_, value, options_.level, units);
    }
    return out;
  }

  [[nodiscard]] ClusterLoss loss_of(std::size_t law, std::size_t group) const {
    std::vector<std::uint8_t> lost;
    std::vector<std::uint8_t> failed;
    std::vector<std::uint32_t> cluster;
    for (std::size_t i = 0; i < rows_->rows(); ++i) {
      if (is_in(i, group) && rows_->baseline[i] == 0) {
        lost.push_back(rows_->lost[choice_[law][rows_->fold[i]]][i]);
        failed.push_back(rows_->failed[i]);
        cluster.push_back(rows_->cluster[i]);
      }
    }
    return cluster_loss(lost, failed, cluster, options_.level, options_.loss_margin);
  }

  H3Chosen one(std::size_t law, std::size_t g) {
    const H3Group& group = groups_[g];
    H3Chosen out;
    out.law = rows_->laws[law];
    out.lighting = group.lighting;
    std::map<double, std::size_t> betas;
    for (const std::size_t each : choice_[law]) {
      ++betas[rows_->beta[each]];
    }
    out.betas.assign(betas.begin(), betas.end());
    const std::size_t value = (law * groups_.size() + g) * kValues;
    const std::set<std::uint32_t> own = clusters_of(g, false);
    const std::set<std::uint32_t> lead = clusters_of(g, true);
    const bool known = group.withheld.empty() && group.successes >= kTooFewOutcomes;
    out.gain = estimate(value, own.size(), known);
    const auto& gap = group.gap.interval;
    if (gap && (gap->low > 0.0 || gap->high < 0.0)) {
      out.recovered = estimate(value + 1,
                               std::min(own.size(), lead.size()),
                               known && group.baseline_successes >= kTooFewOutcomes);
    }
    const ClusterLoss loss = loss_of(law, g);
    out.lost = loss.lost;
    out.trials = loss.trials;
    if (!known) {
      return out;
    }
    out.lost_lower = loss.lower;
    out.lost_upper = loss.upper;
    out.loss_p = loss.p;
    std::vector<double> left_out;
    for (const std::uint32_t code : own) {
      left_out.push_back(bootstrap_.left_out[value][code]);
    }
    out.gain_p = gain_p_of(bootstrap_.observed[value], left_out);
    if (out.gain_p && out.loss_p) {
      out.p = std::max(*out.gain_p, *out.loss_p);
    }
    if (independent_trials_) {
      out.trials_for_power = std::ceil(*independent_trials_ * loss.design_effect);
    }
    return out;
  }

  /// All lightings together are one family, of the laws; laws and lightings another.
  void adjust(std::vector<H3Chosen>& all) const {
    for (const bool together : {true, false}) {
      std::vector<std::optional<double>> p;
      std::vector<H3Chosen*> family;
      for (H3Chosen& each : all) {
        if ((each.lighting == groups_.front().lighting) == together) {
          family.push_back(&each);
          p.push_back(each.p);
        }
      }
      const std::vector<std::optional<double>> adjusted = statistics::holm(p);
      for (std::size_t k = 0; k < family.size(); ++k) {
        family[k]->holm = adjusted[k];
        if (adjusted[k]) {
          family[k]->holds = *adjusted[k] <= 1.0 - options_.level;
        }
      }
    }
  }

  std::shared_ptr<const ChoiceRows> rows_;
  const std::vector<H3Group>& groups_;
  const H3Options& options_;
  std::vector<std::uint32_t> once_;
  Choice choice_;                             ///< On the trials as they are.
  std::optional<double> independent_trials_;  ///< For the stated power.
  statistics::BootstrapResult bootstrap_;
};

}  // namespace

ChoiceRows choice_rows(const ReplayRows& replays, const Grouped& grouped, std::size_t folds) {
  ChoiceRows rows;
  const std::vector<CaseKey> cases(grouped.cases.begin(), grouped.cases.end());
  for (std::size_t c = 0; c < cases.size(); ++c) {
    if (rows.laws.empty() || rows.laws.back() != cases[c].first) {
      rows.laws.push_back(cases[c].first);
      rows.cases_of_law.emplace_back();
    }
    rows.cases_of_law.back().push_back(c);
    rows.beta.push_back(cases[c].second);
  }
  rows.gated_time.resize(cases.size());
  rows.lost.resize(cases.size());
  std::map<std::string, std::uint32_t> codes;
  for (const auto& [lighting, trials] : grouped.by_lighting) {
    for (const H3Trial& trial : trials) {
      codes.emplace(replays.cluster[trial.any_row()], 0);
    }
  }
  std::uint32_t next = 0;
  for (auto& [cluster, code] : codes) {
    code = next++;
  }
  rows.folds = std::max<std::size_t>(1, std::min<std::size_t>(folds, codes.size()));
  for (const auto& [lighting, trials] : grouped.by_lighting) {
    for (const H3Trial& trial : trials) {
      const std::size_t row = trial.any_row();
      const bool counts =
          trial.success && !std::isnan(replays.length[row]) && !std::isnan(replays.time[row]);
      rows.cluster.push_back(codes.at(replays.cluster[row]));
      rows.fold.push_back(rows.cluster.back() % rows.folds);
      rows.lighting.push_back(rows.lightings.size());
      rows.baseline.push_back(trial.baseline ? 1 : 0);
      rows.failed.push_back(trial.success ? 0 : 1);
      rows.length.push_back(counts ? replays.length[row] : 0.0);
      rows.time.push_back(counts ? replays.time[row] : 0.0);
      for (std::size_t c = 0; c < cases.size(); ++c) {
        const std::size_t own = trial.row.at(cases[c]);
        rows.gated_time[c].push_back(counts ? replays.gated_time[own] : 0.0);
        rows.lost[c].push_back(trial.success && replays.kept[own] != 1.0 ? 1 : 0);
      }
    }
    rows.lightings.push_back(lighting);
  }
  return rows;
}

std::vector<std::vector<std::size_t>> chosen_by_folds(const ChoiceRows& rows,
                                                      double margin,
                                                      std::span<const std::uint32_t> multiplicity) {
  std::vector<double> trials(rows.folds, 0.0);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    for (std::size_t f = 0; f < rows.folds && rows.baseline[i] == 0; ++f) {
      trials[f] += f != rows.fold[i] ? multiplicity[i] : 0.0;
    }
  }
  Choice choice;
  for (const std::vector<std::size_t>& cases : rows.cases_of_law) {
    choice.emplace_back(rows.folds, cases.front());
    std::vector<double> best_rate(rows.folds, -1.0);
    std::vector<double> best_lost(rows.folds, 2.0);
    for (const std::size_t one : cases) {
      const Training training = training_of(rows, one, multiplicity);
      for (std::size_t f = 0; f < rows.folds; ++f) {
        const double rate = training.driven[f].rate();
        const double share = trials[f] > 0.0 ? training.lost[f] / trials[f] : 1.0;
        // What loses no more than the margin counts as losing none.
        const double lost = share <= margin ? 0.0 : share;
        if (lost < best_lost[f] || (lost == best_lost[f] && rate > best_rate[f])) {
          best_lost[f] = lost;
          best_rate[f] = rate;
          choice.back()[f] = one;
        }
      }
    }
  }
  return choice;
}

std::vector<H3Chosen> chosen_cases(const ReplayRows& rows,
                                   const Grouped& grouped,
                                   const std::vector<H3Group>& groups,
                                   const H3Options& options,
                                   const Watch& watch) {
  return Family(rows, grouped, groups, options).result(watch);
}

}  // namespace tcert::study
