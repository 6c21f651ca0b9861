#include "analysis/study/coverage/hypotheses_study.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/normal.hpp>
#include <statistics/clusters/contrast_inference.hpp>
#include <statistics/lmm/lmm.hpp>
#include <statistics/logistic/logistic_sandwich.hpp>
#include <statistics/model/formula.hpp>
#include <statistics/model/pairwise.hpp>

#include "analysis/study/coverage/inference_study.hpp"
#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h2/hypothesis_h2.hpp"

namespace tcert::study::coverage {
namespace {

constexpr double kTestLevel = 0.05;

table::DataColumn number_column(const char* name, std::vector<double> values) {
  table::DataColumn column;
  column.name = name;
  column.numbers = std::move(values);
  return column;
}

table::DataColumn text_column(const char* name,
                              std::vector<std::string> levels,
                              std::vector<std::uint32_t> codes) {
  table::DataColumn column;
  column.name = name;
  column.is_text = true;
  column.text.levels = std::move(levels);
  column.text.codes = std::move(codes);
  return column;
}

std::optional<bool> interval_misses(const std::optional<statistics::Interval>& interval,
                                    double truth) {
  return interval ? std::optional(truth < interval->low || truth > interval->high) : std::nullopt;
}

std::optional<bool> rejects(const std::optional<double>& p) {
  return p ? std::optional(*p < kTestLevel) : std::nullopt;
}

/// Of a ratio per standard deviation of the panel, whose logarithm is `truth` per unit.
std::optional<bool> ratio_misses(const H1HazardRatio& ratio, double truth, double sd) {
  return interval_misses(ratio.interval, std::exp(truth * sd));
}

/// What the study is asked of, in the order of kPrinted.
class Reader {
 public:
  void add(std::optional<bool> miss) { misses_.of.at(next_++) = miss; }
  [[nodiscard]] Misses done() const { return misses_; }

