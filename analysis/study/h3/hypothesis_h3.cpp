#include "analysis/study/h3/hypothesis_h3.hpp"

#include <stdexcept>
#include <vector>

#include "analysis/study/h3/chosen_beta.hpp"
#include "analysis/study/h3/h3_group.hpp"
#include "analysis/study/h3/replay_rows.hpp"

namespace tcert::study {
namespace {

const char* const kAllLightings = "all";

void require(const H3Options& options) {
  const auto inside = [](double share) { return share > 0.0 && share < 1.0; };
  if (!inside(options.level) || !inside(options.loss_margin) || options.replicates == 0) {
    throw std::invalid_argument("h3: level and loss margin must lie in (0, 1), replicates above 0");
  }
  if (!(options.true_loss >= 0.0 && options.true_loss < options.loss_margin)) {
    throw std::invalid_argument("h3: the true loss must lie below the loss margin");
  }
  if (options.beta.folds < 2) {
    throw std::invalid_argument("h3: needs two folds");
  }
}

}  // namespace

H3Table hypothesis_h3(const table::DataTable& replays,
                      const H3Options& options,
                      const Watch& watch) {
  require(options);
  H3Table table;
  table.options = options;
  const ReplayRows rows = rows_of(replays, options);
  Grouped trials = grouped(rows, options);
  table.unknown = trials.unknown;
  std::vector<H3Trial> all;
  for (const auto& [lighting, some] : trials.by_lighting) {
    all.insert(all.end(), some.begin(), some.end());
  }
  if (all.empty()) {
    table.conditions.push_back(
        {statistics::ConditionKind::no_rows,
         statistics::ConditionSeverity::error,
         "algorithm",
         "no trial of '" + options.gated + "' or '" + options.baseline + "'"});
    return table;
  }
  table.groups.push_back(group_of(rows, all, trials.cases, options, watch, kAllLightings));
  if (trials.by_lighting.size() > 1) {
    for (const auto& [lighting, some] : trials.by_lighting) {
      table.groups.push_back(group_of(rows, some, trials.cases, options, watch, lighting));
    }
  }
  table.chosen = chosen_cases(rows, trials, table.groups, options, watch);
  return table;
}

}  // namespace tcert::study
