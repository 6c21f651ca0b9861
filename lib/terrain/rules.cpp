#include <algorithm>
#include <array>
#include <cmath>
#include <terrain/limits.hpp>
#include <terrain/rules.hpp>

namespace tcert::terrain {
namespace {

// In the order of the enumerations.
constexpr std::array<std::string_view, 4> kRuleSets{"thesis", "published", "certified", "band"};
constexpr std::array<std::string_view, 4> kSelections{"thesis", "look-ahead", "horizon", "pareto"};

template <class Word, std::size_t n>
[[nodiscard]] std::optional<Word> from(const std::array<std::string_view, n>& words,
                                       std::string_view word) noexcept {
  const auto* const found = std::find(words.begin(), words.end(), word);
  return found == words.end() ? std::nullopt
                              : std::optional(static_cast<Word>(found - words.begin()));
}

}  // namespace

std::string_view to_string(RuleSet rules) noexcept {
  return kRuleSets[static_cast<std::size_t>(rules)];
}

std::optional<RuleSet> rule_set_from(std::string_view word) noexcept {
  return from<RuleSet>(kRuleSets, word);
}

std::string_view to_string(Selection selection) noexcept {
  return kSelections[static_cast<std::size_t>(selection)];
}

std::optional<Selection> selection_from(std::string_view word) noexcept {
  return from<Selection>(kSelections, word);
}

double Rules::band() const noexcept { return kind == RuleSet::published ? beta : std::sqrt(beta); }

void require_valid(const Rules& rules) {
  require_within("threshold", rules.threshold);
  require_within("lipschitz", rules.lipschitz);
  require_within("beta", rules.beta);
  require_within("expanders", rules.expanders);
  require_within("noise-bound", rules.noise_bound);
  require_within("travel-weight", rules.travel_weight);
  require_within("horizon", rules.horizon);
  require_within("growth-weight", rules.growth_weight);
  require_within("noise-sd", rules.noise_sd);
}

}  // namespace tcert::terrain
