#pragma once
/// \file
/// Conditions that differ only by the level of one factor, as one.

#include <functional>
#include <statistics/basics/condition.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// A condition, who has it (a level, a column), and of what (a quantity, a factor).
struct OwnedCondition {
  std::string owner;
  std::string of;
  Condition condition;
};

/// A condition that several have; `condition` is the first one's.
struct SharedCondition {
  std::vector<std::string> owners;  ///< Each once, in order.
  std::string of;
  Condition condition;
  bool same_detail = true;  ///< All of them have the first one's detail.
};

/// Those of one kind, severity, column, advice and `of` are one, in order of the first of each.
[[nodiscard]] std::vector<SharedCondition> shared_conditions(
    const std::vector<OwnedCondition>& conditions);

/// "AUC" of the detail "AUC: 12 of 2000": what it is about; empty if it does not say.
[[nodiscard]] std::string subject_of(const std::string& detail);

/// "a, b, c and 57 more".
[[nodiscard]] std::string some_of(const std::vector<std::string>& names);

/// One condition for all columns of a factor that have it: "column 'world': quasi-complete
/// separation: 60 columns (worldw1, worldw2, worldw3 and 57 more), the first: ...".
/// `factor_of` names the factor whose column this is; empty for other columns, which keep theirs.
[[nodiscard]] Conditions one_per_factor(
    const Conditions& conditions,
    const std::function<std::string(const std::string& column)>& factor_of);

}  // namespace tcert::statistics
