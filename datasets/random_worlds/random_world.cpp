#include "datasets/random_worlds/random_world.hpp"

#include <stdexcept>

#include "datasets/random_worlds/families.hpp"
#include "datasets/worlds/world_problems.hpp"

namespace tcert {
namespace {

constexpr std::uint32_t kWorld = 0x7277'0001;

}  // namespace

std::string_view name_of(WorldFamily family) noexcept {
  constexpr std::array<std::string_view, kWorldFamilies> kNames{"gates",
                                                                "bends",
                                                                "discs",
                                                                "figure_eight",
                                                                "loop",
                                                                "u_turn",
                                                                "tight_ends",
                                                                "slanted_gates",
                                                                "staggered",
                                                                "posts",
                                                                "dead_ends",
                                                                "kinks",
                                                                "s_bends"};
  return kNames[static_cast<std::size_t>(family)];
}

WorldFamily mixed_family(std::uint64_t index) noexcept {
  using enum WorldFamily;
  constexpr std::array kShares{gates, discs, bends, gates, loop,  discs,       bends,
                               gates, discs, bends, discs, gates, bends,       discs,
                               gates, discs, bends, gates, discs, figure_eight};
  return kShares[index % kShares.size()];
}

WorldFamily hard_family(std::uint64_t index) noexcept {
  return kHardFamilies[index % kHardFamilies.size()];
}

WorldFamily u_turn_family(std::uint64_t /*index*/) noexcept { return WorldFamily::u_turn; }

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
    case WorldFamily::tight_ends:
      drawn = draw_tight_ends(random);
      break;
    case WorldFamily::slanted_gates:
      drawn = draw_slanted_gates(random);
      break;
    case WorldFamily::staggered:
      drawn = draw_staggered(random);
      break;
    case WorldFamily::posts:
      drawn = draw_posts(random);
      break;
    case WorldFamily::dead_ends:
      drawn = draw_dead_ends(random);
      break;
    case WorldFamily::kinks:
      drawn = draw_kinks(random);
      break;
    case WorldFamily::s_bends:
      drawn = draw_s_bends(random);
      break;
  }
  drawn.family = family;
  drawn.world.synthetic = true;
  drawn.world.seed = seed;
  drawn.world.name = std::string(name_of(family)) + " " + std::to_string(index);
  drawn.speed_mps = random.uniform(0.14, 0.21);
  drawn.wobble_m = random.uniform(0.0, 0.03);
  const std::vector<std::string> problems = world_problems(drawn.world);
  if (!problems.empty()) {
    throw std::logic_error("world '" + drawn.world.name + "': expected " + problems.front());
  }
  return drawn;
}

}  // namespace tcert
