// Every case of the boot goldens: jackknife and acceleration, all intervals from R's replicates,
// the statistic on R's resamples, and intervals of the project's own stream within the Monte-Carlo
// error that the goldens state. boot gives no BCa with fewer replicates than units; we do.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <statistics/basics/normal.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/model/formula.hpp>
#include <statistics/model/model_frame.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <string>
#include <table/read_data_table.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/statistics/golden_columns.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::statistics {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kFromReplicates = 1e-9;
constexpr double kJackknife = 1e-10;

/// What a golden case estimates: a formula, and the difference of its two predictors if it has two.
struct Case {
  const char* formula;
  std::vector<HigherMeans> higher;
};

const std::map<std::string, Case>& cases() {
  constexpr HigherMeans kUp = HigherMeans::success;
  constexpr HigherMeans kDown = HigherMeans::failure;
  static const std::map<std::string, Case> all{
      {"asah_auc_s100b", {"poor ~ s100b", {kUp}}},
      {"asah_auc_wfns", {"poor ~ wfns", {kUp}}},
      {"asah_aucdiff_wfns_s100b", {"poor ~ wfns + s100b", {kUp, kUp}}},
      {"sim660_auc_x1", {"success ~ x1", {kUp}}},
      {"sim660_aucdiff_x1_x2", {"success ~ x1 + x2", {kUp, kUp}}},
      {"edge_ties_auc_s1", {"y ~ score1", {kUp}}},
      {"lung_c_age", {"Surv(time, status == 2) ~ age", {kUp}}},
      {"veteran_cdiff_karno_age", {"Surv(time, status) ~ karno + age", {kDown, kUp}}},
      {"sim660_c_x1", {"Surv(time, success) ~ x1", {kUp}}},
      {"sim660_cdiff_x1_x2", {"Surv(time, success) ~ x1 + x2", {kUp, kUp}}},
      {"sim660_aucdiff_x1_x2_byday", {"success ~ x1 + x2", {kUp, kUp}}},
      {"sim660_cdiff_x1_x2_byday", {"Surv(time, success) ~ x1 + x2", {kUp, kUp}}}};
  return all;
}

std::vector<std::vector<double>> read_rows(const fs::path& path, bool header) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  std::string line;
  if (header) {
    std::getline(file, line);
  }
  std::vector<std::vector<double>> rows;
  while (std::getline(file, line)) {
    std::vector<double> row;
    const char* at = line.c_str();
    for (char* end = nullptr; *at != '\0'; at = *end == ',' ? end + 1 : end) {
      row.push_back(std::strtod(at, &end));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<double> read_replicates(const fs::path& path) {
  std::vector<double> values;
  for (const auto& row : read_rows(path, true)) {
    values.push_back(row.front());
  }
  return values;
}

/// A golden case as a statistic of a table; `value` is the number that R's is.
struct Problem {
  Statistic statistic;
  std::size_t value = 0;
  std::shared_ptr<ResamplingPlan> plan;
  std::vector<std::uint32_t> strata;
};

Statistic statistic_of(const ModelFrame& frame, const Case& test_case) {
  std::vector<std::vector<double>> columns;
  for (Eigen::Index k = 1; k < frame.design.cols(); ++k) {
    const Eigen::VectorXd column = frame.design.col(k);
    columns.emplace_back(column.begin(), column.end());
  }
  const AucDifferences differences =
      columns.size() == 2 ? AucDifferences{{0, 1}} : AucDifferences{};
  if (const auto* survival = std::get_if<SurvivalOutcome>(&frame.outcome)) {
    std::vector<Predictor> predictors;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      predictors.push_back({frame.columns[k + 1],
                            columns[k],
                            test_case.higher[k] == HigherMeans::success
                                ? LargerMeans::shorter_time
                                : LargerMeans::longer_time});
    }
    return concordance_statistic(*survival, predictors, differences);
  }
  std::vector<Score> scores;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    scores.push_back({columns[k], test_case.higher[k]});
  }
  std::vector<std::uint8_t> success;
  for (const double y : std::get<NumberOutcome>(frame.outcome).values) {
    success.push_back(y == 1.0 ? 1 : 0);
  }
  return auc_statistic(scores, success, differences);
}

