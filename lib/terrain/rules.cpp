#include <array>
#include <cmath>
#include <terrain/limits.hpp>
#include <terrain/rules.hpp>

namespace tcert::terrain {
namespace {

constexpr std::array<RuleSet, 3> kAll{RuleSet::thesis, RuleSet::published, RuleSet::certified};

}  // namespace

std::string_view to_string(RuleSet rules) noexcept {
  switch (rules) {
    case RuleSet::thesis:
      return "thesis";
    case RuleSet::published:
      return "published";
    case RuleSet::certified:
      break;
  }
  return "certified";
}

std::optional<RuleSet> rule_set_from(std::string_view word) noexcept {
  for (const RuleSet rules : kAll) {
    if (to_string(rules) == word) {
      return rules;
    }
  }
  return std::nullopt;
}

double Rules::band() const noexcept { return kind == RuleSet::published ? beta : std::sqrt(beta); }

void require_valid(const Rules& rules) {
  require_within("threshold", rules.threshold);
  require_within("lipschitz", rules.lipschitz);
  require_within("beta", rules.beta);
  require_within("expanders", rules.expanders);
  require_within("noise-bound", rules.noise_bound);
  require_within("travel-weight", rules.travel_weight);
}

}  // namespace tcert::terrain
