#include "analysis/study/h3/rates_of_advance.hpp"

#include <table/not_a_number.hpp>

#include "analysis/study/replay/replay.hpp"

namespace tcert::study {
namespace {

double rate(double length_m, double time_s) {
  return rate_of_advance(length_m, time_s).value_or(table::kNaN);
}

/// Metres and seconds of both algorithms.
struct SumsOfBoth {
  double length = 0.0;
  double time = 0.0;
  double baseline_length = 0.0;
  double baseline_time = 0.0;

  void add(bool baseline, double more_length, double more_time) {
    (baseline ? baseline_length : length) += more_length;
    (baseline ? baseline_time : time) += more_time;
  }
};

/// The baseline's rate at the gated algorithm's mix of lightings by length; NaN where it has none.
double standardised_rate(std::span<const SumsOfBoth> by_lighting) {
  double length = 0.0;
  double time = 0.0;
  for (const SumsOfBoth& sums : by_lighting) {
    if (sums.length > 0.0) {
      length += sums.length;
      time += sums.length * 60.0 / rate(sums.baseline_length, sums.baseline_time);
    }
  }
  return rate(length, time);
}

}  // namespace

void rates(const Advance& advance,
           std::span<const std::uint32_t> multiplicity,
           std::span<double> values) {
  std::vector<SumsOfBoth> by_lighting(advance.lightings);
  SumsOfBoth all;
  for (std::size_t i = 0; i < advance.length.size(); ++i) {
    const double times = multiplicity[i];
    for (SumsOfBoth* const sums : {&all, &by_lighting[advance.lighting[i]]}) {
      sums->add(advance.baseline[i] != 0, times * advance.length[i], times * advance.time[i]);
    }
  }
  const double length = all.length;
  values[value_ungated] = rate(length, all.time);
  values[value_baseline] = rate(all.baseline_length, all.baseline_time);
  values[value_standardised] = standardised_rate(by_lighting);
  values[value_gap] = values[value_standardised] - values[value_ungated];
  values[value_gap_as_run] = values[value_baseline] - values[value_ungated];
  for (std::size_t c = 0; c < advance.gated_time.size(); ++c) {
    double gated_time = 0.0;
    for (std::size_t i = 0; i < advance.length.size(); ++i) {
      gated_time += advance.baseline[i] != 0 ? 0.0 : multiplicity[i] * advance.gated_time[c][i];
    }
    const std::span<double> of_case = values.subspan(group_values + c * case_values, case_values);
    of_case[value_gated] = rate(length, gated_time);
    of_case[value_gain] = of_case[value_gated] - values[value_ungated];
    of_case[value_gain_share] = of_case[value_gated] / values[value_ungated] - 1.0;
    of_case[value_recovered] = of_case[value_gain] / values[value_gap];
  }
}

}  // namespace tcert::study
