#include "analysis/study/h1/incidence_by_quartile.hpp"

#include <algorithm>
#include <array>
#include <statistics/basics/quantile.hpp>

namespace tcert::study {
namespace {

constexpr std::array kShares{0.25, 0.5, 0.75};

table::Factor quartiles(const std::vector<double>& values) {
  std::array<double, kShares.size()> cuts{};
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    cuts[i] = statistics::quantile(values, kShares[i]).value_or(0.0);
  }
  table::Factor factor;
  factor.levels = {"Q1", "Q2", "Q3", "Q4"};
  for (const double value : values) {
    const auto above =
        std::count_if(cuts.begin(), cuts.end(), [&](double cut) { return value > cut; });
    factor.codes.push_back(static_cast<std::uint32_t>(above));
  }
  return factor;
}

}  // namespace

void add_incidence_by_quartile(const H1Data& data, H1Panel& panel) {
  if (!data.censored) {
    return;
  }
  statistics::CompetingOutcome outcome;
  outcome.start = data.censored->start;
  outcome.stop = data.censored->stop;
  outcome.causes = {"egress", "failure"};
  for (std::size_t i = 0; i < data.rows(); ++i) {
    const std::uint32_t cause = data.success[i] != 0 ? 1 : 2;
    outcome.cause.push_back(data.cut[i] != 0 ? 0 : cause);
  }
  const table::Factor groups = quartiles(data.predictors.front());
  statistics::IncidenceOptions options;
  options.groups = &groups;
  options.cluster = &data.cluster;
  panel.incidence = statistics::cumulative_incidence(std::move(outcome), options);
}

}  // namespace tcert::study
