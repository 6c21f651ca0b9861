// One estimation, timed in process on a CSV file that is read before: our side of
// scripts/compare_with_r, which holds the same estimations in R.
//
//     compare_with_r make ROWS FILE            writes simulated trials, 30 a day
//     compare_with_r JOB FILE [THREADS [REPLICATES]]
//
// A job prints: side,job,rows,threads,seconds,cpu_seconds,peak_mb,first,second. Seconds, by the
// wall and of the processor, are medians of the repetitions, from the formula to the numbers. The
// peak is the resident memory from after the reading on, the table included. The last two are
// numbers of the result, to see that both sides have done the same.

#include <malloc.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <statistics/concordance/concordance.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/cox/cox.hpp>
#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/glmm_profile.hpp>
#include <statistics/model/formula.hpp>
#include <statistics/model/model_frame.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <statistics/survival/log_rank.hpp>
#include <statistics/survival/survival_curve.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <stdexcept>
#include <string>
#include <table/random.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "support/data_table.hpp"

namespace {

using namespace tcert;
using namespace tcert::statistics;
using namespace tcert::table;

using Numbers = std::pair<double, double>;
using Job = std::function<Numbers(const DataTable&, std::size_t)>;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

constexpr std::size_t kTrialsOfDay = 30;

struct Day {
  double frailty = 0.0;
  std::array<std::size_t, kTrialsOfDay> lighting{};  // Ten trials of each, in random order.
};

Day random_day(RandomStream& random) {
  Day day;
  day.frailty = 0.6 * random.normal();
  for (std::size_t trial = 0; trial < kTrialsOfDay; ++trial) {
    day.lighting[trial] = trial % 3;
  }
  for (std::size_t left = kTrialsOfDay; left > 1; --left) {
    std::swap(day.lighting[left - 1], day.lighting[random.below(static_cast<std::uint32_t>(left))]);
  }
  return day;
}

/// Succeeds or runs to the limit of 60 s; times to success on the 0.1 s grid of a log.
void write_trial(std::FILE* file, RandomStream& random, const Day& day, std::size_t row) {
  static constexpr std::array kNames{"bright", "dim", "dark"};
  static constexpr std::array kOddsOf{0.35, 0.0, -0.7};
  static constexpr std::array kHazardOf{0.2, 0.0, -0.4};
  const std::size_t lighting = day.lighting[row % kTrialsOfDay];
  const double x1 = random.normal();
  const double x2 = 0.6 * x1 + 0.8 * random.normal();
  const double x3 = -std::log(random.uniform()) - std::log(random.uniform());
  const int x4 = random.uniform() < 0.4 ? 1 : 0;
  const double odds =
      2.45 + kOddsOf[lighting] + 0.8 * x1 + 0.25 * x2 - 0.15 * (x3 - 2.0) + day.frailty;
  const bool success = random.uniform() < 1.0 / (1.0 + std::exp(-odds));
  const double hazard =
      0.5 * x1 + 0.15 * x2 - 0.1 * (x3 - 2.0) + kHazardOf[lighting] + 0.5 * day.frailty;
  const double latent = 12.0 * std::pow(-std::log(random.uniform()) * std::exp(-hazard), 1.0 / 1.4);
  std::fprintf(file,
               "%zu,d%07zu,%s,%.4f,%.4f,%.4f,%d,%d,%.1f\n",
               row + 1,
               row / kTrialsOfDay + 1,
               kNames[lighting],
               x1,
               x2,
               x3,
               x4,
               success ? 1 : 0,
               success ? std::clamp(latent, 0.1, 59.9) : 60.0);
}

void write_trials(std::size_t rows, const char* path) {
  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path, "w"));
  if (!file) {
    throw std::runtime_error(std::string("cannot write ") + path);
  }
  std::fputs("trial,day,lighting,x1,x2,x3,x4,success,time\n", file.get());
  RandomStream random(20671, 0, rows);
  Day day;
  for (std::size_t row = 0; row < rows; ++row) {
    if (row % kTrialsOfDay == 0) {
      day = random_day(random);
    }
    write_trial(file.get(), random, day, row);
  }
}

ModelFrame frame_of(const DataTable& table,
                    const std::string& formula,
                    RightSide side = RightSide::design) {
  FrameOptions options;
  options.right_side = side;
  return model_frame(parse_formula(formula), table, options);
}

