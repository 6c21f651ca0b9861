#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/rule_monitor.hpp>
#include <utility>

namespace tcert {
namespace {

constexpr double kTicksPerSecond = 100.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Times are multiples of ns: a window's ends count to within half of one.
constexpr double kHalfNanosecond = 0.5e-9;

std::size_t room_for(double seconds) {
  return std::isfinite(seconds) ? static_cast<std::size_t>(seconds * kTicksPerSecond) + 2 : 1;
}

Robustness compared(const RuleNode& node, const SignalValues& signals) noexcept {
  double sum = node.constant;
  for (const RuleNode::Term& term : node.terms) {
    sum += term.factor * signals[term.signal];
  }
  return std::isnan(sum) ? Robustness{-kInfinity, kInfinity} : Robustness{sum, sum};
}

}  // namespace

WindowExtreme::WindowExtreme(double from_s, double to_s, bool largest)
    : from_s_(from_s),
      to_s_(to_s),
      sign_(largest ? 1.0 : -1.0),
      all_(-kInfinity),
      waiting_(room_for(from_s)),
      extreme_(room_for(to_s - from_s)) {}

void WindowExtreme::clear() noexcept {
  waiting_.clear();
  extreme_.clear();
  all_ = -kInfinity;
}

void WindowExtreme::enter(const Entry& entry) noexcept {
  if (!std::isfinite(to_s_)) {
    all_ = std::max(all_, entry.value);
    return;
  }
  while (!extreme_.empty() && extreme_.back().value <= entry.value) {
    extreme_.pop_back();
  }
  if (extreme_.full()) {
    extreme_.back().time_ns = entry.time_ns;
  } else {
    extreme_.push_back(entry);
  }
}

double WindowExtreme::add(std::int64_t time_ns, double value) noexcept {
  if (waiting_.full()) {
    waiting_.back() = {time_ns, std::max(waiting_.back().value, sign_ * value)};
  } else {
    waiting_.push_back({time_ns, sign_ * value});
  }
  while (!waiting_.empty() &&
         elapsed_s(waiting_.front().time_ns, time_ns) >= from_s_ - kHalfNanosecond) {
    enter(waiting_.front());
    waiting_.pop_front();
  }
  while (!extreme_.empty() &&
         elapsed_s(extreme_.front().time_ns, time_ns) > to_s_ + kHalfNanosecond) {
    extreme_.pop_front();
  }
  const double extreme = extreme_.empty() ? all_ : extreme_.front().value;
  return sign_ * extreme;
}

RuleMonitor::RuleMonitor(std::vector<Rule> rules)
    : rules_(std::move(rules)), states_(rules_.size()) {
  for (const Rule& rule : rules_) {
    Evaluated evaluated{std::vector<Robustness>(rule.nodes.size()), {}};
    for (const RuleNode& node : rule.nodes) {
      for (const RuleNode::Term& term : node.terms) {
        spoken_of_ |= node.kind == RuleNode::Kind::comparison ? 1U << term.signal : 0U;
      }
      evaluated.memory.push_back(static_cast<std::uint32_t>(memories_.size()));
      const bool has_window =
          node.kind == RuleNode::Kind::once || node.kind == RuleNode::Kind::historically;
      if (has_window || node.kind == RuleNode::Kind::since) {
        const bool largest = node.kind == RuleNode::Kind::once;
        const double from_s = has_window ? node.from_s : 0.0;
        const double to_s = has_window ? node.to_s : 0.0;
        memories_.push_back(
            {WindowExtreme(from_s, to_s, largest), WindowExtreme(from_s, to_s, largest)});
      }
    }
    acting_ |= rule.acts ? 1U << evaluated_.size() : 0U;
    evaluated_.push_back(std::move(evaluated));
  }
}

void RuleMonitor::reset() noexcept {
  for (Memory& memory : memories_) {
    memory.low.clear();
    memory.high.clear();
    memory.began = false;
  }
  std::fill(states_.begin(), states_.end(), RuleState{});
  known_ = 0;
  began_ = false;
}

Robustness RuleMonitor::value_of(const RuleNode& node,
                                 const Evaluated& rule,
                                 std::size_t place,
                                 std::int64_t time_ns,
                                 const SignalValues& signals) noexcept {
  const Robustness left = rule.values[node.left];
  const Robustness right = rule.values[node.right];
  switch (node.kind) {
    case RuleNode::Kind::comparison:
      return compared(node, signals);
    case RuleNode::Kind::is_missing: {
      const double value = std::isnan(signals[node.terms.front().signal]) ? kInfinity : -kInfinity;
      return {value, value};
    }
    case RuleNode::Kind::negation:
      return {-left.high, -left.low};
    case RuleNode::Kind::conjunction:
      return {std::min(left.low, right.low), std::min(left.high, right.high)};
    case RuleNode::Kind::disjunction:
      return {std::max(left.low, right.low), std::max(left.high, right.high)};
    case RuleNode::Kind::once:
    case RuleNode::Kind::historically: {
      Memory& memory = memories_[rule.memory[place]];
      return {memory.low.add(time_ns, left.low), memory.high.add(time_ns, left.high)};
    }
    case RuleNode::Kind::since: {
      Memory& memory = memories_[rule.memory[place]];
      if (memory.began) {
        memory.since = {std::max(right.low, std::min(left.low, memory.since.low)),
                        std::max(right.high, std::min(left.high, memory.since.high))};
      } else {
        memory.since = right;
        memory.began = true;
      }
      return memory.since;
    }
  }
  return {};
}

std::uint32_t RuleMonitor::update(std::int64_t time_ns, const SignalValues& signals) noexcept {
  const bool advances = !began_ || time_ns > last_ns_;
  std::uint32_t alarms = 0;
  if (advances) {
    began_ = true;
    last_ns_ = time_ns;
    for (std::size_t k = 0; k < signals.size(); ++k) {
      known_ |= std::isnan(signals[k]) ? 0U : 1U << k;
    }
    for (std::size_t r = 0; r < rules_.size(); ++r) {
      Evaluated& rule = evaluated_[r];
      for (std::size_t i = 0; i < rule.values.size(); ++i) {
        rule.values[i] = value_of(rules_[r].nodes[i], rule, i, time_ns, signals);
      }
      states_[r].robustness = rule.values.back();
      states_[r].alarm = states_[r].robustness.holds();
    }
  }
  for (std::size_t r = 0; r < states_.size(); ++r) {
    alarms |= states_[r].alarm ? 1U << r : 0U;
  }
  return alarms;
}

}  // namespace tcert
