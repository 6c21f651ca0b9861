#pragma once
/// \file
/// The text of one stream of a trial with faults in it.

#include <cstdint>
#include <string>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/perturb/fault.hpp"

namespace tcert::perturb {

struct StreamText {
  const table::Bytes& bytes;     ///< Of a file that the reader takes, in order of time.
  const table::CsvOptions& csv;  ///< As it is read.
  const table::NumberOptions& columns;
  std::int64_t first_ns = 0;  ///< Times of its first and its last sample, which are never lost.
  std::int64_t last_ns = 0;
  bool is_merged = false;  ///< ticks.csv: a tick stays, and what is lost are the rays' cells in it.
};

struct PerturbedText {
  std::string text;         ///< With the columns that it had, and arrival_s where it is late.
  std::size_t samples = 0;  ///< Rows that the stream had.
};

/// Rows without a fault stay byte for byte, and so do the cells of the others that no fault is in;
/// times are never changed. `faults`, in order of start, get the number of samples that they met,
/// and a freeze the reading that it held. O(size).
///
/// What a fault does to a ray that has no reading in a sample, and to a force that is not stated,
/// is nothing. A bias is one of clearance: it goes through the calibration of a bend, and stays
/// within what the ray can state; of a range that says "nothing within reach" nothing is changed.
[[nodiscard]] PerturbedText perturb_stream(const StreamText& stream,
                                           const BundleInfo& info,
                                           double wide_share,
                                           std::vector<Injection>& faults);

}  // namespace tcert::perturb
