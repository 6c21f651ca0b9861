#pragma once
/// \file
/// Union-find that knows the parity of the path between any two members of a set.

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace tcert::study {

class ParitySets {
 public:
  explicit ParitySets(std::size_t count) : parent_(count), odd_(count, false), size_(count, 1) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// Adds an edge. False if it closes a cycle with an odd number of odd edges; nothing changes
  /// then.
  [[nodiscard]] bool join(std::size_t a, std::size_t b, bool odd) {
    const auto [root_a, odd_a] = find(a);
    const auto [root_b, odd_b] = find(b);
    if (root_a == root_b) {
      return (odd_a != odd_b) == odd;
    }
    const bool a_below = size_[root_a] < size_[root_b];
    const std::size_t child = a_below ? root_a : root_b;
    const std::size_t root = a_below ? root_b : root_a;
    parent_[child] = root;
    odd_[child] = (odd_a != odd_b) != odd;
    size_[root] += size_[child];
    return true;
  }

 private:
  /// Root, and the parity of the path to it.
  [[nodiscard]] std::pair<std::size_t, bool> find(std::size_t node) const {
    bool odd = false;
    while (parent_[node] != node) {
      odd = odd != odd_[node];
      node = parent_[node];
    }
    return {node, odd};
  }

  std::vector<std::size_t> parent_;
  std::vector<bool> odd_;  // of the edge to the parent
  std::vector<std::size_t> size_;
};

}  // namespace tcert::study
