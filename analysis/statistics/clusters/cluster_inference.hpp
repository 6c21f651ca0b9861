#pragma once
/// \file
/// Which correction for few clusters a p and an interval are by.

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/clusters/sandwich_parts.hpp>
#include <statistics/clusters/wild_bootstrap.hpp>
#include <string>
#include <string_view>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

enum class ClusterInference : std::uint8_t {
  cr1,        ///< Sandwich times G/(G - 1), Student's t with G - 1 degrees of freedom.
  cr2,        ///< Bell and McCaffrey's sandwich, t with Satterthwaite's degrees of freedom.
  jackknife,  ///< Whole clusters left out (CV3), t with G - 1 degrees of freedom.
  wild,       ///< Wild bootstrap of the clusters' scores; the interval inverts the test.
};
/// "cr1", "cr2", "jackknife", "wild".
[[nodiscard]] std::string_view to_string(ClusterInference inference) noexcept;

/// The coefficients without each cluster in turn.
struct LeftOut {
  Eigen::MatrixXd values;           ///< p x G; NaN where there is none.
  std::vector<std::string> causes;  ///< G: why a coefficient is missing; empty where none is.
};

/// A fit as inference asks for it.
struct ClusteredFit {
  SandwichParts parts;  ///< At the estimates.
  PartsAt parts_at;
  std::function<LeftOut()> left_out;
  std::vector<std::string> names;  ///< G: the clusters'.
};

/// Of clusters in the order of their codes: those of `codes`, by their levels. \pre `codes` are of
/// `cluster`, `compact` of `codes`.
[[nodiscard]] std::vector<std::string> cluster_names(const table::Factor& cluster,
                                                     std::span<const std::uint32_t> codes,
                                                     const CompactCodes& compact);

/// (G - 1) / G times the sum of squared distances of `left_out` from `estimate`: CV3 (MacKinnon,
/// Nielsen and Webb 2023). NaN if one is.
[[nodiscard]] double jackknife_variance(double estimate, const Eigen::VectorXd& left_out);

/// The same of several numbers jointly: `left_out` p x G.
[[nodiscard]] Eigen::MatrixXd jackknife_covariance(const Eigen::VectorXd& estimates,
                                                   const Eigen::MatrixXd& left_out);

/// Of any number by its values without each cluster, t with G - 1 degrees of freedom. Empty with
/// fewer than 2 clusters, or where a value is NaN.
[[nodiscard]] ClusterT jackknife_estimate(double estimate,
                                          std::span<const double> left_out,
                                          double level);

/// Rows times clusters above which no number is made anew without each cluster: some 20 s.
inline constexpr double kMostLeftOutRows = 1e8;

/// no_jackknife where that is so, with the way out; else empty.
[[nodiscard]] std::optional<Condition> too_much_to_leave_out(std::size_t clusters,
                                                             std::size_t rows);

/// From an uncorrected robust standard error; empty without one and with fewer than 2 clusters.
[[nodiscard]] ClusterT cr1_estimate(const std::optional<double>& estimate,
                                    const std::optional<double>& robust_error,
                                    std::size_t clusters,
                                    double level);

/// By which way, and what it says of each coefficient.
struct ClusterInferences {
  ClusterInference by = ClusterInference::jackknife;
  std::vector<ClusterT> of;
  Eigen::MatrixXd covariance;  ///< p x p, of the coefficients; NaN as they; of wild that of CR1.
                               ///< Empty with fewer than 2 clusters.
  std::optional<LeftOut> left_out{};  ///< Of the jackknife.
  Conditions conditions{};            ///< no_jackknife, no_robust_variance.
};

/// Up to so many clusters the jackknife is what is taken by default: of those that were tried it
/// alone keeps its level with 6 clusters that are unlike (analysis/README.md). Beyond, CR1, which
/// refits nothing.
inline constexpr std::size_t kMostJackknifeClusters = 100;

[[nodiscard]] ClusterInference default_inference(std::size_t clusters) noexcept;

/// By the jackknife, whatever the size of the parts: a coefficient that a refit lacks has no
/// spread, and the condition no_jackknife names the cluster and the cause.
[[nodiscard]] ClusterInferences by_jackknife(const Eigen::VectorXd& estimates,
                                             LeftOut left_out,
                                             std::span<const std::string> names,
                                             double level);

/// Nothing of any of `coefficients` by the way that was asked for, and why: no_robust_variance.
[[nodiscard]] ClusterInferences not_to_be_had(ClusterInference asked,
                                              std::size_t coefficients,
                                              const std::string& why);

/// One for each coefficient; all empty with fewer than 2 clusters. The standard error of wild is
/// that of CR1, which scales its search for the ends.
[[nodiscard]] ClusterInferences cluster_inferences(const ClusteredFit& fit,
                                                   std::optional<ClusterInference> inference,
                                                   const WildOptions& options);

}  // namespace tcert::statistics