class BootGolden : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = test_support::shared_data() / "stats";
    std::ifstream file(folder_ / "golden" / "boot.json");
    if (!file) {
      GTEST_SKIP() << "no golden values: " << (folder_ / "golden" / "boot.json");
    }
    golden_ = json::parse(file)["models"];
  }

  void TearDown() override {
    for (const auto& [quantity, worst] : worst_) {
      std::printf("  %-22s worst relative disagreement %.1e\n", quantity.c_str(), worst);
    }
  }

  void expect(const std::string& quantity, double actual, const json& expected, double tolerance) {
    const double value = number(expected);
    const double error =
        value == 0.0 ? std::abs(actual) : std::abs(actual - value) / std::abs(value);
    EXPECT_LE(error, tolerance) << quantity << ": " << actual << " for " << value;
    worst_[quantity] = std::max(worst_[quantity], error);
  }

  [[nodiscard]] Problem problem(const std::string& name, const json& expected) const {
    const Case& test_case = cases().at(name);
    table::DataTableResult file =
        table::read_data_table(folder_ / "data" / expected["data"].get<std::string>());
    FrameOptions options;
    if (expected["cluster"].is_string()) {
      options.cluster = expected["cluster"];
    }
    const ModelFrame frame = model_frame(parse_formula(test_case.formula), *file.table, options);
    Problem result;
    result.statistic = statistic_of(frame, test_case);
    result.value = result.statistic.values - 1;
    result.plan = std::make_shared<ResamplingPlan>(
        frame.cluster ? ResamplingPlan::of_clusters(frame.cluster->codes)
                      : ResamplingPlan::of_rows(frame.size()));
    if (const auto* outcome = std::get_if<NumberOutcome>(&frame.outcome)) {
      for (const double y : outcome->values) {
        result.strata.push_back(y == 1.0 ? 1 : 0);
      }
    }
    return result;
  }

  void expect_interval(const BootstrapDistribution& distribution,
                       BootstrapMethod method,
                       double a,
                       double level,
                       const json& expected) {
    const BootstrapInterval ours = bootstrap_interval(distribution, method, a, level);
    ASSERT_TRUE(ours.interval.has_value());
    const char* const name[] = {"normal", "basic", "percentile", "expanded", "BCa"};
    const std::string quantity = name[static_cast<std::size_t>(method)];
    expect(quantity, ours.interval->low, expected[0], kFromReplicates);
    expect(quantity, ours.interval->high, expected[1], kFromReplicates);
  }

  void expect_all(const BootstrapDistribution& distribution,
                  double a,
                  double level,
                  const json& expected) {
    expect_interval(distribution, BootstrapMethod::normal, a, level, expected["normal"]);
    expect_interval(distribution, BootstrapMethod::basic, a, level, expected["basic"]);
    expect_interval(distribution, BootstrapMethod::percentile, a, level, expected["percent"]);
    expect_interval(distribution, BootstrapMethod::bca, a, level, expected["bca"]);
    const BootstrapInterval bca = bootstrap_interval(distribution, BootstrapMethod::bca, a, level);
    // R rounds its ranks to two decimals.
    EXPECT_NEAR(bca.low_rank, number(expected["bca_order_stats"][0]), 0.00501);
    EXPECT_NEAR(bca.high_rank, number(expected["bca_order_stats"][1]), 0.00501);
  }

  void expect_counts(const BootstrapDistribution& distribution, const json& expected) {
    EXPECT_EQ(distribution.below, expected["n_less_than_t0"].get<std::size_t>());
    EXPECT_EQ(distribution.equal, expected["n_equal_t0"].get<std::size_t>());
    expect("SD", distribution.standard_deviation, expected["sd"], kFromReplicates);
    expect("z0",
           normal_quantile(static_cast<double>(distribution.below) /
                           static_cast<double>(distribution.sorted.size())),
           expected["z0"],
           kFromReplicates);
  }

  [[nodiscard]] double observed(const json& expected) const {
    return std::stod(expected["t0_17g"].get<std::string>());
  }

  fs::path folder_;
  json golden_;
  std::map<std::string, double> worst_;
};

