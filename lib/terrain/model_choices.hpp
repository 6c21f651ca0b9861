#pragma once
/// \file
/// The length scale and the Lipschitz constant, chosen anew whenever the measurements have doubled.
/// Internal to explore.cpp.

#include <cstddef>
#include <terrain/explore.hpp>

namespace tcert::terrain {

class ModelChoices {
 public:
  /// Keeps a reference to `setup`.
  explicit ModelChoices(const ExploreSetup& setup) : setup_(setup) {}

  /// Changes the planner's choices if it has enough new measurements.
  void renew(Planner& planner);

 private:
  void estimate_lipschitz_anew(Planner& planner);
  void choose_length_scale(Planner& planner) const;

  const ExploreSetup& setup_;
  std::size_t next_choice_ = 0;  // in measurements
  int estimates_ = 0;
  int patches_ = 0;
};

}  // namespace tcert::terrain
