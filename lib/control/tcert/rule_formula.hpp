#pragma once
/// \file
/// A rule as a formula of past-time signal temporal logic, from text.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace tcert {

/// A node of a formula; its operands stand before it.
struct RuleNode {
  enum class Kind : std::uint8_t {
    comparison,    ///< Sum of terms at least 0: `<` and `<=` are the same.
    is_missing,    ///< The signal of the one term is not known.
    negation,      ///< not f
    conjunction,   ///< f and g
    disjunction,   ///< f or g
    once,          ///< f held at some time in [t - to_s, t - from_s].
    historically,  ///< f held at all times there.
    since,         ///< f has held ever since g did.
  };
  struct Term {
    double factor = 0.0;
    std::uint32_t signal = 0;
  };
  Kind kind = Kind::comparison;
  std::uint32_t left = 0;  ///< Places of the operands.
  std::uint32_t right = 0;
  double from_s = 0.0;  ///< Of once and historically.
  double to_s = std::numeric_limits<double>::infinity();
  double constant = 0.0;  ///< Of a comparison: constant + sum of its terms >= 0.
  std::vector<Term> terms{};
};

/// `[watch] name: formula`; the root is the last node.
struct Rule {
  std::string name;
  bool acts = true;  ///< False of a rule that is watched alone: its alarms back nothing out.
  std::string text;
  std::vector<RuleNode> nodes;
};

inline constexpr std::size_t kMostRules = 32;
inline constexpr std::size_t kMostRuleNodes = 256;     ///< Of one rule.
inline constexpr double kLongestRuleWindow = 600.0;    ///< s
inline constexpr double kLongestRuleWindows = 6000.0;  ///< s, of all together

/// One rule a line, `name: formula`, or `watch name: formula`; empty lines and what follows '#' are
/// left out.
// clang-format off
///
///     formula = or { "since" or }
///     or      = and { "or" and }
///     and     = unary { "and" unary }
///     unary   = "not" unary | ("once" | "historically") [ "[" from "," to "]" ] unary
///             | "(" formula ")" | "missing" "(" signal ")" | sum ("<" | "<=" | ">" | ">=") sum
///     sum     = term { ("+" | "-") term }
///     term    = number [ "*" signal ] | signal
///
// clang-format on
/// Times in seconds before now, `to` may be inf; without them the window is everything so far.
/// \throws std::invalid_argument naming line, column, what was found and what was expected; also if
/// there are more than kMostRules rules, two of one name, or a window is longer than
/// kLongestRuleWindow, all of them than kLongestRuleWindows, a sum or the text too long.
[[nodiscard]] std::vector<Rule> parse_rules(std::string_view text);

/// The default rules: stale touch, a frozen ray, force, robust margin, a wall ahead, stall,
/// latency, jump.
[[nodiscard]] std::string_view default_rules() noexcept;

}  // namespace tcert
