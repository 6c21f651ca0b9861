#pragma once
// How often the sets of the 50 % point cover its large-sample value, over simulated micro-studies.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <table/row_text.hpp>
#include <vector>

#include "analysis/study/gate/even_chance.hpp"

namespace tcert::study::coverage {

struct GateOptions {
  std::size_t studies = 1000;  ///< Each one is `simulate --micro-study` of its own seed.
  std::size_t replicates = 999;
  std::uint64_t first_seed = 1;
  double level = 0.95;
};

inline constexpr std::size_t kGateMethods = 4;

/// One micro-study, with its sets in the order fieller, profile, bootstrap percentile, BCa.
struct GateStudy {
  std::vector<double> margin;         ///< Of its passes, metres.
  std::vector<std::uint8_t> success;  ///< The same.
  std::optional<double> point;        ///< None if the passes are separated.
  std::array<ConfidenceSet, kGateMethods> sets;
};

void row_cells(auto& row, table::Is<GateStudy> auto& study) {
  row(study.margin, study.success, study.point);
  for (auto& set : study.sets) {
    row(set.kind, set.low, set.high);
  }
}

/// Micro-studies: passes are simulated, resampled to ticks and certified as the tool does.
class GateStudies {
 public:
  explicit GateStudies(const GateOptions& options);
  ~GateStudies();
  GateStudies(const GateStudies&) = delete;
  GateStudies& operator=(const GateStudies&) = delete;

  /// Micro-study number `index`. Thread-safe.
  [[nodiscard]] GateStudy operator()(std::uint64_t index) const;

 private:
  struct Certifiers;
  GateOptions options_;
  std::unique_ptr<Certifiers> certifiers_;  ///< One a thread.
};

struct GateCoverage {
  std::string method;
  std::size_t sets = 0;  ///< Studies that have one; the others are separated.
  std::size_t unbounded = 0;
  double covered = 0.0;  ///< Share of the sets that cover the large-sample point.
  double monte_carlo_se = 0.0;
  double covered_zero = 0.0;    ///< Share that cover margin 0.
  double median_width_m = 0.0;  ///< Of the bounded ones.
};

struct GateSummary {
  double point_m = 0.0;        ///< Of all passes of all studies together: the large sample.
  double point_error_m = 0.0;  ///< Its standard error.
  double slope_per_m = 0.0;
  double mean_estimate_m = 0.0;
  double median_estimate_m = 0.0;
  std::size_t separated = 0;
  std::vector<GateCoverage> methods;
};

/// What micro-studies come to. \throws std::domain_error if all of them together are separated.
[[nodiscard]] GateSummary summarise(const std::vector<GateStudy>& studies);

}  // namespace tcert::study::coverage