/// Coefficient of x1 and its standard error, robust if there are clusters.
Job cox(Ties ties, const std::string& rest) {
  return [ties, rest](const DataTable& table, std::size_t) -> Numbers {
    const CoxData data =
        cox_data(frame_of(table, "Surv(time, success) ~ x1 + x2 + x3 + x4 + " + rest));
    CoxOptions options;
    options.ties = ties;
    const CoxFit fit = fit_cox(data, options);
    const CoxCoefficient& x1 = fit.coefficients.at(0);
    return {x1.estimate.value(), fit.robust ? x1.robust_se.value() : x1.model_se.value()};
  };
}

GlmmInput trials_by_day(const DataTable& table) {
  return glmm_input(frame_of(table, "success ~ x1 + x2 + x3 + x4 + lighting + (1 | day)"));
}

GlmmOptions by_points(int quadrature) {
  GlmmOptions options;
  options.quadrature = quadrature;
  return options;
}

/// The standard deviation between days and the standard error of x1.
Job glmm(int quadrature) {
  return [quadrature](const DataTable& table, std::size_t) -> Numbers {
    const GlmmFit fit = fit_glmm(trials_by_day(table), by_points(quadrature));
    return {fit.random.at(0).sd[0], fit.coefficients.at(1).standard_error.value()};
  };
}

/// Ends of the profile interval of x1; all parameters are profiled.
Numbers glmm_profiles(const DataTable& table, std::size_t) {
  const GlmmProfile profile = glmm_profile(trials_by_day(table), by_points(1));
  return {profile.coefficients.at(1).value().low, profile.coefficients.at(1).value().high};
}

/// C and its standard error.
Numbers concordance_of_x1(const DataTable& table, std::size_t) {
  const ModelFrame frame = frame_of(table, "Surv(time, success) ~ x1");
  const std::span<const double> x1(frame.design.col(1).data(), frame.size());
  const std::vector<Predictor> predictors{{"x1", x1, LargerMeans::shorter_time}};
  const ConcordanceResult result =
      concordance(std::get<SurvivalOutcome>(frame.outcome), predictors);
  return {result.estimates[0].c.value(), result.estimates[0].std_error.value()};
}

/// Survival in bright light just after 10 s and its standard error.
Numbers kaplan_meier(const DataTable& table, std::size_t) {
  const ModelFrame frame = frame_of(table, "Surv(time, success) ~ lighting", RightSide::groups);
  CurveOptions options;
  options.groups = &*frame.groups;
  const auto curves = survival_curves(std::get<SurvivalOutcome>(frame.outcome), options);
  const SurvivalPoint* const point = curves.at(0).at(10.0);
  return {point->survival, point->std_error()};
}

/// Chi-squared and its degrees of freedom.
Numbers log_rank(const DataTable& table, std::size_t) {
  const ModelFrame frame = frame_of(table, "Surv(time, success) ~ lighting", RightSide::groups);
  const LogRankTest test = log_rank_test(std::get<SurvivalOutcome>(frame.outcome), *frame.groups);
  return {test.chi_squared.value(), static_cast<double>(test.df)};
}

std::span<const double> column(const DataTable& table, const char* name) {
  return table.find(name)->numbers;
}

std::vector<std::uint8_t> successes(const DataTable& table) {
  const std::span<const double> success = column(table, "success");
  std::vector<std::uint8_t> result(success.size());
  std::transform(success.begin(), success.end(), result.begin(), [](double value) {
    return static_cast<std::uint8_t>(value == 1.0);
  });
  return result;
}

/// Ends of the BCa interval of the third value.
Numbers bca(const Statistic& statistic, std::size_t rows, std::size_t replicates) {
  const BootstrapResult result =
      bootstrap(statistic, ResamplingPlan::of_rows(rows), {replicates, 1, 0});
  const Interval interval = bootstrap_estimate(result, 2).interval.value();
  return {interval.low, interval.high};
}

Numbers bca_of_auc_difference(const DataTable& table, std::size_t replicates) {
  const std::vector<Score> scores{{column(table, "x1"), HigherMeans::success},
                                  {column(table, "x2"), HigherMeans::success}};
  return bca(auc_statistic(scores, successes(table), {{0, 1}}), table.rows, replicates);
}

