#include "cli/runs/replay_options.hpp"

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/guard_options.hpp"

namespace tcert::cli {
namespace {

std::vector<SpeedLawKind> kinds_of(const std::string& list) {
  std::vector<SpeedLawKind> kinds;
  for (const std::string& word : words_of(list)) {
    if (word != "squash" && word != "clip") {
      throw UsageError("--laws: found '" + word + "', expected squash or clip");
    }
    kinds.push_back(word == "squash" ? SpeedLawKind::squash : SpeedLawKind::clip);
  }
  return kinds;
}

}  // namespace

void add_replay_law_options(OptionTable& table, ReplayLawOptions& options) {
  table.add("laws", options.laws, "LIST", "speed laws to replay at: squash (3.5), clip (4.4, G1)");
  table.add("betas", options.betas, "LIST", "their sensitivities in 1/m");
  add_tracking_error_option(table, options.tracking_error);
}

study::ReplaySetup replay_setup(const ReplayLawOptions& options,
                                const study::ParameterSet& parameters,
                                bool decimal_comma,
                                Progress& progress) {
  const std::vector<double> betas = numbers_of("betas", options.betas);
  for (const double beta : betas) {
    require_range("betas", beta, 1e-6, 1e6);
  }
  study::ReplaySetup setup;
  setup.laws = study::law_grid(parameters.speed_law, kinds_of(options.laws), betas);
  if (setup.laws.empty()) {
    throw UsageError("--laws and --betas: nothing to replay at");
  }
  setup.tracking_error = tracking_error_table(options.tracking_error, decimal_comma, progress);
  return setup;
}

}  // namespace tcert::cli
