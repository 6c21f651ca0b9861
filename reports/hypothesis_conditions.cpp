#include "reports/hypothesis_conditions.hpp"

#include <algorithm>
#include <statistics/basics/condition_groups.hpp>
#include <string>
#include <utility>
#include <vector>

#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

using statistics::Condition;
using statistics::Conditions;

Condition of(const std::string& whose, Condition condition) {
  condition.detail = whose + (condition.detail.empty() ? "" : ": " + condition.detail);
  return condition;
}

/// An error in a part leaves the numbers of the others.
Condition at_most_warning(Condition condition) {
  if (condition.severity == statistics::ConditionSeverity::error) {
    condition.severity = statistics::ConditionSeverity::warning;
  }
  return condition;
}

/// What a detail is about: the whole of it where it does not say.
std::string subject_of(const std::string& detail) {
  const std::string subject = statistics::subject_of(detail);
  return subject.empty() ? detail : subject;
}

void add(const std::string& whose, const Conditions& some, Conditions& all) {
  for (const Condition& condition : some) {
    all.push_back(of(whose, condition));
  }
}

/// What several rows or groups of a panel have, or one row of several folds, is one.
void add_shared(const std::string& panel,
                const std::vector<statistics::OwnedCondition>& owned,
                Conditions& all) {
  for (statistics::SharedCondition& shared : statistics::shared_conditions(owned)) {
    if (!shared.same_detail) {
      shared.condition.detail +=
          shared.owners.size() > 1 ? " in " + shared.owners.front() : " and the like";
    }
    all.push_back(of(panel + ", " + statistics::some_of(shared.owners), shared.condition));
  }
}

/// "lighting" of the column "Dark" of an interaction, "tc:lighting" of "tc:Dark".
std::string factor_of(const study::H2Table& h2,
                      const study::H2Panel& panel,
                      const std::string& column) {
  const std::string product = panel.predictor + ":";
  const bool is_product = column.starts_with(product);
  const std::string level = is_product ? column.substr(product.size()) : column;
  const bool is_level = std::any_of(panel.levels.begin(),
                                    panel.levels.end(),
                                    [&](const study::H2Level& one) { return one.name == level; });
  return is_level ? (is_product ? product : "") + h2.options.trials.group : "";
}

}  // namespace

Conditions conditions_of(const study::H1Table& h1) {
  Conditions all;
  for (const study::H1Panel& panel : h1.panels) {
    const std::string name = panel_name(h1, panel) + " panel";
    add(name, panel.conditions, all);
    std::vector<statistics::OwnedCondition> owned;
    for (const study::H1Row& row : panel.rows) {
      for (Condition condition : row.conditions) {
        if (condition.column == row.name) {
          condition.column.clear();  // The row is named.
        }
        owned.push_back({row.name, subject_of(condition.detail), condition});
      }
    }
    add_shared(name, owned, all);
  }
  return all;
}

Conditions conditions_of(const study::H2Table& h2) {
  Conditions all;
  for (const study::H2Panel& panel : h2.panels) {
    const std::string name = panel_name(h2, panel) + " panel";
    add(name, panel.trials.conditions, all);
    add(name, panel.conditions, all);
    std::vector<statistics::OwnedCondition> owned;
    for (const study::H2Level& level : panel.levels) {
      for (const Condition& condition : level.conditions) {
        owned.push_back({level.name, subject_of(condition.detail), at_most_warning(condition)});
      }
    }
    add_shared(name, owned, all);
    std::vector<study::H2Interaction> interactions = panel.interactions;
    if (panel.mixed_interaction) {
      interactions.push_back(*panel.mixed_interaction);
    }
    for (const study::H2Interaction& one : interactions) {
      for (const Condition& condition : statistics::one_per_factor(
               one.conditions,
               [&](const std::string& column) { return factor_of(h2, panel, column); })) {
        all.push_back(of(name + ", interaction, " + one.model, at_most_warning(condition)));
      }
    }
  }
  return all;
}

Conditions conditions_of(const study::H3Table& h3) {
  Conditions all = h3.conditions;
  for (const study::H3Group& group : h3.groups) {
    add(group.lighting, group.conditions, all);
  }
  return all;
}

}  // namespace tcert
