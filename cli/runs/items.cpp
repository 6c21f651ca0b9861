#include "cli/runs/items.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace tcert::cli {
namespace {

/// Items whose lines are held at a time.
constexpr std::uint64_t kTogether = 1000;

}  // namespace

ItemSet independent_items(std::string name,
                          std::uint64_t count,
                          std::function<std::string(std::uint64_t item)> make) {
  const auto all = [make = std::move(make)](
                       std::uint64_t first, std::uint64_t last, const std::function<void()>& done) {
    std::vector<std::string> lines(last - first);
    using Range = tbb::blocked_range<std::uint64_t>;
    tbb::parallel_for(Range(first, last, 1), [&](const Range& range) {
      for (std::uint64_t item = range.begin(); item < range.end(); ++item) {
        lines[item - first] = make(item);
        done();
      }
    });
    return lines;
  };
  return {std::move(name), count, kTogether, all};
}

std::uint64_t count_of(const std::vector<ItemSet>& sets) noexcept {
  std::uint64_t count = 0;
  for (const ItemSet& set : sets) {
    count += set.count;
  }
  return count;
}

ItemPlace place_of(const std::vector<ItemSet>& sets, std::uint64_t item) noexcept {
  std::size_t set = 0;
  while (item >= sets[set].count) {
    item -= sets[set++].count;
  }
  return {set, item};
}

void make_items(const std::vector<ItemSet>& sets,
                ItemRange range,
                Progress& progress,
                const std::function<void(std::uint64_t item, std::string_view line)>& take) {
  std::uint64_t before = 0;
  for (const ItemSet& set : sets) {
    const std::uint64_t first = std::max(range.first, before) - before;
    const std::uint64_t last = std::min(std::max(range.last, before) - before, set.count);
    if (first < last) {
      Stage stage(progress, set.name, last - first);
      std::mutex counting;
      std::uint64_t count = 0;
      const auto done = [&] {
        const std::lock_guard lock(counting);
        stage.reach(++count);
      };
      for (std::uint64_t from = first; from < last;) {
        const std::uint64_t to = std::min(last, from + set.together);
        for (const std::string& line : set.make(from, to, done)) {
          take(before + from++, line);
        }
        count = from - first;
        stage.reach(count);
      }
    }
    before += set.count;
  }
}

ItemSource made_here(Progress& progress) {
  return [&progress](const std::vector<ItemSet>& sets, const TakeItem& take) {
    make_items(sets, {0, count_of(sets)}, progress, [&](std::uint64_t item, std::string_view line) {
      const ItemPlace place = place_of(sets, item);
      take(place.set, place.item, line);
    });
  };
}

}  // namespace tcert::cli
