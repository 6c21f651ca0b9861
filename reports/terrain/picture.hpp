#pragma once
/// \file
/// Pictures of an exploration: the terrain, what is certified of it, and the robot in it.

#include <optional>
#include <string>
#include <terrain/explore.hpp>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

/// What one picture shows.
struct ExploreFrame {
  int step = 0;
  terrain::CellSet safe;       ///< Without blocked cells.
  terrain::CellSet expanders;  ///< Those that were considered.
  terrain::Position robot{0.0, 0.0};
  std::vector<terrain::Position> free_space;  ///< Local free space; empty: not drawn.
  std::optional<terrain::Cell> next;
  std::size_t path_points = 0;  ///< Of the way, how much has been gone.
};

/// Keeps frames spread over a run whose length is not known: at most 64 at any time.
class FrameKeeper {
 public:
  void add(ExploreFrame frame);

  /// `wanted` of them, evenly spaced over the steps, the first and the last among them; one is
  /// the last; all there are if there are fewer.
  [[nodiscard]] std::vector<ExploreFrame> evenly(std::size_t wanted) const;

 private:
  std::vector<ExploreFrame> kept_;
  std::optional<ExploreFrame> last_;
  int stride_ = 1;
};

/// SVG with the thesis' legend: white and gray is ground truth at or above, and below, the
/// threshold or not known; light blue the safe set, red the expanders considered, green the local
/// free space, and over it black the box round the safe set without the set; pink the next sample,
/// dark blue the goal. x runs to the right. The way is a thin line.
[[nodiscard]] std::string explore_picture(const terrain::Terrain& terrain,
                                          double threshold,
                                          const ExploreFrame& frame,
                                          const std::vector<terrain::Position>& path,
                                          std::optional<terrain::Cell> goal,
                                          const std::optional<SyntheticLabel>& synthetic);

}  // namespace tcert
