#pragma once
/// \file
/// Rules watched tick by tick: robustness of past-time signal temporal logic, O(1) a tick.

#include <cstddef>
#include <cstdint>
#include <span>
#include <tcert/rule_formula.hpp>
#include <tcert/tick_signals.hpp>
#include <vector>

namespace tcert {

static_assert(kTickSignals <= 32, "a bit for each signal");

/// The robustness of a formula, as far as it is known: what is missing may be anything. Both bounds
/// are equal where nothing is missing.
struct Robustness {
  double low = 0.0;
  double high = 0.0;
  /// The formula surely holds; 0 counts as held.
  [[nodiscard]] bool holds() const noexcept { return low >= 0.0; }
};

/// Largest or smallest value within a window of time, by a monotone queue.
///
/// Room is for 100 ticks a second. Where more come the newest two are taken together: the more
/// extreme of them, at the time of the later.
class WindowExtreme {
 public:
  /// Of times in [t - to_s, t - from_s]; `to_s` may be infinite.
  WindowExtreme(double from_s, double to_s, bool largest);

  void clear() noexcept;
  /// The extreme with `value` at `time_ns` in it; -infinity (of the largest) or infinity if the
  /// window holds nothing. Amortised O(1). \pre times rise between two clears.
  double add(std::int64_t time_ns, double value) noexcept;

 private:
  struct Entry {
    std::int64_t time_ns = 0;
    double value = 0.0;
  };
  class Ring {
   public:
    explicit Ring(std::size_t capacity) : entries_(capacity) {}
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] bool full() const noexcept { return size_ == entries_.size(); }
    [[nodiscard]] const Entry& front() const noexcept { return entries_[first_]; }
    [[nodiscard]] Entry& back() noexcept {
      return entries_[(first_ + size_ - 1) % entries_.size()];
    }
    void push_back(const Entry& e) noexcept { entries_[(first_ + size_++) % entries_.size()] = e; }
    void pop_front() noexcept {
      first_ = (first_ + 1) % entries_.size();
      --size_;
    }
    void pop_back() noexcept { --size_; }
    void clear() noexcept { first_ = size_ = 0; }

   private:
    std::vector<Entry> entries_;
    std::size_t first_ = 0;
    std::size_t size_ = 0;
  };
  void enter(const Entry& entry) noexcept;

  double from_s_;
  double to_s_;
  double sign_;   // values are kept times this, so that the largest counts
  double all_;    // of everything that entered, where the window has no end
  Ring waiting_;  // younger than from_s
  Ring extreme_;  // falling values
};

/// What a rule says at one tick.
struct RuleState {
  Robustness robustness;
  bool alarm = false;  ///< It surely holds.
};

/// All rules of one run. The constructor takes all memory; `update` and `reset` are noexcept and
/// allocate nothing. A tick whose time does not advance changes nothing.
class RuleMonitor {
 public:
  /// \throws std::bad_alloc.
  explicit RuleMonitor(std::vector<Rule> rules);

  void reset() noexcept;

  /// Alarms, or'ed as 1 << rule; their robustness is in states() until the next call.
  std::uint32_t update(std::int64_t time_ns, const SignalValues& signals) noexcept;

  /// Those that act, as 1 << rule.
  [[nodiscard]] std::uint32_t acting() const noexcept { return acting_; }
  /// Signals that a comparison speaks of and no tick since the last reset has had, as 1 << signal:
  /// it may never hold for want of them.
  [[nodiscard]] std::uint32_t never_known() const noexcept { return spoken_of_ & ~known_; }
  [[nodiscard]] const std::vector<Rule>& rules() const noexcept { return rules_; }
  [[nodiscard]] std::span<const RuleState> states() const noexcept { return states_; }

 private:
  struct Memory {
    WindowExtreme low;
    WindowExtreme high;
    Robustness since{};  // of the tick before
    bool began = false;
  };
  struct Evaluated {
    std::vector<Robustness> values;     // by node
    std::vector<std::uint32_t> memory;  // by node: its place in memories_
  };
  [[nodiscard]] Robustness value_of(const RuleNode& node,
                                    const Evaluated& rule,
                                    std::size_t place,
                                    std::int64_t time_ns,
                                    const SignalValues& signals) noexcept;

  std::vector<Rule> rules_;
  std::vector<Evaluated> evaluated_;
  std::vector<Memory> memories_;
  std::vector<RuleState> states_;
  std::uint32_t acting_ = 0;
  std::uint32_t spoken_of_ = 0;
  std::uint32_t known_ = 0;
  bool began_ = false;
  std::int64_t last_ns_ = 0;
};

}  // namespace tcert
