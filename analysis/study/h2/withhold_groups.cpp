#include "analysis/study/h2/withhold_groups.hpp"

#include <string>

#include "analysis/study/h1/withhold.hpp"

namespace tcert::study {
namespace {

/// With fewer days the test that groups are equal was seen to reject too often
/// (analysis/README.md).
constexpr std::size_t kTooFewForEquality = 12;

void withhold_equality(const std::string& cluster, H2Panel& panel) {
  bool had = false;
  for (std::optional<H2Equality>* const equality : {&panel.auc, &panel.c}) {
    if (*equality) {
      had = had || (*equality)->tests.heterogeneity.has_value();
      (*equality)->tests.heterogeneity.reset();
    }
  }
  if (had) {
    panel.conditions.push_back(withheld(
        "the test that groups are equal: " +
        too_few(
            cluster, panel.trials.clusters, kTooFewOutcomes, kTooFewOutcomes, kTooFewForEquality)));
  }
}

void withhold(H2Level& level) {
  for (H1Score* const score : {&level.auc, &level.c, &level.auc_within, &level.c_within}) {
    withhold(*score);
  }
  for (H1HazardRatio* const ratio :
       {&level.odds, &level.censored, &level.at_limit, &level.stratified}) {
    withhold(*ratio);
  }
  erase_resampling_conditions(level.conditions);
}

/// The tests that rest on every group; estimates of pairs and the range stay.
void withhold_joint(H2Equality& equality) {
  equality.tests.equivalent.reset();
  equality.tests.p_value.reset();
  equality.tests.smallest_margin.reset();
  equality.tests.margin_with_power.reset();
  equality.tests.heterogeneity.reset();
  equality.range.upper.reset();
  equality.range.p_value.reset();
}

}  // namespace

void withhold_if_few(const H2Options& options, H2Panel& panel) {
  H1Panel& trials = panel.trials;
  const std::string cluster = trials.has_clusters ? options.trials.cluster : "";
  trials.withheld = too_few(cluster, trials.clusters, trials.successes, trials.failures);
  if (trials.clusters < kTooFewForEquality && trials.withheld.empty()) {
    withhold_equality(cluster, panel);
  }
  std::string groups;
  for (H2Level& level : panel.levels) {
    level.withheld = trials.withheld;
    if (level.withheld.empty()) {
      level.withheld =
          too_few(cluster, level.clusters, level.successes, level.trials - level.successes);
    }
    if (!level.withheld.empty()) {
      withhold(level);
      groups += (groups.empty() ? "" : "; ") + level.name + ": " + level.withheld;
    }
  }
  if (groups.empty()) {
    return;
  }
  panel.conditions.push_back(withheld(
      trials.withheld.empty() ? groups + ", and those of pairs with it and of all groups together"
                              : trials.withheld));
  for (std::optional<H2Equality>* const equality : {&panel.auc, &panel.c}) {
    if (*equality) {
      withhold_joint(**equality);
    }
  }
  for (H2Interaction& interaction : panel.interactions) {
    interaction.test.reset();
  }
  if (panel.mixed_interaction) {
    panel.mixed_interaction->test.reset();
  }
}

}  // namespace tcert::study
