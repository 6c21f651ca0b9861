#pragma once
/// \file
/// Stamps in which seconds and nanoseconds were joined by a point, without the zeros before the
/// nanoseconds: 100.50000003 for 100 s and 50,000,003 ns.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <table/bytes.hpp>
#include <table/csv_header.hpp>
#include <vector>

namespace tcert {

/// What such stamps say: the times of the rows that begin at `lines`, in nanoseconds. Nothing
/// unless there are ten rows and more, all are written as digits, a point and up to nine digits,
/// nine in most, and rise strictly if they are read so. Asked where they do not rise as decimals:
/// then they are such stamps. O(size of the file).
[[nodiscard]] std::optional<std::vector<std::int64_t>> joined_seconds(
    const table::Bytes& bytes,
    const table::CsvOptions& csv,
    const std::string& time_column,
    std::span<const std::uint32_t> lines);

}  // namespace tcert
