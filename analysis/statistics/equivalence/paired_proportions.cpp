#include <statistics/equivalence/paired_proportions.hpp>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <statistics/basics/normal.hpp>
#include <statistics/basics/student_t.hpp>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {

double mcnemar_exact_p(std::size_t lost, std::size_t won) {
  const std::size_t differing = lost + won;
  if (differing == 0) {
    return 1.0;
  }
  const boost::math::binomial_distribution<double> fair(static_cast<double>(differing), 0.5);
  const double tail = boost::math::cdf(fair, static_cast<double>(std::min(lost, won)));
  return std::min(1.0, 2.0 * tail);
}

std::optional<ClusteredMean> clustered_mean(std::span<const double> differences,
                                            std::span<const std::uint32_t> clusters,
                                            double level) {
  if (differences.size() != clusters.size()) {
    throw std::invalid_argument("a clustered mean: as many clusters as differences are needed");
  }
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a clustered mean: level must be in (0, 1)");
  }
  if (differences.empty()) {
    return std::nullopt;
  }
  const auto n = static_cast<double>(differences.size());
  ClusteredMean mean;
  for (const double one : differences) {
    mean.value += one;
  }
  mean.value /= n;  // of whole numbers the sum is exact, and nothing varies where nothing does
  std::vector<double> sums(*std::ranges::max_element(clusters) + std::size_t{1}, 0.0);
  std::vector<std::uint8_t> is_there(sums.size(), 0);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    sums[clusters[i]] += differences[i] - mean.value;
    is_there[clusters[i]] = 1;
  }
  mean.clusters = static_cast<std::size_t>(std::ranges::count(is_there, std::uint8_t{1}));
  if (mean.clusters < 2) {
    return mean;
  }
  double squares = 0.0;
  for (const double sum : sums) {
    squares += sum * sum;
  }
  const auto g = static_cast<double>(mean.clusters);
  mean.standard_error = std::sqrt(squares * g / (g - 1.0)) / n;
  mean.interval = by_cluster_t(mean.value, mean.standard_error, {}, mean.clusters, level).interval;
  return mean;
}

std::optional<std::size_t> pairs_for_non_inferiority(double discordant,
                                                     double margin,
                                                     double alpha,
                                                     double power) {
  const auto is_share = [](double x) { return x > 0.0 && x < 1.0; };
  if (!(discordant >= 0.0 && discordant <= 1.0) || !(margin > 0.0 && margin <= 1.0) ||
      !is_share(alpha) || !is_share(power)) {
    throw std::invalid_argument("pairs for non-inferiority: a share is out of its range");
  }
  if (discordant == 0.0) {
    return std::nullopt;
  }
  const double z = normal_quantile(1.0 - alpha) + normal_quantile(power);
  return static_cast<std::size_t>(std::ceil(z * z * discordant / (margin * margin)));
}

}  // namespace tcert::statistics
