#include <statistics/clusters/wild_bootstrap.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <table/random.hpp>

namespace tcert::statistics {
namespace {

/// Mean 0 and variance 1.
double weight(table::RandomStream& random, std::size_t clusters) {
  if (clusters >= kFewForRademacher) {
    return random.below(2) == 0 ? -1.0 : 1.0;
  }
  static const std::array<double, 6> webb{
      -std::sqrt(1.5), -1.0, -std::sqrt(0.5), std::sqrt(0.5), 1.0, std::sqrt(1.5)};
  return webb[random.below(6)];
}

/// What the statistic of a coefficient is made of: its functional along the scores, and along what
/// an estimate takes from each cluster's score.
struct Along {
  Eigen::VectorXd score;  ///< G: c' v_g.
  Eigen::MatrixXd share;  ///< G x r: c' S_g.
};

Along along(const SandwichParts& parts, std::size_t k) {
  const Eigen::VectorXd functional = parts.functionals.col(static_cast<Eigen::Index>(k));
  Along result;
  result.score = parts.scores.transpose() * functional;
  result.share.resize(static_cast<Eigen::Index>(parts.clusters()), functional.size());
  for (std::size_t g = 0; g < parts.clusters(); ++g) {
    result.share.row(static_cast<Eigen::Index>(g)) = functional.transpose() * parts.shares[g];
  }
  return result;
}

double squared_t(const SandwichParts& parts, const Along& of, const Eigen::VectorXd& weights) {
  const Eigen::VectorXd estimate = parts.scores * weights;
  const double along_it = of.score.dot(weights);
  const double variance = (of.score.cwiseProduct(weights) - of.share * estimate).squaredNorm();
  return along_it * along_it / variance;
}

}  // namespace

double wild_t_squared(const SandwichParts& parts, std::size_t k, const Eigen::VectorXd& weights) {
  return squared_t(parts, along(parts, k), weights);
}

std::optional<double> wild_p_value(const SandwichParts& parts,
                                   std::size_t k,
                                   const WildOptions& options) {
  const auto clusters = static_cast<Eigen::Index>(parts.clusters());
  const Along of = along(parts, k);
  const double observed = squared_t(parts, of, Eigen::VectorXd::Ones(clusters));
  if (clusters < 2 || !std::isfinite(observed)) {
    return std::nullopt;
  }
  // All weights of one sign give what was observed, but for rounding.
  const double threshold = observed * (1.0 - 1e-9);
  std::size_t as_large = 0;
  Eigen::VectorXd weights(clusters);
  for (std::size_t replicate = 0; replicate < options.replicates; ++replicate) {
    table::RandomStream random(options.seed, options.analysis, replicate);
    for (double& one : weights) {
      one = weight(random, parts.clusters());
    }
    as_large += squared_t(parts, of, weights) >= threshold ? 1U : 0U;
  }
  return (1.0 + static_cast<double>(as_large)) / (1.0 + static_cast<double>(options.replicates));
}

namespace {

/// The first value on a side, in standard errors from the estimate, that `rejected` holds of;
/// infinite if none within reach does. Empty where it has no answer on the way.
std::optional<double> first_rejected(
    const std::function<std::optional<bool>(double distance)>& rejected) {
  constexpr double kReach = 30.0;
  constexpr double kExactness = 1e-3;
  double inside = 0.0;
  double outside = 2.0;
  for (std::optional<bool> out = rejected(outside); !out || !*out; out = rejected(outside)) {
    if (!out) {
      return std::nullopt;
    }
    inside = outside;
    outside *= 1.5;
    if (outside > kReach) {
      return std::numeric_limits<double>::infinity();
    }
  }
  while (outside - inside > kExactness) {
    const double middle = 0.5 * (inside + outside);
    const std::optional<bool> out = rejected(middle);
    if (!out) {
      return std::nullopt;
    }
    (*out ? outside : inside) = middle;
  }
  return 0.5 * (inside + outside);
}

}  // namespace

std::optional<Interval> wild_interval(const PartsAt& parts_at,
                                      std::size_t k,
                                      double estimate,
                                      double standard_error,
                                      const WildOptions& options) {
  if (!(standard_error > 0.0)) {
    return std::nullopt;
  }
  const auto distance_to = [&](double side) {
    return first_rejected([&](double distance) -> std::optional<bool> {
      const std::optional<SandwichParts> parts =
          parts_at(k, estimate + side * distance * standard_error);
      const auto p = parts ? wild_p_value(*parts, k, options) : std::nullopt;
      return p ? std::optional(*p <= 1.0 - options.level) : std::nullopt;
    });
  };
  const std::optional<double> down = distance_to(-1.0);
  const std::optional<double> up = distance_to(1.0);
  if (!down || !up) {
    return std::nullopt;
  }
  return Interval{
      estimate - *down * standard_error, estimate + *up * standard_error, options.level};
}

}  // namespace tcert::statistics
