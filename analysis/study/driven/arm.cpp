#include "analysis/study/driven/arm.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "analysis/study/replay/replay_record.hpp"

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

/// The number behind a word, `otherwise` if there is none.
double number_behind(std::string_view part, std::string_view word, double otherwise) {
  const std::string_view digits = part.substr(word.size());
  const char* const end = digits.data() + digits.size();
  double number = otherwise;
  if (!digits.empty()) {
    const auto [rest, error] = std::from_chars(digits.data(), end, number);
    if (error != std::errc{} || rest != end) {
      refuse(part, "a word and its number, as in squash20");
    }
  }
  return number;
}

/// The law that "squash20" names; none if it names none.
std::optional<SpeedLaw> law_of(std::string_view part, SpeedLaw law) {
  for (const SpeedLawKind kind :
       {SpeedLawKind::squash, SpeedLawKind::clip, SpeedLawKind::barrier, SpeedLawKind::profile}) {
    const std::string_view word = to_string(kind);
    if (part.starts_with(word)) {
      law.kind = kind;
      double& sensitivity = kind == SpeedLawKind::barrier ? law.barrier_gain_per_s : law.beta_per_m;
      sensitivity = number_behind(part, word, sensitivity);
      validate(law);
      return law;
    }
  }
  return std::nullopt;
}

constexpr double kRiskWeight = 1.0;  // of an arm that names none

bool chooses_headings(policies::PolicyKind policy) noexcept {
  return policy != policies::PolicyKind::tvfh && policy != policies::PolicyKind::td_star_lite;
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
  int last = 0;  // place of the part before, in their order
  const auto comes_at = [&](int place) {
    const bool follows = last < place;
    last = std::max(last, place);
    return follows;
  };
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::string_view part = parts[i];
    if (const auto named = law_of(part, law); named && comes_at(1)) {
      arm.law = *named;
    } else if (part == "guards" && comes_at(2)) {
      arm.guards = true;
      arm.law = arm.law.value_or(law);
    } else if (part == "monitor" && comes_at(3)) {
      arm.monitor = true;
    } else if (part.starts_with("risk") && comes_at(4)) {
      arm.lambda_weight = number_behind(part, "risk", kRiskWeight);
      if (!chooses_headings(arm.policy)) {
        refuse(part, "no risk field: TVFH and TD*Lite choose no heading");
      }
    } else if (part == "A1" && comes_at(5)) {
      arm.without_memory = true;
    } else {
      refuse(part,
             "squash, clip, barrier, profile, guards, monitor, risk or A1, each once and in this "
             "order");
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
