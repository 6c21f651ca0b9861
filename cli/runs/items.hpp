#pragma once
/// \file
/// Work that falls into numbered items, so that it can be done in pieces, on any number of
/// machines, and come to the same.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/runs/progress.hpp"

namespace tcert::cli {

/// Items of one sort. What item k gives is a line of text without line feed that depends on the
/// request and on k alone: neither on what else is made nor on the machine.
struct ItemSet {
  std::string name;  ///< "mixed worlds": what the items are.
  std::uint64_t count = 0;
  std::uint64_t together = 0;  ///< How many are best made in one call, at least 1.
  /// The lines of items first ... last - 1, in parallel if there is something to be won by it.
  /// `done` may be called after each item, by any thread, of those that take long.
  std::function<std::vector<std::string>(
      std::uint64_t first, std::uint64_t last, const std::function<void()>& done)>
      make;
};

/// A set whose items are made one by one, in parallel. `make` is called by several threads.
[[nodiscard]] ItemSet independent_items(std::string name,
                                        std::uint64_t count,
                                        std::function<std::string(std::uint64_t item)> make);

/// Hears of every item of every set, in order.
using TakeItem = std::function<void(std::size_t set, std::uint64_t item, std::string_view line)>;

/// Gives every item to `take`: makes it, or has it from where it was made before.
using ItemSource = std::function<void(const std::vector<ItemSet>& sets, const TakeItem& take)>;

/// Makes all items here and now.
[[nodiscard]] ItemSource made_here(Progress& progress);

/// Items of all sets, counted through: [first, last).
struct ItemRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  friend bool operator==(const ItemRange&, const ItemRange&) = default;
};

[[nodiscard]] std::uint64_t count_of(const std::vector<ItemSet>& sets) noexcept;

/// Makes the items of the range; `item` counts through all sets.
void make_items(const std::vector<ItemSet>& sets,
                ItemRange range,
                Progress& progress,
                const std::function<void(std::uint64_t item, std::string_view line)>& take);

/// Tells which item of which set an item is, counted through.
struct ItemPlace {
  std::size_t set = 0;
  std::uint64_t item = 0;
};
/// \pre item < count_of(sets).
[[nodiscard]] ItemPlace place_of(const std::vector<ItemSet>& sets, std::uint64_t item) noexcept;

}  // namespace tcert::cli
