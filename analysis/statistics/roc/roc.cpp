#include <statistics/roc/roc.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/complete_rows.hpp>
#include <statistics/basics/few_clusters.hpp>
#include <statistics/basics/normal.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace tcert::statistics {
namespace {

/// Conditions of the classes alone; one that is an error means that there is no AUC.
Conditions class_conditions(const CompleteRows& rows) {
  Conditions conditions;
  if (rows.success.empty()) {
    conditions.push_back({ConditionKind::no_rows, ConditionSeverity::error, "", ""});
  } else if (rows.successes == 0) {
    conditions.push_back({ConditionKind::one_class, ConditionSeverity::error, "", "no successes"});
  } else if (rows.failures == 0) {
    conditions.push_back({ConditionKind::one_class, ConditionSeverity::error, "", "no failures"});
  }
  if (rows.successes == 1 && rows.failures > 0) {
    conditions.push_back(
        {ConditionKind::rare_class, ConditionSeverity::warning, "", "a single success"});
  }
  if (rows.failures == 1 && rows.successes > 0) {
    conditions.push_back(
        {ConditionKind::rare_class, ConditionSeverity::warning, "", "a single failure"});
  }
  return conditions;
}

/// How many units, and how many of them hold a success or a failure.
struct Units {
  std::size_t all = 0;
  std::size_t with_success = 0;
  std::size_t with_failure = 0;
};

Units units_of(const CompleteRows& rows) {
  if (!rows.clustered) {
    return {rows.success.size(), rows.successes, rows.failures};
  }
  std::vector<std::uint8_t> has_success(rows.clusters, 0);
  std::vector<std::uint8_t> has_failure(rows.clusters, 0);
  for (std::size_t row = 0; row < rows.success.size(); ++row) {
    (rows.success[row] != 0 ? has_success : has_failure)[rows.cluster[row]] = 1;
  }
  const auto total = [](const std::vector<std::uint8_t>& flags) {
    return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
  };
  Units units;
  units.all = rows.clusters;
  units.with_success = total(has_success);
  units.with_failure = total(has_failure);
  return units;
}

void add_unit_conditions(const Units& units, Conditions& conditions) {
  const auto none = [&](const char* detail) {
    conditions.push_back({ConditionKind::one_cluster, ConditionSeverity::warning, "", detail});
  };
  if (units.all < 2) {
    none("");
  } else if (units.with_success < 2) {
    none("all successes are in it");
  } else if (units.with_failure < 2) {
    none("all failures are in it");
  } else if (auto few = few_clusters(units.all)) {
    conditions.push_back(std::move(*few));
  }
}

double small_sample_factor(std::size_t units) {
  return static_cast<double>(units) / (static_cast<double>(units) - 1.0);
}

AucParts empty_parts(const CompleteRows& rows, const Units& units) {
  const auto columns = static_cast<Eigen::Index>(rows.scores.size());
  const auto size = [](std::size_t n) { return static_cast<Eigen::Index>(n); };
  AucParts parts;
  parts.clustered = rows.clustered;
  parts.successes.setZero(size(rows.clustered ? units.all : rows.successes), columns);
  parts.failures.setZero(size(rows.clustered ? units.all : rows.failures), columns);
  parts.success_factor = small_sample_factor(units.with_success);
  parts.failure_factor = small_sample_factor(units.with_failure);
  parts.cross_factor = rows.clustered ? small_sample_factor(units.all) : 0.0;
  return parts;
}

void add_marker(const CompleteRows& rows,
                const Placements& place,
                Eigen::Index column,
                AucParts& parts) {
  const auto successes = static_cast<double>(rows.successes);
  const auto failures = static_cast<double>(rows.failures);
  std::size_t i = 0;
  std::size_t j = 0;
  for (std::size_t row = 0; row < rows.success.size(); ++row) {
    const bool success = rows.success[row] != 0;
    const std::size_t in_class = success ? i++ : j++;
    const auto unit = static_cast<Eigen::Index>(rows.clustered ? rows.cluster[row] : in_class);
    if (success) {
      parts.successes(unit, column) += (place.successes[in_class] - place.auc) / successes;
    } else {
      parts.failures(unit, column) += (place.failures[in_class] - place.auc) / failures;
    }
  }
}

/// u' C v for the covariance C of the AUCs. The clustered form is written so that no term is
/// negative for u = v: rounding cannot make a variance negative.
double form(const AucParts& parts, const Eigen::VectorXd& u, const Eigen::VectorXd& v) {
  const Eigen::VectorXd su = parts.successes * u;
  const Eigen::VectorXd sv = parts.successes * v;
  const Eigen::VectorXd fu = parts.failures * u;
  const Eigen::VectorXd fv = parts.failures * v;
  const double within = (parts.success_factor - parts.cross_factor) * su.dot(sv) +
                        (parts.failure_factor - parts.cross_factor) * fu.dot(fv);
  return parts.clustered ? within + parts.cross_factor * (su + fu).dot(sv + fv) : within;
}

Eigen::MatrixXd covariance_of(const AucParts& parts) {
  const Eigen::Index k = parts.successes.cols();
  const Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(k, k);
  Eigen::MatrixXd result(k, k);
  for (Eigen::Index i = 0; i < k; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      result(i, j) = result(j, i) = form(parts, basis.col(i), basis.col(j));
    }
  }
  return result;
}

