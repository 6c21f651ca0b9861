#pragma once
/// \file
/// Witnesses beside the ticks of a live run.

#include <cstddef>
#include <future>
#include <limits>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/tick.hpp>
#include <witness/tick_samples.hpp>

#include "analysis/study/trials/parameters.hpp"
#include "analysis/study/witness/prove_trial.hpp"

namespace tcert::cli {

/// Every `witness_every` ticks a search in a copy of what was felt, by a thread of its own. What it
/// finds counts from the next look on, so that the ticks go on meanwhile; T_t is the largest margin
/// so far. Keeps at most kMostSamples positions; those beyond prove nothing.
class LiveWitness {
 public:
  enum class WhenLate {
    wait,  ///< The ticks wait for a search that is not done by the next look: always the same bits.
    skip   ///< The ticks never wait: that look is left out and counted.
  };
  static constexpr std::size_t kMostSamples = 1U << 20U;

  /// Of a robot and parameters that outlive it. \throws UsageError if no look is asked for.
  LiveWitness(const Robot& robot,
              const Course& course,
              const study::ParameterSet& parameters,
              WhenLate when_late);

  /// Takes the next tick and puts T_t of the witnesses in the place of that of `certified`.
  void take(const Tick& tick, CertifiedTick& certified);

  /// At the end: waits for the search under way, makes a last one in all that was felt, and says
  /// what they prove, in one line.
  [[nodiscard]] std::string conclude();

 private:
  void look(std::int64_t time_ns);
  void collect();

  const Robot& robot_;
  Course course_;
  const study::ParameterSet& parameters_;
  WhenLate when_late_;
  witness::TickSamples felt_;
  std::future<study::Proof> search_;
  std::size_t ticks_ = 0;
  std::size_t late_ = 0;
  std::size_t left_out_ = 0;
  double certificate_m_ = -std::numeric_limits<double>::infinity();
};

}  // namespace tcert::cli
