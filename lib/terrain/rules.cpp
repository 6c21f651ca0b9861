#include <array>
#include <cmath>
#include <stdexcept>
#include <terrain/rules.hpp>

namespace tcert::terrain {
namespace {

constexpr std::array<RuleSet, 3> kAll{RuleSet::thesis, RuleSet::published, RuleSet::certified};

void require(bool holds, const char* message) {
  if (!holds) {
    throw std::invalid_argument(message);
  }
}

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
  require(std::isfinite(rules.threshold), "the threshold must be finite");
  require(std::isfinite(rules.lipschitz) && rules.lipschitz > 0.0,
          "the Lipschitz constant must be > 0");
  require(std::isfinite(rules.beta) && rules.beta >= 0.0, "beta must be >= 0");
  require(rules.expanders > 0, "the number of expanders must be > 0");
  require(std::isfinite(rules.noise_bound) && rules.noise_bound >= 0.0,
          "the noise bound must be >= 0");
  require(std::isfinite(rules.travel_weight) && rules.travel_weight >= 0.0,
          "the travel weight must be >= 0");
}

}  // namespace tcert::terrain
