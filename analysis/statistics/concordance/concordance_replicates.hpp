#pragma once
/// \file
/// C of one predictor again and again on the same rows with other weights: the inner loop of a
/// bootstrap or a cluster jackknife.

#include <cstddef>
#include <cstdint>
#include <span>
#include <statistics/concordance/concordance.hpp>
#include <statistics/concordance/prefix_sums.hpp>
#include <statistics/resampling/resampling_plan.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <vector>

namespace tcert::statistics {

/// Sorts once; each replicate is then a walk through the rows in time order.
///
/// A replicate is a multiplicity per row: how often the row was drawn (for clusters: how often its
/// cluster was), 0 for rows left out. The result is what `concordance` gives with these case
/// weights, to the last bit, as both count in whole numbers. In particular a multiplicity of 1 each
/// gives the main estimate.
///
///     const ConcordanceReplicates first(outcome, x1), second(outcome, x2);  // Predictors; once
///     ConcordanceReplicates::Scratch scratch;                         // once a thread
///     difference = first.c(times, scratch) - second.c(times, scratch);
///
/// The object is read only after construction and may be shared between threads; a scratch may not,
/// but serves any object in turn.
class ConcordanceReplicates {
 public:
  /// Pair counts of a replicate; a pair counts the product of the multiplicities of its rows.
  struct Counts {
    std::uint64_t concordant = 0;
    std::uint64_t discordant = 0;
    std::uint64_t tied_x = 0;

    Counts& operator+=(const Counts& other) noexcept {
      concordant += other.concordant;
      discordant += other.discordant;
      tied_x += other.tied_x;
      return *this;
    }
    Counts& operator-=(const Counts& other) noexcept {
      concordant -= other.concordant;
      discordant -= other.discordant;
      tied_x -= other.tied_x;
      return *this;
    }
  };

  /// How often each rank stands. Grows at first use and is then reused without allocation.
  class Scratch {
   public:
    void reset(std::size_t distinct) {
      sums_.reset(distinct);
      of_rank_.assign(distinct, 0);
    }
    void add(std::uint32_t rank, std::uint32_t times) noexcept {
      sums_.add(rank, times);
      of_rank_[rank] += times;
    }
    /// A row of `rank`, standing so often, against all that stand here: concordant are those above.
    [[nodiscard]] Counts against(std::uint32_t rank, std::uint64_t times) const noexcept {
      const std::uint64_t below = sums_.before(rank);
      const std::uint64_t tied = of_rank_[rank];
      return {times * (sums_.total() - below - tied), times * below, times * tied};
    }

   private:
    PrefixSums<std::uint32_t> sums_;
    std::vector<std::uint32_t> of_rank_;
  };

  /// `outcome` has rounded times, the predictor no missing values; a start that all rows share (a
  /// landmark) is no truncation. `strata` may be null. O(n log n).
  /// \throws std::invalid_argument if lengths differ, a time or event is out of range, or a
  /// predictor value or a stratum is missing.
  ConcordanceReplicates(const SurvivalOutcome& outcome,
                        const Predictor& predictor,
                        const table::Factor* strata = nullptr);

  /// C, or NaN if no pair is comparable. O(n log d), d the distinct values of the predictor.
  /// \pre `multiplicity` has a value per row; their sum is below 2^32.
  [[nodiscard]] double c(std::span<const std::uint32_t> multiplicity, Scratch& scratch) const;
  [[nodiscard]] Counts counts(std::span<const std::uint32_t> multiplicity, Scratch& scratch) const;

  /// The counts without each unit of `plan` in turn, every other row standing once: those of
  /// `counts` with the unit's multiplicities 0, all units in O(n log d) together. \pre `plan` is of
  /// as many rows.
  [[nodiscard]] std::vector<Counts> without_units(const ResamplingPlan& plan) const;

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }

 private:
  /// A row enters the risk set, seen from the end of time; leaves it; or has its event.
  enum class Step : std::uint8_t { enter, leave, compare, next_stratum };
  struct Visit {
    std::uint32_t row = 0;
    std::uint32_t rank = 0;
    Step step = Step::enter;
  };

  void add_stratum(const SurvivalOutcome& outcome,
                   std::span<const std::uint32_t> by_stop,
                   std::span<const std::uint32_t> by_start,
                   std::span<const std::uint32_t> ranks);
  [[nodiscard]] std::vector<Counts> counts_of_rows() const;
  [[nodiscard]] std::vector<std::vector<Visit>> visits_by_unit(const ResamplingPlan& plan) const;
  [[nodiscard]] std::vector<Counts> counts_within(const ResamplingPlan& plan) const;
  [[nodiscard]] Counts directed(Counts counts) const noexcept;

  std::vector<Visit> visits_;
  LargerMeans larger_;
  std::size_t rows_ = 0;
  std::size_t distinct_ = 0;  ///< Of the stratum with the most.
};

}  // namespace tcert::statistics
