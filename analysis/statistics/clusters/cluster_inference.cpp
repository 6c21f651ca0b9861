#include <statistics/clusters/cluster_inference.hpp>

#include <cmath>
#include <statistics/clusters/cluster_variance.hpp>

namespace tcert::statistics {
namespace {

struct Spread {
  Eigen::MatrixXd covariance;
  Eigen::VectorXd df;
};

Spread spread_of(const ClusteredFit& fit, ClusterInference inference) {
  const auto groups = static_cast<double>(fit.parts.clusters());
  const Eigen::Index p = fit.parts.estimates.size();
  Spread spread{{}, Eigen::VectorXd::Constant(p, groups - 1.0)};
  switch (inference) {
    case ClusterInference::cr1:
    case ClusterInference::wild:
      spread.covariance = groups / (groups - 1.0) * sandwich_cr0(fit.parts);
      break;
    case ClusterInference::cr2:
      spread.covariance = sandwich_cr2(fit.parts);
      spread.df = satterthwaite_df(fit.parts);
      break;
    case ClusterInference::jackknife:
      break;  // See by_jackknife().
  }
  return spread;
}

void by_wild_bootstrap(const ClusteredFit& fit,
                       std::size_t k,
                       const WildOptions& options,
                       ClusterT& estimate) {
  estimate.df.reset();
  estimate.p_value.reset();
  estimate.interval.reset();
  const auto null = fit.parts_at(k, 0.0);
  estimate.p_value = null ? wild_p_value(*null, k, options) : std::nullopt;
  if (estimate.standard_error) {
    estimate.interval = wild_interval(fit.parts_at,
                                      k,
                                      fit.parts.estimates(static_cast<Eigen::Index>(k)),
                                      *estimate.standard_error,
                                      options);
  }
}

std::string causes_of(const Eigen::VectorXd& estimates,
                      const LeftOut& left_out,
                      std::span<const std::string> names) {
  constexpr std::size_t kNamed = 3;
  std::string words;
  std::size_t lacking = 0;
  for (std::size_t g = 0; g < names.size(); ++g) {
    const auto column = left_out.values.col(static_cast<Eigen::Index>(g)).array();
    if ((column.isFinite() || !estimates.array().isFinite()).all()) {
      continue;
    }
    if (++lacking <= kNamed) {
      words += (lacking == 1 ? "without '" : "; without '") + names[g] +
               "': " + (left_out.causes[g].empty() ? "no estimate" : left_out.causes[g]);
    }
  }
  return lacking > kNamed ? words + "; and " + std::to_string(lacking - kNamed) + " more" : words;
}

}  // namespace

std::vector<std::string> cluster_names(const table::Factor& cluster,
                                       std::span<const std::uint32_t> codes,
                                       const CompactCodes& compact) {
  std::vector<std::string> names(compact.count);
  for (std::size_t row = 0; row < codes.size(); ++row) {
    names[compact.codes[row]] = cluster.levels.at(codes[row]);
  }
  return names;
}

std::string_view to_string(ClusterInference inference) noexcept {
  switch (inference) {
    case ClusterInference::cr1:
      return "cr1";
    case ClusterInference::cr2:
      return "cr2";
    case ClusterInference::jackknife:
      return "jackknife";
    case ClusterInference::wild:
      return "wild";
  }
  return "";
}

double jackknife_variance(double estimate, const Eigen::VectorXd& left_out) {
  const auto groups = static_cast<double>(left_out.size());
  return (groups - 1.0) / groups * (left_out.array() - estimate).square().sum();
}

Eigen::MatrixXd jackknife_covariance(const Eigen::VectorXd& estimates,
                                     const Eigen::MatrixXd& left_out) {
  const auto groups = static_cast<double>(left_out.cols());
  const Eigen::MatrixXd changes = left_out.colwise() - estimates;
  return (groups - 1.0) / groups * changes * changes.transpose();
}

ClusterT jackknife_estimate(double estimate, std::span<const double> left_out, double level) {
  const Eigen::Map<const Eigen::VectorXd> values(left_out.data(),
                                                 static_cast<Eigen::Index>(left_out.size()));
  return by_student_t(estimate,
                      std::sqrt(jackknife_variance(estimate, values)),
                      static_cast<double>(left_out.size()) - 1.0,
                      level);
}

std::optional<Condition> too_much_to_leave_out(std::size_t clusters, std::size_t rows) {
  if (static_cast<double>(clusters) * static_cast<double>(rows) <= kMostLeftOutRows) {
    return std::nullopt;
  }
  return Condition{ConditionKind::no_jackknife,
                   ConditionSeverity::warning,
                   "",
                   std::to_string(clusters) + " clusters of " + std::to_string(rows) +
                       " rows: no intervals by leaving them out in turn",
                   "name fewer and larger clusters"};
}

ClusterT cr1_estimate(const std::optional<double>& estimate,
                      const std::optional<double>& robust_error,
                      std::size_t clusters,
                      double level) {
  if (!estimate || !robust_error || clusters < 2) {
    return {};
  }
  const auto groups = static_cast<double>(clusters);
  return by_student_t(
      *estimate, *robust_error * std::sqrt(groups / (groups - 1.0)), groups - 1.0, level);
}

ClusterInference default_inference(std::size_t clusters) noexcept {
  return clusters > kMostJackknifeClusters ? ClusterInference::cr1 : ClusterInference::jackknife;
}

ClusterInferences by_jackknife(const Eigen::VectorXd& estimates,
                               LeftOut left_out,
                               std::span<const std::string> names,
                               double level) {
  ClusterInferences all;
  all.by = ClusterInference::jackknife;
  all.of.resize(static_cast<std::size_t>(estimates.size()));
  if (names.size() < 2) {
    return all;
  }
  all.covariance = jackknife_covariance(estimates, left_out.values);
  for (std::size_t k = 0; k < all.of.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    all.of[k] = by_student_t(estimates(at),
                             std::sqrt(all.covariance(at, at)),
                             static_cast<double>(names.size()) - 1.0,
                             level);
  }
  if (std::string causes = causes_of(estimates, left_out, names); !causes.empty()) {
    all.conditions.push_back(
        {ConditionKind::no_jackknife,
         ConditionSeverity::warning,
         "",
         std::move(causes),
         "the coefficients that it lacks have no t columns; take --inference cr1 or cr2, or fewer "
         "terms"});
  }
  all.left_out = std::move(left_out);
  return all;
}

ClusterInferences not_to_be_had(ClusterInference asked,
                                std::size_t coefficients,
                                const std::string& why) {
  ClusterInferences none;
  none.by = asked;
  none.of.resize(coefficients);
  none.conditions.push_back({ConditionKind::no_robust_variance,
                             ConditionSeverity::warning,
                             "",
                             std::string(to_string(asked)) + ": " + why,
                             "the t columns are NA; take another --inference"});
  return none;
}

ClusterInferences cluster_inferences(const ClusteredFit& fit,
                                     std::optional<ClusterInference> inference,
                                     const WildOptions& options) {
  ClusterInferences all;
  all.by = inference.value_or(default_inference(fit.parts.clusters()));
  if (all.by == ClusterInference::jackknife && fit.parts.clusters() > 1) {
    return by_jackknife(fit.parts.estimates, fit.left_out(), fit.names, options.level);
  }
  all.of.resize(static_cast<std::size_t>(fit.parts.estimates.size()));
  if (fit.parts.clusters() < 2) {
    return all;
  }
  const Spread spread = spread_of(fit, all.by);
  all.covariance = spread.covariance;
  for (std::size_t k = 0; k < all.of.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    all.of[k] = by_student_t(
        fit.parts.estimates(at), std::sqrt(all.covariance(at, at)), spread.df(at), options.level);
    if (all.by == ClusterInference::wild && std::isfinite(fit.parts.estimates(at))) {
      by_wild_bootstrap(fit, k, options, all.of[k]);
    }
  }
  return all;
}

}  // namespace tcert::statistics
