#pragma once
/// \file
/// `tcert hypotheses h3`.

#include <string>

#include "cli/options.hpp"
#include "cli/replay_options.hpp"

namespace tcert::cli {

struct H3CommandOptions {
  std::string replays;
  std::string gated = "M3";
  std::string baseline = "CB-V";
  double loss_margin = 0.05;
  ReplayLawOptions laws;
};

void add_h3_options(po::options_description& own, H3CommandOptions& options);

/// What h1 and h3 share on the command line.
struct H3Shared {
  std::string bundle;
  std::string cluster;
  std::string table;
  double level = 0.95;
  std::int64_t replicates = 2000;
  std::string interval = "expanded";
};

/// \throws UsageError, BadData, NoInput, WriteError.
int run_h3(const H3CommandOptions& options, const H3Shared& shared, const CommonOptions& common);

}  // namespace tcert::cli
