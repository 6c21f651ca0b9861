#include "datasets/ray_names.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "datasets/tick_columns.hpp"

namespace tcert {
namespace {

constexpr std::size_t kMostNamed = 3;

enum class ColumnOfRay { bend, range, force };

std::unordered_map<std::string, ColumnOfRay> columns_of_rays(const Robot& robot) {
  std::unordered_map<std::string, ColumnOfRay> columns;
  for (const Ray& ray : robot.rays) {
    columns.emplace(value_column(ray),
                    ray.kind == RayKind::bend ? ColumnOfRay::bend : ColumnOfRay::range);
    columns.emplace(force_column(ray), ColumnOfRay::force);
  }
  return columns;
}

}  // namespace

std::string joined_names(std::span<const std::string> columns) {
  if (columns.size() > kMostNamed) {
    return columns.front() + " and " + std::to_string(columns.size() - 1) + " more";
  }
  std::string names;
  for (const std::string& column : columns) {
    names += (names.empty() ? "" : ", ") + column;
  }
  return names;
}

std::vector<table::Diagnostic> joined_over_rays(std::vector<table::Diagnostic> diagnostics,
                                                const Robot& robot) {
  if (diagnostics.size() < 2) {
    return diagnostics;
  }
  using Kind = std::tuple<table::Severity, std::string, std::string, ColumnOfRay>;
  struct Group {
    std::size_t place = 0;  // in `joined`
    std::vector<std::string> columns;
  };
  const auto known = columns_of_rays(robot);
  std::vector<table::Diagnostic> joined;
  std::map<Kind, Group> groups;
  for (table::Diagnostic& one : diagnostics) {
    const auto column = known.find(one.column);
    if (column == known.end()) {
      joined.push_back(std::move(one));
      continue;
    }
    const auto [group, is_new] = groups.try_emplace(
        Kind{one.severity, one.file, one.expectation, column->second}, Group{joined.size(), {}});
    group->second.columns.push_back(one.column);
    if (is_new) {
      joined.push_back(std::move(one));
      continue;
    }
    table::Diagnostic& first = joined[group->second.place];
    first.count += one.count;
    if (one.line < first.line) {
      first.line = one.line;
      first.value = std::move(one.value);
    }
  }
  for (const auto& [kind, group] : groups) {
    joined[group.place].column = joined_names(group.columns);
  }
  return joined;
}

}  // namespace tcert