TEST_F(BootGolden, IntervalsFromTheirReplicates) {
  std::size_t cases_run = 0;
  for (const auto& [name, expected] : golden_.items()) {
    SCOPED_TRACE(name);
    const json& boot = expected["boot"];
    const BootstrapDistribution distribution = bootstrap_distribution(
        read_replicates(folder_ / "data" / boot["replicate_file"].get<std::string>()),
        observed(expected));
    expect_counts(distribution, boot);
    expect("mean", distribution.mean, boot["mean"], kFromReplicates);
    const double a = number(expected["jackknife"]["a_boot"]);
    for (const auto& [key, level] :
         {std::pair{"conf90", 0.90}, {"conf95", 0.95}, {"conf99", 0.99}}) {
      expect_all(distribution, a, level, expected["ci"][key]["with_L_jack"]);
    }
    for (const char* which : {"a_boot", "a_centred"}) {
      expect_interval(distribution,
                      BootstrapMethod::bca,
                      number(expected["jackknife"][which]),
                      0.95,
                      expected["bca95_levels"][which]["norm_inter"]);
    }
    if (expected.contains("stratified")) {
      const json& stratified = expected["stratified"];
      const BootstrapDistribution by_stratum = bootstrap_distribution(
          read_replicates(folder_ / "data" / stratified["replicate_file"].get<std::string>()),
          observed(expected));
      expect_counts(by_stratum, stratified);
      expect_all(by_stratum, number(stratified["a_boot"]), 0.95, stratified["conf95_with_L_jack"]);
    }
    ++cases_run;
  }
  std::printf("boot golden cases run: %zu sets of replicates\n", cases_run);
  EXPECT_GT(cases_run, 0U);
}

TEST_F(BootGolden, JackknifeAndAcceleration) {
  std::size_t cases_run = 0;
  for (const auto& [name, expected] : golden_.items()) {
    SCOPED_TRACE(name);
    const Problem p = problem(name, expected);
    ASSERT_EQ(p.plan->units(), expected["units"].get<std::size_t>());
    const BootstrapResult few = bootstrap(p.statistic, *p.plan, {10, 1, 0});
    const double t0 = few.observed[p.value];
    expect("t0", t0, observed(expected), 1e-13);
    const std::vector<double>& left_out = few.left_out[p.value];
    const std::vector<double> L = jackknife_influence(*p.plan, t0, left_out);
    const json& jackknife = expected["jackknife"];
    double squares = 0.0;
    double cubes = 0.0;
    double mean = 0.0;
    for (std::size_t k = 0; k < L.size(); ++k) {
      squares += L[k] * L[k];
      cubes += L[k] * L[k] * L[k];
      mean += left_out[k] / static_cast<double>(L.size());
    }
    for (std::size_t k = 0; k < jackknife["L_first"].size(); ++k) {
      expect("left out", left_out[k], jackknife["leave_one_out_first"][k], kJackknife);
      expect("L", L[k], jackknife["L_first"][k], kJackknife);
    }
    expect("left out", mean, jackknife["leave_one_out_mean"], kJackknife);
    expect("sum L^2", squares, jackknife["L_ss"], kJackknife);
    expect("sum L^3", cubes, jackknife["L_cubes"], kJackknife);
    expect("a", few.acceleration[p.value].value(), jackknife["a_boot"], kJackknife);
    expect("a centred",
           acceleration(jackknife_influence(*p.plan, t0, left_out, true)).value(),
           jackknife["a_centred"],
           kJackknife);
    if (expected.contains("stratified")) {
      const json& stratified = expected["stratified"];
      const ResamplingPlan plan = ResamplingPlan::of_rows(p.statistic.rows, p.strata);
      const auto in_stratum =
          jackknife_influence(plan, t0, leave_one_out(p.statistic, plan)[p.value]);
      for (std::size_t k = 0; k < stratified["L_first"].size(); ++k) {
        expect("L stratified", in_stratum[k], stratified["L_first"][k], kJackknife);
      }
      expect("a stratified", acceleration(in_stratum).value(), stratified["a_boot"], kJackknife);
    }
    ++cases_run;
  }
  std::printf("boot golden cases run: %zu jackknives\n", cases_run);
  EXPECT_GT(cases_run, 0U);
}

