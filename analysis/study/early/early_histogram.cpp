#include "analysis/study/early/early_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <table/round_number.hpp>

namespace tcert::study {
namespace {

/// The whole number n with n width <= value < (n + 1) width, products as they are rounded.
double histogram_place(double value, double width) {
  double place = std::floor(value / width);
  while (place * width > value) {
    place -= 1.0;
  }
  while ((place + 1.0) * width <= value) {
    place += 1.0;
  }
  return place;
}

}  // namespace

std::vector<HistogramBin> early_histogram(const EarlyTrials& trials) {
  constexpr double kMostBins = 28.0;
  constexpr double kNarrowest = 1e-3;
  if (trials.size() == 0) {
    return {};
  }
  const auto [least, most] =
      std::minmax_element(trials.tc_early_m.begin(), trials.tc_early_m.end());
  // Not so narrow that the places of the bins could not be counted any more.
  const double finest = 1e-9 * std::max(std::abs(*least), std::abs(*most));
  const double width =
      table::round_number_from(std::max({(*most - *least) / kMostBins, kNarrowest, finest}));
  const double first = histogram_place(*least, width);
  std::vector<HistogramBin> bins(static_cast<std::size_t>(histogram_place(*most, width) - first) +
                                 1);
  for (std::size_t b = 0; b < bins.size(); ++b) {
    bins[b].low_m = (first + static_cast<double>(b)) * width;
    bins[b].high_m = (first + static_cast<double>(b + 1)) * width;
  }
  for (std::size_t i = 0; i < trials.size(); ++i) {
    HistogramBin& bin =
        bins[static_cast<std::size_t>(histogram_place(trials.tc_early_m[i], width) - first)];
    (trials.success[i] != 0 ? bin.successes : bin.failures) += 1;
  }
  return bins;
}

}  // namespace tcert::study
