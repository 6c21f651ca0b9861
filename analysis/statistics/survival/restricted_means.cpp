#include <statistics/survival/restricted_means.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/survival/survival_curve.hpp>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

struct MeanOf {
  double mean = table::kNaN;
  double std_error = table::kNaN;
};

/// Of each group; NaN where it has no row. A curve that ends above 0 before the limit is carried
/// on.
std::vector<MeanOf> means_of(const SurvivalOutcome& outcome,
                             const table::Factor* groups,
                             double limit,
                             std::vector<bool>* followed = nullptr) {
  CurveOptions options;
  options.groups = groups;
  std::vector<MeanOf> means;
  for (const SurvivalCurve& curve : survival_curves(outcome, options)) {
    const RestrictedMean one = restricted_mean(curve, limit);
    means.push_back(curve.rows == 0 ? MeanOf{} : MeanOf{one.mean, one.std_error});
    if (followed != nullptr) {
      followed->push_back(curve.rows > 0 && (curve.points.back().survival == 0.0 ||
                                             curve.time_near(limit) <= curve.points.back().time));
    }
  }
  return means;
}

/// NaN also where nothing is known of a curve up to the limit.
std::vector<MeanOf> known_means(const SurvivalOutcome& outcome,
                                const table::Factor* groups,
                                double limit) {
  std::vector<bool> followed;
  std::vector<MeanOf> means = means_of(outcome, groups, limit, &followed);
  for (std::size_t g = 0; g < means.size(); ++g) {
    means[g] = followed[g] ? means[g] : MeanOf{};
  }
  return means;
}

/// [cluster][group]: the means without each cluster.
std::vector<std::vector<MeanOf>> left_out_means(const SurvivalOutcome& outcome,
                                                const table::Factor* groups,
                                                const table::Factor& cluster,
                                                double limit) {
  const CompactCodes compact = compact_codes(cluster.codes);
  std::vector<std::vector<MeanOf>> all;
  for (std::size_t unit = 0; unit < compact.count; ++unit) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < outcome.rows(); ++row) {
      if (compact.codes[row] != unit) {
        rows.push_back(row);
      }
    }
    std::optional<table::Factor> kept;
    if (groups != nullptr) {
      kept.emplace();
      kept->levels = groups->levels;  // Also those that are gone: the groups keep their places.
      for (const std::size_t row : rows) {
        kept->codes.push_back(groups->codes[row]);
      }
    }
    all.push_back(means_of(on_rows(outcome, rows), kept ? &*kept : nullptr, limit));
  }
  return all;
}

/// Clusters that each group has rows of.
std::vector<std::size_t> clusters_of_groups(const table::Factor* groups,
                                            const table::Factor& cluster) {
  std::vector<std::vector<std::uint32_t>> codes(groups == nullptr ? 1 : groups->levels.size());
  for (std::size_t row = 0; row < cluster.codes.size(); ++row) {
    codes[groups == nullptr ? 0 : groups->codes[row]].push_back(cluster.codes[row]);
  }
  std::vector<std::size_t> counts;
  counts.reserve(codes.size());
  for (const std::vector<std::uint32_t>& of_group : codes) {
    counts.push_back(count_codes(of_group));
  }
  return counts;
}

/// Student's t with as many degrees of freedom as the smallest group has clusters, less 1.
ClusterT by_clusters(double value,
                     const std::vector<double>& left_out,
                     std::size_t clusters,
                     double level) {
  if (clusters < 2) {
    return {};
  }
  const Eigen::Map<const Eigen::VectorXd> values(left_out.data(),
                                                 static_cast<Eigen::Index>(left_out.size()));
  return by_student_t(value,
                      std::sqrt(jackknife_variance(value, values)),
                      static_cast<double>(clusters) - 1.0,
                      level);
}

ClusterT by_normal(double value, double std_error, double level) {
  ClusterT spread;
  if (std_error > 0.0) {
    const double half = normal_factor(level) * std_error;
    spread.standard_error = std_error;
    spread.p_value = normal_p_value(value / std_error, Alternative::two_sided);
    spread.interval = Interval{value - half, value + half, level};
  }
  return spread;
}

}  // namespace

std::vector<RestrictedMeanRow> restricted_means(const SurvivalOutcome& outcome,
                                                const table::Factor* groups,
                                                const table::Factor* cluster,
                                                double limit,
                                                double level) {
  const std::vector<MeanOf> means = known_means(outcome, groups, limit);
  std::vector<std::vector<MeanOf>> without;
  std::vector<std::size_t> in_group(means.size(), 0);
  if (cluster != nullptr && !too_much_to_leave_out(count_codes(cluster->codes), outcome.rows())) {
    without = left_out_means(outcome, groups, *cluster, limit);
    in_group = clusters_of_groups(groups, *cluster);
  }
  const auto name = [&](std::size_t g) {
    return groups == nullptr ? std::string() : groups->levels[g];
  };
  std::vector<RestrictedMeanRow> rows;
  const auto add = [&](std::size_t first, std::optional<std::size_t> second) {
    const auto of = [&](const std::vector<MeanOf>& from) {
      return from[first].mean - (second ? from[*second].mean : 0.0);
    };
    RestrictedMeanRow row{name(first), second ? name(*second) : "", of(means), {}};
    if (cluster != nullptr) {
      std::vector<double> left_out;
      left_out.reserve(without.size());
      for (const std::vector<MeanOf>& one : without) {
        left_out.push_back(of(one));
      }
      const std::size_t clusters =
          second ? std::min(in_group[first], in_group[*second]) : in_group[first];
      row.spread = by_clusters(row.value, left_out, clusters, level);
    } else {
      row.spread =
          by_normal(row.value,
                    std::hypot(means[first].std_error, second ? means[*second].std_error : 0.0),
                    level);
    }
    if (!second) {
      row.spread.p_value.reset();  // A mean of 0 is no hypothesis.
    }
    rows.push_back(std::move(row));
  };
  for (std::size_t g = 0; g < means.size(); ++g) {
    add(g, std::nullopt);
  }
  for (std::size_t a = 0; a < means.size(); ++a) {
    for (std::size_t b = a + 1; b < means.size(); ++b) {
      add(a, b);
    }
  }
  return rows;
}

}  // namespace tcert::statistics
