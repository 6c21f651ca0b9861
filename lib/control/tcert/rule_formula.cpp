#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tcert/rule_formula.hpp>
#include <tcert/rule_tokens.hpp>
#include <tcert/tick_signals.hpp>

namespace tcert {
namespace {

constexpr std::size_t kMostText = 1U << 16U;  // bytes
constexpr std::size_t kMostTerms = 32;        // of a side of a comparison
constexpr std::size_t kDeepest = 64;          // parentheses and prefixes within one another

class Parser {
 public:
  explicit Parser(RuleTokens& tokens) : tokens_(tokens) {}

  std::vector<RuleNode> parse() {
    formula();
    if (!tokens_.at_end()) {
      tokens_.refuse("and, or, since, or the end of the line");
    }
    return std::move(nodes_);
  }

 private:
  using Kind = RuleNode::Kind;

  std::uint32_t add(RuleNode node) {
    if (nodes_.size() == kMostRuleNodes) {
      tokens_.refuse("a rule of at most " + std::to_string(kMostRuleNodes) + " parts");
    }
    nodes_.push_back(std::move(node));
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  std::uint32_t join(Kind kind, std::uint32_t left, std::uint32_t right) {
    RuleNode node;
    node.kind = kind;
    node.left = left;
    node.right = right;
    return add(std::move(node));
  }

  std::uint32_t formula() {
    std::uint32_t left = disjunction();
    while (tokens_.take("since")) {
      left = join(Kind::since, left, disjunction());
    }
    return left;
  }
  std::uint32_t disjunction() {
    std::uint32_t left = conjunction();
    while (tokens_.take("or")) {
      left = join(Kind::disjunction, left, conjunction());
    }
    return left;
  }
  std::uint32_t conjunction() {
    std::uint32_t left = unary();
    while (tokens_.take("and")) {
      left = join(Kind::conjunction, left, unary());
    }
    return left;
  }

  std::uint32_t unary() {
    if (++depth_ > kDeepest) {
      tokens_.refuse("at most " + std::to_string(kDeepest) + " parts within one another");
    }
    const std::uint32_t node = unary_within();
    --depth_;
    return node;
  }
  std::uint32_t unary_within() {
    if (tokens_.take("(")) {
      const std::uint32_t inner = formula();
      tokens_.expect(")");
      return inner;
    }
    if (tokens_.take("not")) {
      const std::uint32_t inner = unary();
      return join(Kind::negation, inner, inner);
    }
    if (tokens_.take("once")) {
      return temporal(Kind::once);
    }
    if (tokens_.take("historically")) {
      return temporal(Kind::historically);
    }
    if (tokens_.take("missing")) {
      tokens_.expect("(");
      RuleNode node;
      node.kind = Kind::is_missing;
      node.terms.push_back({1.0, signal()});
      tokens_.expect(")");
      return add(std::move(node));
    }
    return comparison();
  }

  std::uint32_t temporal(Kind kind) {
    RuleNode node;
    node.kind = kind;
    if (tokens_.take("[")) {
      node.from_s = tokens_.take_number("seconds before now");
      tokens_.expect(",");
      if (!tokens_.take("inf")) {
        node.to_s = tokens_.take_number("seconds before now, or inf");
      }
      if (node.to_s < node.from_s || node.from_s > kLongestRuleWindow ||
          (std::isfinite(node.to_s) && node.to_s > kLongestRuleWindow)) {
        tokens_.refuse("before this a window [from, to] with from <= to <= " +
                       to_text(kLongestRuleWindow) + " s");
      }
      tokens_.expect("]");
    }
    node.left = unary();
    return add(std::move(node));
  }

  std::uint32_t signal() {
    const auto found = signal_named(tokens_.now());
    if (!found) {
      std::string names;
      for (const SignalDoc& one : tick_signals()) {
        (names += names.empty() ? "" : ", ") += one.name;
      }
      tokens_.refuse("a signal: " + names);
    }
    tokens_.next();
    return static_cast<std::uint32_t>(*found);
  }

  void sum(RuleNode& node, double sign) {
    bool first = true;
    for (;;) {
      double factor = sign;
      if (tokens_.take("-")) {
        factor = -factor;
      } else if (!first && !tokens_.take("+")) {
        return;
      }
      first = false;
      if (node.terms.size() == kMostTerms) {
        tokens_.refuse("a sum of at most " + std::to_string(kMostTerms) + " signals");
      }
      if (!tokens_.is_number()) {
        node.terms.push_back({factor, signal()});
        continue;
      }
      factor *= tokens_.take_number("a number");
      if (tokens_.take("*")) {
        node.terms.push_back({factor, signal()});
      } else {
        node.constant += factor;
      }
    }
  }
  std::uint32_t comparison() {
    RuleNode left;
    sum(left, 1.0);
    const bool above = tokens_.now() == ">" || tokens_.now() == ">=";
    if (!above && tokens_.now() != "<" && tokens_.now() != "<=") {
      tokens_.refuse("<, <=, > or >=");
    }
    tokens_.next();
    RuleNode node;
    node.constant = above ? left.constant : -left.constant;
    for (const RuleNode::Term& term : left.terms) {
      node.terms.push_back({above ? term.factor : -term.factor, term.signal});
    }
    sum(node, above ? -1.0 : 1.0);
    node.constant += 0.0;
    return add(std::move(node));
  }

  RuleTokens& tokens_;
  std::vector<RuleNode> nodes_;
  std::size_t depth_ = 0;
};

std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(kRuleBlank);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kRuleBlank) - first + 1);
}

}  // namespace

