#pragma once
/// \file
/// The values of one trial against what their columns' names and the course say of them.

#include <cstddef>
#include <map>
#include <string>
#include <tcert/parameters.hpp>
#include <utility>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/ticks.hpp"
#include "datasets/values/value_finding.hpp"

namespace tcert {

/// Warnings of units, frames, dead sensors and a run beside its course, from the ticks that a trial
/// has anyway: one a kind, which names all rays that it is about. They are questions: the data are
/// used as they are. O(ticks x rays).
[[nodiscard]] std::vector<ValueFinding> check_values(const BundleInfo& info,
                                                     const TrialRow& trial,
                                                     const CertificateParameters& parameters,
                                                     const TickTable& ticks);

/// The findings of many trials, said once a kind.
class ValueSummary {
 public:
  /// Trials in order.
  void add(const std::vector<ValueFinding>& findings);

  /// A line a kind, in the order of the kinds: that of its first trial, and how many more there
  /// are.
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  struct Kind {
    table::Diagnostic first;
    std::size_t trials = 0;
  };
  std::map<ValueKind, Kind> kinds_;
};

}  // namespace tcert
