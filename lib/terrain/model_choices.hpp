#pragma once
/// \file
/// What an exploration learns of the field beside its values: its scale, with it the Lipschitz
/// constant or the band, and its length scale. Internal to the exploration.

#include <cstddef>
#include <optional>
#include <terrain/explore.hpp>
#include <terrain/field_scale.hpp>

namespace tcert::terrain {

class ModelChoices {
 public:
  /// Keeps a reference to `setup`.
  explicit ModelChoices(const ExploreSetup& setup);

  /// Changes the planner's choices if it has enough new measurements.
  void renew(Planner& planner);

 private:
  void apply_scale(Planner& planner) const;
  void choose_length_scale(Planner& planner);

  const ExploreSetup& setup_;
  std::optional<FieldScale> scale_;
  std::size_t taken_ = 0;        // measurements that the scale has
  std::size_t next_choice_ = 0;  // of the length scale, in measurements
};

}  // namespace tcert::terrain
