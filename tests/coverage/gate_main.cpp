// Prints the coverage of every set of the 50 % point as CSV. gate_study [STUDIES [REPLICATES]]

#include <cstdio>
#include <cstdlib>

#include "analysis/study/coverage/gate_study.hpp"

int main(int argc, char** argv) {
  tcert::study::coverage::GateOptions options;
  if (argc > 1) {
    options.studies = std::strtoul(argv[1], nullptr, 10);
  }
  if (argc > 2) {
    options.replicates = std::strtoul(argv[2], nullptr, 10);
  }
  if (options.studies == 0 || options.replicates == 0 || argc > 3) {
    std::fprintf(stderr, "usage: gate_study [STUDIES [REPLICATES]]\n");
    return 2;
  }
  const tcert::study::coverage::GateSummary summary = tcert::study::coverage::run_gates(options);
  std::fprintf(
      stderr,
      "%zu studies: large-sample 50 %% point %.5f m (SE %.5f), its bias from 0; slope %.2f "
      "1/m; estimates: mean %.5f m, median %.5f m; %zu studies separated\n",
      options.studies,
      summary.point_m,
      summary.point_error_m,
      summary.slope_per_m,
      summary.mean_estimate_m,
      summary.median_estimate_m,
      summary.separated);
  std::printf("method,sets,unbounded_share,coverage,mc_se,covers_zero,median_width_m\n");
  for (const tcert::study::coverage::GateCoverage& row : summary.methods) {
    std::printf("%s,%zu,%.4f,%.4f,%.4f,%.4f,%.5f\n",
                row.method.c_str(),
                row.sets,
                static_cast<double>(row.unbounded) / static_cast<double>(row.sets),
                row.covered,
                row.monte_carlo_se,
                row.covered_zero,
                row.median_width_m);
  }
  return 0;
}
