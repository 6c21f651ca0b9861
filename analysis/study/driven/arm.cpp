#include "analysis/study/driven/arm.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace tcert::study {
namespace {

[[noreturn]] void refuse(std::string_view part, std::string_view expected) {
  throw std::invalid_argument("found '" + std::string(part) + "', expected " +
                              std::string(expected));
}

/// The parts of `text` with `separator` between.
std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.push_back(text.substr(0, end));
    if (end == text.size()) {
      return parts;
    }
    text.remove_prefix(end + 1);
  }
}

/// The law that "squash20" names; none if it names none.
std::optional<SpeedLaw> law_of(std::string_view part, SpeedLaw law) {
  for (const auto& [word, kind] :
       {std::pair<std::string_view, SpeedLawKind>("squash", SpeedLawKind::squash),
        {"clip", SpeedLawKind::clip}}) {
    if (!part.starts_with(word)) {
      continue;
    }
    law.kind = kind;
    const std::string_view beta = part.substr(word.size());
    const char* const end = beta.data() + beta.size();
    if (!beta.empty()) {
      const auto [rest, error] = std::from_chars(beta.data(), end, law.beta_per_m);
      if (error != std::errc{} || rest != end) {
        refuse(part, "a speed law and its beta in 1/m, as in squash20");
      }
    }
    validate(law);
    return law;
  }
  return std::nullopt;
}

}  // namespace

Arm parse_arm(std::string_view text, const SpeedLaw& law) {
  const std::vector<std::string_view> parts = parts_of(text, '+');
  Arm arm;
  arm.name = text;
  const auto policy = policies::policy_named(parts.front());
  if (!policy) {
    refuse(parts.front(), "a policy: M1, M2, M3, TVFH, TD*Lite or CB-V");
  }
  arm.policy = *policy;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const bool comes_later = arm.guards || arm.without_memory;
    if (const auto named = law_of(parts[i], law); named && !arm.law && !comes_later) {
      arm.law = *named;
    } else if (parts[i] == "guards" && !comes_later) {
      arm.guards = true;
      arm.law = arm.law.value_or(law);
    } else if (parts[i] == "A1" && !arm.without_memory) {
      arm.without_memory = true;
    } else {
      refuse(parts[i], "squash, clip, guards or A1, each once and in this order");
    }
  }
  return arm;
}

std::vector<Arm> parse_arms(std::string_view text, const SpeedLaw& law) {
  std::vector<Arm> arms;
  for (const std::string_view part : parts_of(text, ',')) {
    arms.push_back(parse_arm(part, law));
    for (std::size_t i = 0; i + 1 < arms.size(); ++i) {
      if (arms[i].name == arms.back().name) {
        refuse(part, "each policy once");
      }
    }
  }
  return arms;
}

}  // namespace tcert::study
