#pragma once
/// \file
/// Samples that say nothing: a row of a stream without a value is none of it.

#include <optional>
#include <table/csv.hpp>

#include "datasets/trial_reader.hpp"

namespace tcert {

/// Leaves out the rows in whose first `columns` nothing is known, and counts them. O(values).
void drop_empty_rows(table::NumberTable& table, std::size_t columns);

/// The samples that say something, if any says nothing; of a robot without rays all are kept.
/// O(readings) at most, O(samples) where all say something.
[[nodiscard]] std::optional<TactileStream> without_empty_samples(const TactileStream& stream);

}  // namespace tcert
