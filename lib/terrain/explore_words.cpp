#include <algorithm>
#include <array>
#include <terrain/explore.hpp>

namespace tcert::terrain {
namespace {

constexpr std::array<std::string_view, 4> kMotions{"jump", "route", "reactive", "pursuit"};

}  // namespace

std::string_view to_string(Motion motion) noexcept {
  return kMotions[static_cast<std::size_t>(motion)];
}

std::optional<Motion> motion_from(std::string_view word) noexcept {
  const auto* const found = std::find(kMotions.begin(), kMotions.end(), word);
  if (found == kMotions.end()) {
    return std::nullopt;
  }
  return static_cast<Motion>(found - kMotions.begin());
}

std::string_view to_string(End end) noexcept {
  switch (end) {
    case End::reached:
      return "reached";
    case End::explored:
      return "explored: no cell can make the ground grow";
    case End::exhausted:
      return "no cell within reach can make the ground grow";
    case End::not_reachable:
      return "not reachable at this threshold";
    case End::past_obstacles:
      return "not reachable at this threshold past the obstacles and gaps";
    case End::only_body:
      return "not reachable at this threshold with this body";
    case End::only_lipschitz:
      return "not certified: only the Lipschitz constant forbids it";
    case End::only_rules:
      return "not certified: only the rule set forbids it";
    case End::goal_at_edge:
      return "the goal is certified and joined, but not deep enough within the outline";
    case End::step_limit:
      return "step limit";
    case End::empty_safe_set:
      return "empty safe set";
    case End::stranded:
      break;
  }
  return "stranded";
}

}  // namespace tcert::terrain
