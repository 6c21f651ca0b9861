#include "datasets/driven/driven_design.hpp"

#include <stdexcept>

namespace tcert {

DrivenDesign design_driven(const DriveParameters& parameters,
                           std::uint64_t seed,
                           std::uint64_t index) {
  DrivenDesign design;
  design.seed = seed;
  design.index = index;
  design.world = draw_gated_world(parameters, seed, index);
  design.parameters = parameters;
  design.trial_id = trial_name(index);
  return design;
}

DrivenDesign mirrored(const DrivenDesign& design) {
  DrivenDesign image = design;
  image.world = mirrored(design.world);
  image.mirrored = !design.mirrored;
  return image;
}

std::uint64_t noise_seed(const DrivenDesign& design) noexcept {
  return design.noise_seed.value_or(design.seed);
}

void validate(const DrivenDesign& design) {
  validate(design.parameters);
  const World& world = design.world.world;
  if (!world.start || !world.goal) {
    throw std::invalid_argument("world '" + world.name + "' has no S or no G");
  }
}

}  // namespace tcert
