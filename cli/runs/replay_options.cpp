#include "cli/runs/replay_options.hpp"

#include <algorithm>
#include <array>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/guard_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::array kSpeedLaws{
    SpeedLawKind::squash, SpeedLawKind::clip, SpeedLawKind::barrier, SpeedLawKind::profile};

}  // namespace

std::vector<SpeedLawKind> speed_laws_of(const std::string& list) {
  std::vector<SpeedLawKind> kinds;
  for (const std::string& word : words_of(list)) {
    const auto* const kind =
        std::ranges::find(kSpeedLaws, word, [](SpeedLawKind one) { return study::to_string(one); });
    if (kind == kSpeedLaws.end()) {
      throw UsageError("--laws: found '" + word + "', expected squash, clip, barrier or profile");
    }
    kinds.push_back(*kind);
  }
  return kinds;
}

void add_replay_law_options(OptionTable& table, ReplayLawOptions& options) {
  table.add("laws",
            options.laws,
            "LIST",
            "speed laws to replay at: squash (3.5), clip (4.4, G1), barrier, profile");
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
  setup.laws = study::law_grid(parameters.speed_law, speed_laws_of(options.laws), betas);
  if (setup.laws.empty()) {
    throw UsageError("--laws and --betas: nothing to replay at");
  }
  setup.tracking_error = tracking_error_table(options.tracking_error, decimal_comma, progress);
  return setup;
}

}  // namespace tcert::cli
