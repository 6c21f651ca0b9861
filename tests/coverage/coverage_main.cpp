// Prints the coverage of every interval method as CSV. coverage_study [DATA_SETS [REPLICATES]]

#include <cstdio>
#include <cstdlib>

#include "analysis/study/coverage/coverage_study.hpp"

int main(int argc, char** argv) {
  using tcert::study::coverage::Coverage;
  using tcert::study::coverage::Options;
  using tcert::study::coverage::Scenario;
  Options options;
  if (argc > 1) {
    options.data_sets = std::strtoul(argv[1], nullptr, 10);
  }
  if (argc > 2) {
    options.replicates = std::strtoul(argv[2], nullptr, 10);
  }
  if (options.data_sets == 0 || options.replicates == 0 || argc > 3) {
    std::fprintf(stderr, "usage: coverage_study [DATA_SETS [REPLICATES]]\n");
    return 2;
  }
  const Scenario scenarios[] = {{"independent", 22, 30, 0.0},
                                {"icc_0.2", 22, 30, 0.2},
                                {"icc_0.5", 22, 30, 0.5},
                                {"icc_0.8", 22, 30, 0.8}};
  std::printf(
      "scenario,quantity,method,truth,mean_estimate,intervals,missing,coverage,mc_se,mean_width\n");
  std::uint32_t stream = 10;
  for (const Scenario& scenario : scenarios) {
    for (const Coverage& row : tcert::study::coverage::run(scenario, stream++, options)) {
      std::printf("%s,%s,%s,%.4f,%.4f,%zu,%zu,%.4f,%.4f,%.4f\n",
                  row.scenario.c_str(),
                  row.quantity.c_str(),
                  row.method.c_str(),
                  row.truth,
                  row.mean_estimate,
                  row.intervals,
                  row.missing,
                  row.covered,
                  row.monte_carlo_se,
                  row.mean_width);
    }
    std::fflush(stdout);
  }
  return 0;
}
