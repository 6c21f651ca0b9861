// Prints, for studies of 660 trials on 22 days in three lightings: how often equivalence of the
// AUCs is found at a margin, and how often a difference, by the true difference and the within-day
// correlation.

#include <cstdio>
#include <cstdlib>

#include "analysis/study/coverage/equivalence_study.hpp"

int main(int argc, char** argv) {
  using tcert::study::coverage::EquivalenceRates;
  using tcert::study::coverage::LightingScenario;
  const std::size_t data_sets = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2000;
  if (data_sets == 0 || argc > 2) {
    std::fprintf(stderr, "usage: equivalence_study [DATA_SETS]\n");
    return 2;
  }
  std::printf(
      "icc,margin,difference,data_sets,equivalent,pair_equivalent,different,mean_se,true_se,"
      "mean_range,margin_80\n");
  std::uint32_t stream = 200;
  for (const double icc : {0.0, 0.2, 0.5}) {
    for (const double margin : {0.05, 0.22, 0.27}) {
      for (const double share : {0.0, 0.5, 1.0}) {
        LightingScenario scenario;
        scenario.icc = icc;
        scenario.margin = margin;
        scenario.difference = share * margin;
        const EquivalenceRates row =
            tcert::study::coverage::run_equivalence(scenario, stream++, data_sets);
        std::printf("%.1f,%.2f,%.3f,%zu,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n",
                    icc,
                    margin,
                    scenario.difference,
                    row.tested,
                    row.equivalent,
                    row.one_pair,
                    row.different,
                    row.mean_error,
                    row.true_error,
                    row.mean_range,
                    row.mean_power_margin);
        std::fflush(stdout);
      }
    }
  }
  return 0;
}