 private:
  Misses misses_;
  std::size_t next_ = 0;
};

struct Truth {
  double auc = true_auc(kFirstCorrelation);
  double auc_gain = auc - true_auc(kSecondCorrelation);
  double c = true_c(kFirstCorrelation);
  double c_gain = c - true_c(kSecondCorrelation);
  double log_odds = limit_log_odds(kFirstCorrelation);
  double log_hazard = limit_log_hazard(kFirstCorrelation);
  double r2_gain = limit_r2(kFirstCorrelation) - limit_r2(kSecondCorrelation);
};

H1Options h1_options(const Options& options, std::size_t replicates, std::uint64_t index) {
  H1Options h1;
  h1.predictors = {{"first", statistics::HigherMeans::success, ""},
                   {"second", statistics::HigherMeans::success, ""},
                   {"unrelated", statistics::HigherMeans::success, ""}};
  h1.level = options.level;
  h1.replicates = replicates;
  h1.seed = options.seed + index;
  h1.folds = 2;
  return h1;
}

void read_h1(const table::DataTable& table, H1Options options, const Truth& truth, Reader& reader) {
  options.models = false;
  const H1Panel panel = hypothesis_h1(table, options).panels.front();
  const H1Row& first = panel.rows.at(0);
  const H1Row& second = panel.rows.at(1);
  reader.add(interval_misses(first.within.auc.interval, truth.auc));
  reader.add(interval_misses(second.within.auc_gain.interval, truth.auc_gain));
  reader.add(interval_misses(second.within.auc_gain_between.interval, 0.0));
  reader.add(interval_misses(first.within.c.interval, truth.c));
  reader.add(interval_misses(second.within.c_gain.interval, truth.c_gain));
  reader.add(interval_misses(second.within.c_gain_between.interval, 0.0));
  reader.add(interval_misses(first.c_at_limit.interval, truth.c));
  const double sd = first.sd.value_or(1.0);
  reader.add(ratio_misses(first.censored, truth.log_hazard, sd));
  reader.add(ratio_misses(first.at_limit, truth.log_hazard, sd));
  reader.add(ratio_misses(first.stratified, truth.log_hazard, sd));
  // Models need no resamples of their own.
  options.models = true;
  options.replicates = 1;
  const H1Panel models = hypothesis_h1(table, options).panels.front();
  reader.add(rejects(models.rows.at(2).mixed.p_value));
  reader.add(interval_misses(models.rows.at(1).log_time.r2_gain_interval, truth.r2_gain));
  reader.add(rejects(models.rows.at(2).log_time.p_value));
}

std::optional<double> p_of(const std::optional<H2Equality>& equality) {
  return equality && equality->tests.heterogeneity
             ? std::optional(equality->tests.heterogeneity->p_value)
             : std::nullopt;
}

std::optional<double> p_of(const H2Interaction& interaction) {
  return interaction.test ? std::optional(interaction.test->p_value) : std::nullopt;
}

void read_h2(const table::DataTable& table,
             const H1Options& options,
             const Truth& truth,
             Reader& reader) {
  H2Options h2;
  h2.trials = options;
  h2.trials.predictors.resize(1);
  h2.trials.group = "lighting";
  h2.trials.within = {"algorithm"};
  h2.permutations = 1;
  const H2Panel panel = hypothesis_h2(table, h2).panels.front();
  const H2Level& dark = panel.levels.at(0);
  const double sd = panel.sd.value_or(1.0);
  reader.add(interval_misses(dark.auc.interval, truth.auc));
  reader.add(interval_misses(dark.c.interval, truth.c));
  reader.add(ratio_misses(dark.odds, truth.log_odds, sd));
  reader.add(ratio_misses(dark.censored, truth.log_hazard, sd));
  reader.add(rejects(p_of(panel.auc)));
  reader.add(rejects(p_of(panel.c)));
  const bool has_pair = panel.c && !panel.c->tests.pairs.empty() && dark.withheld.empty() &&
                        panel.levels.at(1).withheld.empty();
  reader.add(has_pair ? interval_misses(panel.c->tests.pairs.front().interval, 0.0) : std::nullopt);
  for (std::size_t k = 0; k < 3; ++k) {
    reader.add(k < panel.interactions.size() ? rejects(p_of(panel.interactions[k])) : std::nullopt);
  }
  reader.add(panel.mixed_interaction ? rejects(p_of(*panel.mixed_interaction)) : std::nullopt);
}

/// Whether Holm's p of a pair of lightings, which are alike, is small.
std::optional<bool> any_pair(const statistics::LevelMeans& means,
                             const statistics::CoefficientSums& sums,
                             double level) {
  std::optional<bool> any;
  for (const statistics::PairContrast& pair : statistics::pairwise_contrasts(means, sums, level)) {
    if (pair.holm) {
      any = any.value_or(false) || *pair.holm < kTestLevel;
    }
  }
  return any;
}

void read_contrasts(const table::DataTable& table, double level, Reader& reader) {
  statistics::FrameOptions options;
  options.cluster = "day";
  const statistics::Formula formula = statistics::parse_formula("success ~ first + lighting");
  const statistics::ModelFrame frame = statistics::model_frame(formula, table, options);
  const statistics::LogisticInput input = statistics::logistic_input(frame);
  statistics::LogisticOptions robust;
  robust.variance = statistics::CoefficientVariance::robust;
  const statistics::LogisticFit fit = statistics::fit_logistic(input, robust);
  const auto inferences = statistics::cluster_inferences(input, fit, {}, {});
  std::vector<std::optional<double>> estimates;
  for (const auto& one : fit.coefficients) {
    estimates.push_back(one.estimate);
  }
  reader.add(any_pair(
      statistics::level_means(formula, table, frame, options, "lighting"),
      [&](const Eigen::MatrixXd& weights) {
        return statistics::cluster_sums({}, inferences, estimates, fit.clusters, weights);
      },
      level));
  const statistics::Formula linear =
      statistics::parse_formula("log(time_s) ~ first + lighting + (1 | day)");
  const statistics::ModelFrame times = statistics::model_frame(linear, table, {});
  const statistics::LmmFit lmm = statistics::fit_lmm(statistics::lmm_input(times));
  estimates.clear();
  for (const auto& one : lmm.coefficients) {
    estimates.push_back(one.estimate);
  }
  reader.add(any_pair(
      statistics::level_means(linear, table, times, {}, "lighting"),
      [&](const Eigen::MatrixXd& weights) {
        auto sums = statistics::sums_by_covariance(estimates, lmm.covariance, {}, weights);
        for (std::size_t k = 0; k < sums.size(); ++k) {
          sums[k].df =
              statistics::lmm_contrast(lmm, weights.row(static_cast<Eigen::Index>(k)).transpose())
                  .df;
        }
        return sums;
      },
      level));
}

}  // namespace

table::DataTable simulated_table(const Scenario& scenario,
                                 std::uint64_t seed,
                                 std::uint32_t stream,
                                 std::uint64_t index) {
  const Study study = simulate(scenario, seed, stream, index);
  const Study other = simulate(scenario, seed, stream + 1, index);
  std::vector<std::uint32_t> algorithm;
  std::vector<std::uint32_t> lighting;
  for (std::uint32_t i = 0; i < study.success.size(); ++i) {
    algorithm.push_back(i % 2);
    lighting.push_back(i / 2 % 3);
  }
  table::DataTable table;
  table.rows = study.success.size();
  table.columns = {number_column("day", {study.day.begin(), study.day.end()}),
                   text_column("algorithm", {"M1", "M2"}, std::move(algorithm)),
                   text_column("lighting", {"Dark", "Indoor", "Outdoor"}, std::move(lighting)),
                   number_column("success", {study.success.begin(), study.success.end()}),
                   number_column("time_s", study.time),
                   number_column("first", study.first),
                   number_column("second", study.second),
                   number_column("unrelated", other.first)};
  for (const table::DataColumn& column : table.columns) {
    table.header.push_back(column.name);
  }
  return table;
}

double limit_r2(double r) {
  constexpr int kSteps = 20000;
  constexpr double kEnd = 9.0;
  const double threshold = statistics::normal_quantile(kFailureShare);
  const double step = (kEnd - threshold) / kSteps;
  double weight = 0.0;
  double l = 0.0;
  double ll = 0.0;
  double t = 0.0;
  double tt = 0.0;
  double lt = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double ability = threshold + (i + 0.5) * step;
    const double w = std::exp(-0.5 * ability * ability);
    const double time = std::log(60.0 - 5.0 * ability);
    weight += w;
    l += w * ability;
    ll += w * ability * ability;
    t += w * time;
    tt += w * time * time;
    lt += w * ability * time;
  }
  l /= weight;
  t /= weight;
  const double of_ability = ll / weight - l * l;
  const double of_time = tt / weight - t * t;
  const double both = lt / weight - l * t;
  return r * r * both * both / ((r * r * of_ability + 1.0 - r * r) * of_time);
}

Misses misses_of(const Scenario& scenario,
                 std::uint32_t stream,
                 const Options& options,
                 std::uint64_t index) {
  static const Truth truth;
  const table::DataTable table = simulated_table(scenario, options.seed, stream, index);
  const H1Options h1 =
      h1_options(options, std::max<std::size_t>(1, options.replicates * 22 / scenario.days), index);
  Reader reader;
  read_h1(table, h1, truth, reader);
  read_h2(table, h1, truth, reader);
  read_contrasts(table, options.level, reader);
  return reader.done();
}

std::vector<MissRate> miss_rates(const Scenario& scenario, const std::vector<Misses>& sets) {
  std::vector<MissRate> rates;
  for (std::size_t k = 0; k < kPrinted.size(); ++k) {
    rates.push_back({count_missed(sets, k), scenario, kPrinted[k]});
  }
  return rates;
}

}  // namespace tcert::study::coverage
