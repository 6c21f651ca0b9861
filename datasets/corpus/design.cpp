#include "datasets/corpus/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <table/random.hpp>
#include <tcert/elementary.hpp>
#include <utility>

#include "datasets/corpus/purpose.hpp"

namespace tcert {
namespace {

constexpr double kCalibrationBiasSd = 0.004;

template <class T>
void shuffle(std::vector<T>& items, table::RandomStream& random) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[random.below(static_cast<std::uint32_t>(i))]);
  }
}

/// Standard normal distribution function by Marsaglia's series (2004). \pre |x| is moderate.
double normal_distribution(double x) {
  double sum = x;
  double term = x;
  for (double k = 3.0; sum + term != sum || k == 3.0; k += 2.0) {
    term *= x * x / k;
    sum += term;
  }
  return 0.5 + sum * elementary::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
}

/// Abscissa of the standard normal distribution function, by bisection: it is asked 22 times.
double normal_quantile(double p) {
  double low = -8.0;
  double high = 8.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (normal_distribution(middle) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Normal scores in random order rather than free draws: 22 draws would let the intraclass
/// correlation of a corpus wander with the seed.
std::vector<DayEffect> days_of_block(std::uint64_t seed, std::uint64_t block) {
  table::RandomStream random(seed, draws::kDayEffects, block);
  std::vector<double> levels(kDaysPerBlock);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i] =
        normal_quantile((static_cast<double>(i) + 0.5) / static_cast<double>(kDaysPerBlock));
  }
  shuffle(levels, random);
  std::vector<DayEffect> days(kDaysPerBlock);
  for (std::size_t i = 0; i < days.size(); ++i) {
    days[i] = {levels[i], kCalibrationBiasSd * random.normal()};
  }
  return days;
}

/// The trials of a block cell by cell, with a random choice of failures in each cell.
std::vector<TrialDesign> trials_by_cell(const CorpusOptions& options, std::uint64_t block) {
  table::RandomStream random(options.seed, draws::kOutcomes, block);
  std::vector<TrialDesign> trials;
  trials.reserve(kTrialsPerBlock);
  for (const Cell& cell : table_of_cells()) {
    std::vector<std::uint8_t> outcomes(cell.trials, 0);
    std::fill_n(outcomes.begin(), cell.successes, std::uint8_t{1});
    shuffle(outcomes, random);
    for (const std::uint8_t outcome : outcomes) {
      TrialDesign trial;
      trial.seed = options.seed;
      trial.algorithm = cell.algorithm;
      trial.lighting = cell.lighting;
      trial.success = outcome != 0;
      trial.effect = options.effect;
      trial.native_rates = options.native_rates;
      trials.push_back(trial);
    }
  }
  return trials;
}

/// Deals trials that lie cell by cell to the days, 22 at a time, each time in a new order of days.
std::vector<std::vector<std::size_t>> deal_to_days(std::size_t trials,
                                                   table::RandomStream& random) {
  std::vector<std::vector<std::size_t>> hands(kDaysPerBlock);
  std::vector<std::size_t> order(kDaysPerBlock);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < trials; ++i) {
    if (i % kDaysPerBlock == 0) {
      shuffle(order, random);
    }
    hands[order[i % kDaysPerBlock]].push_back(i);
  }
  for (auto& hand : hands) {
    shuffle(hand, random);
  }
  return hands;
}

}  // namespace

std::string_view name_of(Algorithm algorithm) noexcept {
  constexpr std::array<std::string_view, kAlgorithms> kNames{
      "CB-V", "M1", "M2", "M3", "TD*Lite", "TVFH"};
  return kNames[static_cast<std::size_t>(algorithm)];
}

std::string_view name_of(Lighting lighting) noexcept {
  constexpr std::array<std::string_view, kLightings> kNames{"Dark", "Indoor", "Outdoor"};
  return kNames[static_cast<std::size_t>(lighting)];
}

const std::array<Cell, kAlgorithms * kLightings>& table_of_cells() noexcept {
  using enum Algorithm;
  using enum Lighting;
  static constexpr std::array<Cell, kAlgorithms * kLightings> kTable{{
      {cb_v, dark, 60, 52},
      {cb_v, indoor, 30, 26},
      {cb_v, outdoor, 30, 23},
      {m1, dark, 30, 24},
      {m1, indoor, 30, 30},
      {m1, outdoor, 30, 26},
      {m2, dark, 30, 27},
      {m2, indoor, 30, 26},
      {m2, outdoor, 30, 25},
      {m3, dark, 60, 53},
      {m3, indoor, 60, 53},
      {m3, outdoor, 60, 52},
      {td_lite, dark, 30, 27},
      {td_lite, indoor, 30, 28},
      {td_lite, outdoor, 30, 28},
      {tvfh, dark, 30, 28},
      {tvfh, indoor, 30, 27},
      {tvfh, outdoor, 30, 28},
  }};
  return kTable;
}

void validate(const CorpusOptions& options) {
  if (options.trials < 1) {
    throw std::invalid_argument("trials: expected at least 1, found 0");
  }
  if (!(options.effect >= 0.0 && options.effect <= 2.0)) {
    throw std::invalid_argument(
        fmt::format("effect: expected a number in [0, 2], found {}", options.effect));
  }
  for (const std::uint64_t index : options.subset) {
    if (index >= options.trials) {
      throw std::invalid_argument(
          fmt::format("subset: expected indices below {}, the number of trials, found {}",
                      options.trials,
                      index));
    }
  }
}

std::vector<TrialDesign> design_block(const CorpusOptions& options, std::uint64_t block) {
  const std::vector<TrialDesign> by_cell = trials_by_cell(options, block);
  const std::vector<DayEffect> days = days_of_block(options.seed, block);
  table::RandomStream random(options.seed, draws::kDays, block);
  const auto hands = deal_to_days(by_cell.size(), random);
  std::vector<TrialDesign> trials;
  trials.reserve(by_cell.size());
  for (std::size_t day = 0; day < hands.size(); ++day) {
    for (const std::size_t i : hands[day]) {
      TrialDesign trial = by_cell[i];
      trial.index = block * kTrialsPerBlock + trials.size();
      trial.day = block * kDaysPerBlock + day;
      trial.day_level = days[day].level;
      trial.day_calibration_m = days[day].calibration_m;
      trials.push_back(trial);
    }
  }
  return trials;
}

DayEffect day_effect(std::uint64_t seed, std::uint64_t day) {
  return days_of_block(seed, day / kDaysPerBlock)[day % kDaysPerBlock];
}

TrialDesign design_trial(const CorpusOptions& options, std::uint64_t index) {
  return design_block(options, index / kTrialsPerBlock)[index % kTrialsPerBlock];
}

std::string trial_name(std::uint64_t index) { return fmt::format("t{:07}", index); }

}  // namespace tcert
