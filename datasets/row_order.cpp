#include "datasets/row_order.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace tcert {
namespace {

/// The same bits, so that two missing values are equal.
bool equal_rows(const table::NumberTable& table, std::size_t a, std::size_t b) {
  for (std::size_t c = 0; c < table.columns; ++c) {
    if (std::bit_cast<std::uint64_t>(table.at(a, c)) !=
        std::bit_cast<std::uint64_t>(table.at(b, c))) {
      return false;
    }
  }
  return true;
}

std::uint64_t hash_of_row(const table::NumberTable& table, std::size_t row) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (std::size_t c = 0; c < table.columns; ++c) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(table.at(row, c))) * 0x100000001b3U;
    hash ^= hash >> 29U;
  }
  return hash;
}

/// Finds rows that equal an earlier one of the same time; times come in order.
class Duplicates {
 public:
  explicit Duplicates(const table::NumberTable& table) : table_(table) {}

  [[nodiscard]] bool has_seen(std::size_t row) {
    if (count_ == 0 || table_.time_ns[row] != time_ns_) {
      time_ns_ = table_.time_ns[row];
      first_ = row;
      count_ = 1;
      seen_.clear();
      return false;
    }
    if (count_++ == 1) {
      seen_.emplace(hash_of_row(table_, first_), first_);
    }
    const std::uint64_t hash = hash_of_row(table_, row);
    const auto [begin, end] = seen_.equal_range(hash);
    for (auto earlier = begin; earlier != end; ++earlier) {
      if (equal_rows(table_, earlier->second, row)) {
        return true;
      }
    }
    seen_.emplace(hash, row);
    return false;
  }

  /// The next row has a stretch of its own.
  void restart() { count_ = 0; }

 private:
  const table::NumberTable& table_;
  std::int64_t time_ns_ = 0;
  std::size_t first_ = 0;
  std::size_t count_ = 0;  // rows of this time
  std::unordered_multimap<std::uint64_t, std::size_t> seen_;
};

void append_row(const table::NumberTable& from,
                std::size_t row,
                std::int64_t ahead_ns,
                table::NumberTable& to) {
  to.time_ns.push_back(from.time_ns[row] + ahead_ns);
  to.lines.push_back(from.lines[row]);
  const auto first = from.values.begin() + static_cast<std::ptrdiff_t>(row * from.columns);
  to.values.insert(to.values.end(), first, first + static_cast<std::ptrdiff_t>(from.columns));
}

/// Counts the rows that have the time of the row before them.
void count_shared(OrderedRows& out) {
  const std::vector<std::int64_t>& times = out.table.time_ns;
  for (std::size_t row = 1; row < times.size(); ++row) {
    if (times[row] == times[row - 1]) {
      out.first_shared = out.shared == 0 ? row : out.first_shared;
      ++out.shared;
    }
  }
  constexpr std::int64_t kSecond = 1'000'000'000;
  out.shares_whole_seconds =
      10 * out.shared > times.size() &&
      std::ranges::all_of(times, [](std::int64_t time) { return time % kSecond == 0; });
}

}  // namespace

OrderedRows ordered_rows(const table::NumberTable& table,
                         std::span<const ClockStep> steps,
                         std::span<const std::int64_t> shifts) {
  OrderedRows out;
  out.table.columns = table.columns;
  out.table.present = table.present;
  out.table.empty_rows = table.empty_rows;
  Duplicates duplicates(table);
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k <= steps.size(); ++k) {
    const std::size_t begin = k == 0 ? 0 : steps[k - 1].row;
    const std::size_t end = k == steps.size() ? table.rows() : steps[k].row;
    const std::int64_t ahead_ns = k == 0 ? 0 : shifts[k - 1];
    order.resize(end - begin);
    std::iota(order.begin(), order.end(), begin);
    std::ranges::stable_sort(order, {}, [&](std::size_t row) { return table.time_ns[row]; });
    duplicates.restart();
    for (const std::size_t row : order) {
      if (duplicates.has_seen(row)) {
        out.first_merged_line = out.merged == 0 ? table.lines[row] : out.first_merged_line;
        ++out.merged;
      } else {
        append_row(table, row, ahead_ns, out.table);
      }
    }
  }
  count_shared(out);
  return out;
}

}  // namespace tcert