void check(std::span<const Score> scores, double level) {
  if (scores.empty()) {
    throw std::invalid_argument("AUC: no predictor");
  }
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("AUC: level must be in (0, 1)");
  }
}

CompleteRows rows_of(std::span<const Score> scores,
                     std::span<const double> success,
                     const AucOptions& options) {
  std::vector<std::span<const double>> values;
  values.reserve(scores.size());
  for (const Score& score : scores) {
    values.push_back(score.values);
  }
  return complete_rows(values, success, options.cluster);
}

}  // namespace

JointAuc joint_auc(std::span<const Score> scores,
                   std::span<const double> success,
                   const AucOptions& options) {
  check(scores, options.level);
  const CompleteRows rows = rows_of(scores, success, options);
  JointAuc joint;
  joint.level = options.level;
  AucEstimate common;
  common.successes = rows.successes;
  common.failures = rows.failures;
  common.missing = rows.missing;
  common.clusters = rows.clusters;
  common.conditions = class_conditions(rows);
  if (has_error(common.conditions)) {
    joint.markers.assign(scores.size(), common);
    return joint;
  }
  const Units units = units_of(rows);
  if (rows.clustered) {
    add_unit_conditions(units, common.conditions);
  }
  joint.markers.assign(scores.size(), common);

  const bool has_variance = units.with_success > 1 && units.with_failure > 1;
  AucParts parts = has_variance ? empty_parts(rows, units) : AucParts{};
  for (std::size_t k = 0; k < scores.size(); ++k) {
    const Placements place = placements(rows.scores[k], rows.success, scores[k].higher);
    AucEstimate& marker = joint.markers[k];
    marker.auc = place.auc;
    if (place.distinct == 1) {
      marker.conditions.push_back({ConditionKind::all_tied, ConditionSeverity::note, "", ""});
    }
    if (place.auc == 0.0 || place.auc == 1.0) {
      marker.conditions.push_back({ConditionKind::separated, ConditionSeverity::note, "", ""});
    }
    if (has_variance) {
      add_marker(rows, place, static_cast<Eigen::Index>(k), parts);
    }
  }
  if (!has_variance) {
    return joint;
  }
  joint.parts = std::move(parts);
  joint.covariance = covariance_of(joint.parts);
  for (std::size_t k = 0; k < scores.size(); ++k) {
    AucEstimate& marker = joint.markers[k];
    const auto column = static_cast<Eigen::Index>(k);
    marker.variance = (*joint.covariance)(column, column);
    const double half = normal_factor(options.level) * std::sqrt(*marker.variance);
    marker.interval = Interval{
        std::max(0.0, *marker.auc - half), std::min(1.0, *marker.auc + half), options.level};
  }
  return joint;
}

AucEstimate auc(std::span<const double> score,
                std::span<const double> success,
                HigherMeans higher,
                const AucOptions& options) {
  const Score marker{score, higher};
  return joint_auc({&marker, 1}, success, options).markers.front();
}

AucDifference auc_contrast(const JointAuc& joint,
                           std::size_t first,
                           std::size_t second,
                           Alternative alternative) {
  if (first >= joint.markers.size() || second >= joint.markers.size()) {
    throw std::invalid_argument("AUC: a contrast of a marker that is not there");
  }
  const AucEstimate& a = joint.markers[first];
  const AucEstimate& b = joint.markers[second];
  AucDifference result;
  result.successes = a.successes;
  result.failures = a.failures;
  result.missing = a.missing;
  result.clusters = a.clusters;
  for (const Condition& condition : a.conditions) {
    if (has(b.conditions, condition.kind) && condition.kind != ConditionKind::all_tied &&
        condition.kind != ConditionKind::separated) {
      result.conditions.push_back(condition);
    }
  }
  if (!a.auc || !b.auc) {
    return result;
  }
  const double difference = *a.auc - *b.auc;
  result.first_auc = a.auc;
  result.second_auc = b.auc;
  result.difference = difference;
  if (!joint.covariance) {
    return result;
  }

  Eigen::VectorXd weights = Eigen::VectorXd::Zero(joint.parts.successes.cols());
  weights(static_cast<Eigen::Index>(first)) += 1.0;
  weights(static_cast<Eigen::Index>(second)) -= 1.0;
  const double variance = form(joint.parts, weights, weights);
  const double half = normal_factor(joint.level) * std::sqrt(variance);
  result.variance = variance;
  result.interval = Interval{difference - half, difference + half, joint.level};
  if (variance > 0.0) {
    result.z = difference / std::sqrt(variance);
    result.p_value = normal_p_value(*result.z, alternative);
  } else if (difference == 0.0) {
    result.conditions.push_back({ConditionKind::same_ranking, ConditionSeverity::note, "", ""});
    result.z = 0.0;
    result.p_value = normal_p_value(0.0, alternative);
  } else {
    result.conditions.push_back({ConditionKind::zero_variance, ConditionSeverity::warning, "", ""});
  }
  return result;
}

AucDifference paired_auc_test(const Score& first,
                              const Score& second,
                              std::span<const double> success,
                              const AucOptions& options,
                              Alternative alternative) {
  const Score both[] = {first, second};  // NOLINT(modernize-avoid-c-arrays): a span's two elements
  return auc_contrast(joint_auc(both, success, options), 0, 1, alternative);
}

}  // namespace tcert::statistics