Numbers bca_of_c_difference(const DataTable& table, std::size_t replicates) {
  const std::span<const double> time = column(table, "time");
  SurvivalOutcome outcome{{}, {time.begin(), time.end()}, successes(table)};
  round_times(outcome);
  const std::vector<Predictor> predictors{{"x1", column(table, "x1"), LargerMeans::shorter_time},
                                          {"x2", column(table, "x2"), LargerMeans::shorter_time}};
  return bca(concordance_statistic(outcome, predictors, {{0, 1}}), table.rows, replicates);
}

/// AUC and C of x1, all of H1's numbers made beside them; without a cluster a trial is its own.
Job h1(const std::string& cluster) {
  return [cluster](const DataTable& table, std::size_t replicates) -> Numbers {
    study::H1Options options;
    options.predictors = {{"x1", HigherMeans::success, ""},
                          {"x2", HigherMeans::success, ""},
                          {"x3", HigherMeans::failure, ""},
                          {"x4", HigherMeans::success, ""}};
    options.time = "time";
    options.cluster = cluster;
    options.within = {"lighting"};
    options.replicates = replicates;
    const study::H1Row row = study::hypothesis_h1(table, options).panels.at(0).rows.at(0);
    return {row.auc.value.value(), row.c.value.value()};
  };
}

const std::map<std::string, Job>& jobs() {
  static const std::map<std::string, Job> all{
      {"cox_efron", cox(Ties::efron, "lighting")},
      {"cox_efron_cluster", cox(Ties::efron, "lighting + cluster(day)")},
      {"cox_breslow", cox(Ties::breslow, "lighting")},
      {"cox_real", cox(Ties::efron, "strata(lighting)")},
      {"cox_real_cluster", cox(Ties::efron, "strata(lighting) + cluster(day)")},
      {"concordance", concordance_of_x1},
      {"kaplan_meier", kaplan_meier},
      {"log_rank", log_rank},
      {"glmm_laplace", glmm(1)},
      {"glmm_agq25", glmm(25)},
      {"glmm_profile", glmm_profiles},
      {"auc_bca", bca_of_auc_difference},
      {"c_bca", bca_of_c_difference},
      {"h1_days", h1("day")},
      {"h1_trials", h1("")},
  };
  return all;
}

/// Free memory is given back and the peak of the process forgotten, where the system can do that.
void reset_peak_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes / 1024.0;
    }
  }
  return std::nan("");
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

struct Seconds {
  double wall = 0.0;
  double cpu = 0.0;  ///< Of all threads.
};

/// Medians: once, and again until it has taken half a second.
Seconds timed(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> wall;
  std::vector<double> cpu;
  double total = 0.0;
  while (total < 0.5) {
    const Clock::time_point start = Clock::now();
    const std::clock_t cpu_start = std::clock();
    work();
    cpu.push_back(static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC);
    wall.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    total += wall.back();
  }
  return {median(wall), median(cpu)};
}

void run_job(const std::string& name,
             const char* path,
             std::size_t threads,
             std::size_t replicates) {
  const Job& job = jobs().at(name);
  const DataTable table = test_support::table_of_file(path);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  reset_peak_memory();
  Numbers numbers;
  const Seconds seconds = timed([&] { numbers = job(table, replicates); });
  std::printf("ours,%s,%zu,%zu,%.6g,%.6g,%.1f,%.7g,%.7g\n",
              name.c_str(),
              table.rows,
              threads,
              seconds.wall,
              seconds.cpu,
              peak_megabytes(),
              numbers.first,
              numbers.second);
}

int usage() {
  std::fputs(
      "usage: compare_with_r make ROWS FILE\n"
      "       compare_with_r JOB FILE [THREADS=1 [REPLICATES=10000]]\n"
      "jobs:",
      stderr);
  for (const auto& [name, job] : jobs()) {
    std::fprintf(stderr, " %s", name.c_str());
  }
  std::fputs("\n", stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 3 && words[0] == "make") {
      write_trials(std::stoul(words[1]), argv[3]);
      return 0;
    }
    if (words.size() < 2 || words.size() > 4 || !jobs().contains(words[0])) {
      return usage();
    }
    run_job(words[0],
            argv[2],
            words.size() > 2 ? std::stoul(words[2]) : 1,
            words.size() > 3 ? std::stoul(words[3]) : 10'000);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_with_r: %s\n", error.what());
    return 1;
  }
}
