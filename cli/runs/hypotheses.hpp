#pragma once
/// \file
/// The options of `tcert hypotheses`.

#include <cstdint>
#include <string>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h2/hypothesis_h2.hpp"
#include "cli/options.hpp"

namespace tcert::cli {

struct HypothesesOptions {
  std::string hypothesis;
  std::string bundle;
  std::string features;
  std::string predictor;
  std::string baselines;
  std::string success = "success";
  std::string time = "time_s";
  std::string cluster = "day";
  std::string strata = "algorithm";
  std::string within;
  std::string interval = "expanded";
  std::string table;
  std::string landmark;
  std::string limit;
  bool no_time_rounding = false;
  double level = 0.95;
  std::int64_t replicates = 2000;
  std::int64_t folds = 5;
  // h2
  std::string group = "lighting";
  double margin = 0.05;
  std::int64_t permutations = 2000;
};

void add_h1_options(po::options_description& own, HypothesesOptions& o);

/// \throws UsageError unless it is expanded, percentile or bca.
[[nodiscard]] statistics::BootstrapMethod interval_method(const std::string& name);

/// \throws UsageError for a value out of range.
[[nodiscard]] study::H1Options h1_options(const HypothesesOptions& options,
                                          const CommonOptions& common);

/// The same trials and the first predictor, by groups. \throws UsageError likewise, or if baselines
/// are given.
[[nodiscard]] study::H2Options h2_options(const HypothesesOptions& options,
                                          const CommonOptions& common);

}  // namespace tcert::cli
