#pragma once
/// \file
/// What a cell does to H1 and to the issuing of certificates, beside the full method.

#include <cstddef>
#include <optional>
#include <table/data_table.hpp>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

/// Certificates of a cell by what became of the trial, beside those of the full method. Trials
/// without an outcome are left out.
struct CellIssuance {
  std::size_t successes = 0;
  std::size_t failures = 0;
  std::size_t issued_successes = 0;
  std::size_t issued_failures = 0;
  std::size_t spurious = 0;           ///< Issued here and not by the full method.
  std::size_t spurious_failures = 0;  ///< Of those, trials that failed.
  std::size_t lost = 0;               ///< Issued by the full method and not here.
  std::size_t before_goal = 0;        ///< Issued before the robot was inside G.
  std::size_t falling = 0;            ///< Trials whose T_t fell at some tick.
};

struct CellScores {
  /// The cell's own H1: its certificate feature against its own rivals.
  H1Table own;
  /// Its certificate feature (first row) against that of the full method (second row, whose gains
  /// are the cell's), on the trials that have both, in the same resamples. Empty for the full
  /// method itself.
  std::optional<H1Table> against_full;
  CellIssuance issuance;
};

/// `cell` and `full` are tables of features of the same trials in the same order; `landmark_s` is
/// where the cell's time window closes, and pairs are compared from the later of the two landmarks.
/// Pass the same table twice for the full method. Rows of models are left out.
/// \throws FormulaError as `hypothesis_h1` does; std::invalid_argument if the trials differ.
/// O(replicates trials log trials).
[[nodiscard]] CellScores cell_scores(const table::DataTable& cell,
                                     const table::DataTable& full,
                                     double landmark_s,
                                     H1Options options);

}  // namespace tcert::study