TEST_F(BootGolden, StatisticOnTheirResamples) {
  std::size_t cases_run = 0;
  for (const auto& [name, expected] : golden_.items()) {
    if (!expected.contains("with_indices")) {
      continue;
    }
    SCOPED_TRACE(name);
    const json& indices = expected["with_indices"];
    const Problem p = problem(name, expected);
    const StatisticKernel kernel = p.statistic.make_kernel();
    std::vector<std::uint32_t> multiplicity(p.statistic.rows);
    std::vector<double> values(p.statistic.values);
    kernel(std::vector<std::uint32_t>(p.statistic.rows, 1), values);
    const double t0 = values[p.value];
    std::vector<double> replicates;
    for (const auto& units :
         read_rows(folder_ / "data" / indices["index_file"].get<std::string>(), false)) {
      std::vector<std::uint32_t> times(p.plan->units(), 0);
      for (const double unit : units) {
        ++times[static_cast<std::size_t>(unit) - 1];
      }
      for (std::size_t row = 0; row < multiplicity.size(); ++row) {
        multiplicity[row] = times[p.plan->unit_of(row)];
      }
      kernel(multiplicity, values);
      replicates.push_back(values[p.value]);
    }
    ASSERT_EQ(replicates.size(), indices["R"].get<std::size_t>());
    double sum = 0.0;
    double squares = 0.0;
    for (const double t : replicates) {
      sum += t;
      squares += t * t;
    }
    for (std::size_t k = 0; k < indices["t_first"].size(); ++k) {
      expect("t", replicates[k], indices["t_first"][k], kJackknife);
    }
    expect("t", sum, indices["t_sum"], kJackknife);
    expect("t", squares, indices["t_ss"], kJackknife);
    const BootstrapDistribution distribution = bootstrap_distribution(replicates, t0);
    expect("z0",
           normal_quantile(static_cast<double>(distribution.below) /
                           static_cast<double>(replicates.size())),
           indices["z0"],
           kFromReplicates);
    expect_all(
        distribution, number(expected["jackknife"]["a_boot"]), 0.95, indices["conf95_with_L_jack"]);
    ++cases_run;
  }
  std::printf("boot golden cases run: %zu sets of resamples\n", cases_run);
  EXPECT_GT(cases_run, 0U);
}

TEST_F(BootGolden, OwnStreamWithinTheirMonteCarloError) {
  std::size_t cases_run = 0;
  for (const auto& [name, expected] : golden_.items()) {
    SCOPED_TRACE(name);
    const Problem p = problem(name, expected);
    const json& theirs = expected["monte_carlo"];
    BootstrapOptions options;
    options.replicates = theirs["R"];
    const BootstrapResult result = bootstrap(p.statistic, *p.plan, options);
    for (const auto& [method, key] : {std::pair{BootstrapMethod::bca, "bca95"},
                                      {BootstrapMethod::percentile, "percentile95"}}) {
      const BootstrapEstimate ours = bootstrap_estimate(result, p.value, 0.95, method);
      ASSERT_TRUE(ours.interval.has_value());
      EXPECT_TRUE(ours.conditions.empty());
      const std::string prefix = key;
      for (const auto& [end, at] : {std::pair{ours.interval->low, 0}, {ours.interval->high, 1}}) {
        const double sd = number(theirs[prefix + "_sd_across_seeds"][at]);
        const double off = std::abs(end - number(theirs[prefix + "_mean"][at])) / sd;
        EXPECT_LT(off, 4.0) << key << " end " << at;
        worst_[prefix + ", in their SDs"] = std::max(worst_[prefix + ", in their SDs"], off);
      }
    }
    // With fewer replicates than units boot has no acceleration.
    options.replicates = expected["R_less_than_n"]["R"];
    const BootstrapResult few = bootstrap(p.statistic, *p.plan, options);
    EXPECT_TRUE(bootstrap_estimate(few, p.value).interval.has_value());
    EXPECT_EQ(few.acceleration, result.acceleration);
    ++cases_run;
  }
  std::printf("boot golden cases run: %zu own streams\n", cases_run);
  EXPECT_GT(cases_run, 0U);
}

}  // namespace
}  // namespace tcert::statistics
