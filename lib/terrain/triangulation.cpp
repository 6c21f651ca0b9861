#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <terrain/triangulation.hpp>
#include <utility>

namespace tcert::terrain {
namespace {

[[nodiscard]] bool within(const Position& p,
                          const Position& a,
                          const Position& b,
                          const Position& c) {
  return doubled_area(a, b, p) >= 0.0 && doubled_area(b, c, p) >= 0.0 &&
         doubled_area(c, a, p) >= 0.0;
}

}  // namespace

double doubled_area(const Position& a, const Position& b, const Position& c) noexcept {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

std::vector<Triangle> ear_clipping(const std::vector<Position>& polygon) {
  std::vector<Triangle> triangles;
  if (polygon.size() < 3) {
    return triangles;
  }
  std::vector<std::size_t> left(polygon.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  const auto is_ear = [&](std::size_t k) {
    const std::size_t n = left.size();
    const Position& a = polygon[left[(k + n - 1) % n]];
    const Position& b = polygon[left[k]];
    const Position& c = polygon[left[(k + 1) % n]];
    if (!(doubled_area(a, b, c) > 0.0)) {
      return false;
    }
    return std::none_of(left.begin(), left.end(), [&](std::size_t other) {
      const Position& p = polygon[other];
      return p != a && p != b && p != c && within(p, a, b, c);
    });
  };
  std::size_t at = 0;
  while (left.size() > 3) {
    std::size_t tried = 0;
    while (tried < left.size() && !is_ear(at % left.size())) {
      ++at;
      ++tried;
    }
    if (tried == left.size()) {
      return {};
    }
    const std::size_t n = left.size();
    const std::size_t k = at % n;
    triangles.push_back({left[(k + n - 1) % n], left[k], left[(k + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
    at = k;  // the next corner moved here
  }
  if (doubled_area(polygon[left[0]], polygon[left[1]], polygon[left[2]]) > 0.0) {
    triangles.push_back({left[0], left[1], left[2]});
  }
  return triangles;
}

std::vector<TreeTriangle> triangle_tree(const std::vector<Triangle>& triangles, std::size_t root) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> owner;  // of a directed edge
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      owner[{triangles[t][k], triangles[t][(k + 1) % 3]}] = t;
    }
  }
  struct Found {
    std::size_t triangle;
    TreeTriangle node;
  };
  std::vector<Found> found{{root, {triangles[root], 0, 0}}};
  std::vector<std::uint8_t> seen(triangles.size(), 0);
  seen[root] = 1;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Triangle corners = triangles[found[i].triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = corners[k];
      const std::size_t b = corners[(k + 1) % 3];
      const auto next = owner.find({b, a});
      if (next == owner.end() || seen[next->second] != 0) {
        continue;
      }
      seen[next->second] = 1;
      Triangle child = triangles[next->second];
      while (child[0] != b) {
        std::rotate(child.begin(), child.begin() + 1, child.end());
      }
      found.push_back({next->second, {child, i, found[i].node.depth + 1}});
    }
  }
  // Breadth-first order reversed: deepest first, the root last.
  const std::size_t last = found.size() - 1;
  std::vector<TreeTriangle> tree;
  for (std::size_t i = found.size(); i-- > 0;) {
    tree.push_back(found[i].node);
    tree.back().parent = last - found[i].node.parent;
  }
  return tree;
}

}  // namespace tcert::terrain
