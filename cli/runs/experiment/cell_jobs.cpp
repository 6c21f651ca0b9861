#include "cli/runs/experiment/cell_jobs.hpp"

#include <algorithm>
#include <tuple>

#include "analysis/study/experiment/fingerprint.hpp"

namespace tcert::cli {

Jobs jobs_of(std::span<const study::PlannedCell> cells) {
  /// A cell's wish for a table; equal series lie together, then features before replays.
  struct Wish {
    std::string series;
    TableKind kind;
    std::string print;
    std::size_t cell;
  };
  std::vector<Wish> wishes;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!cells[c].refused()) {
      const study::ParameterSet& set = cells[c].set();
      const std::string series = study::fingerprint(set, study::Stage::certify);
      wishes.push_back(
          {series, TableKind::features, study::fingerprint(set, study::Stage::features), c});
      wishes.push_back(
          {series, TableKind::replay, study::fingerprint(set, study::Stage::control), c});
    }
  }
  std::sort(wishes.begin(), wishes.end(), [](const Wish& a, const Wish& b) {
    return std::tie(a.series, a.kind, a.print, a.cell) <
           std::tie(b.series, b.kind, b.print, b.cell);
  });
  Jobs result;
  result.features_of.assign(cells.size(), kNoTable);
  result.replays_of = result.features_of;
  for (const Wish& wish : wishes) {
    if (result.jobs.empty() || result.jobs.back().kind != wish.kind ||
        result.jobs.back().print != wish.print) {
      result.jobs.push_back({wish.kind, &cells[wish.cell].set(), wish.print});
    }
    auto& of = wish.kind == TableKind::features ? result.features_of : result.replays_of;
    of[wish.cell] = result.jobs.size() - 1;
  }
  return result;
}

}  // namespace tcert::cli
