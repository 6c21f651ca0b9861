#include <statistics/calibration/calibration_bins.hpp>

#include <algorithm>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/quantile.hpp>

namespace tcert::statistics {
namespace {

/// Quantiles 0, 1/g, ..., 1, each once.
std::vector<double> cuts_of(const std::vector<double>& probability, std::size_t bins) {
  std::vector<double> cuts;
  for (std::size_t k = 0; k <= bins; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(bins);
    cuts.push_back(quantile(probability, share).value());
  }
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// Bins without trials, one at least.
std::vector<CalibrationBin> empty_bins(const std::vector<double>& cuts) {
  std::vector<CalibrationBin> bins;
  CalibrationBin bin;
  bin.low = cuts.front();
  bin.high = cuts.front();
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    bin.high = cuts[k];
    bins.push_back(bin);
    bin.low = cuts[k];
  }
  if (bins.empty()) {
    bins.push_back(bin);
  }
  return bins;
}

void count_clusters(const CalibrationRows& rows,
                    const std::vector<std::size_t>& bin_of,
                    std::vector<CalibrationBin>& bins) {
  for (std::size_t k = 0; k < bins.size() && !rows.cluster.empty(); ++k) {
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < bin_of.size(); ++i) {
      if (bin_of[i] == k) {
        found.push_back(rows.cluster[i]);
      }
    }
    std::sort(found.begin(), found.end());
    bins[k].clusters =
        static_cast<std::size_t>(std::unique(found.begin(), found.end()) - found.begin());
  }
}

}  // namespace

std::vector<std::size_t> bin_of_rows(std::span<const double> probability,
                                     std::span<const CalibrationBin> bins) {
  std::vector<std::size_t> bin_of;
  bin_of.reserve(probability.size());
  for (const double p : probability) {
    const auto found =
        std::lower_bound(bins.begin(), bins.end(), p, [](const CalibrationBin& bin, double value) {
          return bin.high < value;
        });
    bin_of.push_back(static_cast<std::size_t>(found - bins.begin()));
  }
  return bin_of;
}

std::vector<CalibrationBin> calibration_bins(const CalibrationRows& rows,
                                             const CalibrationOptions& options) {
  std::vector<CalibrationBin> bins = empty_bins(cuts_of(rows.probability, options.bins));
  const std::vector<std::size_t> bin_of = bin_of_rows(rows.probability, bins);
  for (std::size_t i = 0; i < bin_of.size(); ++i) {
    CalibrationBin& bin = bins[bin_of[i]];
    ++bin.trials;
    bin.events += rows.outcome[i] == 1.0 ? 1 : 0;
    bin.predicted += rows.probability[i];
  }
  count_clusters(rows, bin_of, bins);
  // Interpolated cuts can leave a bin between two neighbouring values empty.
  std::erase_if(bins, [](const CalibrationBin& bin) { return bin.trials == 0; });
  for (CalibrationBin& bin : bins) {
    const auto trials = static_cast<double>(bin.trials);
    bin.predicted /= trials;
    bin.observed = static_cast<double>(bin.events) / trials;
    bin.wilson = wilson(bin.events, bin.trials, options.level);
  }
  return bins;
}

BrierParts brier_parts(const CalibrationRows& rows, std::span<const CalibrationBin> bins) {
  const std::vector<std::size_t> bin_of = bin_of_rows(rows.probability, bins);
  BrierParts parts;
  double events = 0.0;
  for (std::size_t i = 0; i < bin_of.size(); ++i) {
    const CalibrationBin& bin = bins[bin_of[i]];
    const double p = rows.probability[i];
    const double y = rows.outcome[i];
    parts.score += (p - y) * (p - y);
    parts.within_variance += (p - bin.predicted) * (p - bin.predicted);
    parts.within_covariance += 2.0 * (p - bin.predicted) * (y - bin.observed);
    events += y;
  }
  const auto n = static_cast<double>(bin_of.size());
  const double share = events / n;
  for (const CalibrationBin& bin : bins) {
    const auto trials = static_cast<double>(bin.trials);
    parts.reliability += trials * (bin.predicted - bin.observed) * (bin.predicted - bin.observed);
    parts.resolution += trials * (bin.observed - share) * (bin.observed - share);
  }
  for (double* const part : {&parts.score,
                             &parts.within_variance,
                             &parts.within_covariance,
                             &parts.reliability,
                             &parts.resolution}) {
    *part /= n;
  }
  parts.uncertainty = share * (1.0 - share);
  return parts;
}

std::optional<ChiSquareTest> hosmer_lemeshow(std::span<const CalibrationBin> bins) {
  if (bins.size() < 3) {
    return std::nullopt;
  }
  double statistic = 0.0;
  for (const CalibrationBin& bin : bins) {
    if (!(bin.predicted > 0.0 && bin.predicted < 1.0)) {
      return std::nullopt;
    }
    const double difference = bin.observed - bin.predicted;
    statistic += static_cast<double>(bin.trials) * difference * difference /
                 (bin.predicted * (1.0 - bin.predicted));
  }
  return chi_square_test(statistic, bins.size() - 2);
}

}  // namespace tcert::statistics