std::vector<Rule> parse_rules(std::string_view text) {
  if (text.size() > kMostText) {
    throw std::invalid_argument("rules: found " + std::to_string(text.size()) +
                                " bytes, expected at most " + std::to_string(kMostText));
  }
  std::vector<Rule> rules;
  double windows_s = 0.0;
  std::size_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = line.substr(0, line.find('#'));
    if (trimmed(line).empty()) {
      continue;
    }
    RuleTokens tokens(line, number);
    Rule rule;
    if (tokens.now() == "watch" && tokens.is_followed_by_word()) {
      rule.acts = false;
      tokens.next();
    }
    rule.name = tokens.now();
    rule.text = trimmed(line.substr(std::min(line.find(':'), line.size() - 1) + 1));
    if (!std::ranges::all_of(rule.name, is_rule_word) || rule.name == "watch" ||
        rule.name == "any") {
      tokens.refuse("the name of a rule: letters, digits and _, neither watch nor any");
    }
    if (std::ranges::any_of(rules, [&](const Rule& other) { return other.name == rule.name; })) {
      tokens.refuse("each name once");
    }
    if (rules.size() == kMostRules) {
      tokens.refuse("at most " + std::to_string(kMostRules) + " rules");
    }
    tokens.next();
    tokens.expect(":");
    rule.nodes = Parser(tokens).parse();
    for (const RuleNode& node : rule.nodes) {
      windows_s += std::isfinite(node.to_s) ? node.to_s : node.from_s;
    }
    if (windows_s > kLongestRuleWindows) {
      tokens.refuse("before this windows of at most " + to_text(kLongestRuleWindows) +
                    " s, all rules together");
    }
    rules.push_back(std::move(rule));
  }
  return rules;
}

std::string_view default_rules() noexcept {
  return R"(# What is wrong at a tick, by what was sensed.
stale: historically[0,0.2] stale > 0.5
watch frozen: unchanged_s >= 0.5
force: force_n > force_limit_n
watch margin: historically[0,0.2] (robust_margin_m <= 0.005 and speed_cmd_mps > 0)
watch ahead: speed_cmd_mps > 0.05 and felt_ahead_m <= 0.3*speed_cmd_mps
stall: time_s >= 2 and historically[0,2] (speed_cmd_mps > 0.03 and moved_mps < 0.01)
latency: gap_s >= 0.25
jump: moved_mps >= 1 or jump_m >= 0.4
)";
}

}  // namespace tcert
