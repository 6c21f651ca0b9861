#include "datasets/random_worlds/random_world.hpp"

#include <algorithm>

#include "datasets/random_worlds/families.hpp"

namespace tcert {
namespace {

constexpr std::uint32_t kWorld = 0x7277'0001;

}  // namespace

std::string_view name_of(WorldFamily family) noexcept {
  constexpr std::array<std::string_view, 6> kNames{
      "gates", "bends", "discs", "figure_eight", "loop", "u_turn"};
  return kNames[static_cast<std::size_t>(family)];
}

WorldFamily mixed_family(std::uint64_t index) noexcept {
  using enum WorldFamily;
  constexpr std::array kShares{gates, discs, bends, gates, loop,  discs,       bends,
                               gates, discs, bends, discs, gates, bends,       discs,
                               gates, discs, bends, gates, discs, figure_eight};
  return kShares[index % kShares.size()];
}

RandomWorld draw_random_world(WorldFamily family, std::uint64_t seed, std::uint64_t index) {
  table::RandomStream random(seed, kWorld + static_cast<std::uint32_t>(family), index);
  RandomWorld drawn;
  switch (family) {
    case WorldFamily::gates:
      drawn = draw_gates(random);
      break;
    case WorldFamily::bends:
      drawn = draw_bends(random);
      break;
    case WorldFamily::discs:
      drawn = draw_discs(random);
      break;
    case WorldFamily::figure_eight:
      drawn = draw_figure_eight(random);
      break;
    case WorldFamily::loop:
      drawn = draw_loop(random);
      break;
    case WorldFamily::u_turn:
      drawn = draw_u_turn(random);
      break;
  }
  drawn.family = family;
  drawn.world.synthetic = true;
  drawn.world.seed = seed;
  drawn.world.name = std::string(name_of(family)) + " " + std::to_string(index);
  drawn.speed_mps = random.uniform(0.14, 0.21);
  drawn.wobble_m = random.uniform(0.0, 0.03);
  return drawn;
}

}  // namespace tcert
