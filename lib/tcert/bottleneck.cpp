#include <tcert/bottleneck.hpp>
#include <tcert/corridor_walk.hpp>

namespace tcert {

std::optional<Bottleneck> bottleneck_of(const CorridorWalk& walk, double since_start_m) noexcept {
  const bool turns = walk.turning() && walk.through().sink() < walk.certificate_m(since_start_m);
  const WidestLabels& labels = turns ? *walk.turning() : walk.through();
  std::optional<Bottleneck> narrowest;
  EdgeEnd entered = labels.sink_end();
  while (entered.node != kNone) {
    const std::uint32_t index = labels.edge_into(entered.node, opposite(entered.side));
    if (index == kNone) {
      break;
    }
    const Edge& edge = walk.graph().edges()[index];
    const Certified& found = edge.certified;
    if (!narrowest || found.margin_m < narrowest->margin_m) {
      narrowest = {index, found.narrowest, found.margin_m, found.width_m, found.turn_radius_m};
    }
    // The path came along the edge from its other end, which it had entered by the other side. No
    // edge from a node to itself raises a label that has no sides.
    const bool is_first =
        edge.ends[0].node == entered.node && (edge.ends[0].side == entered.side || turns);
    const EdgeEnd from = is_first ? edge.ends[1] : edge.ends[0];
    entered = {from.node, opposite(from.side)};
  }
  if (narrowest) {
    narrowest->margin_m -= since_start_m;
  }
  if (turns && narrowest && narrowest->margin_m > 0.0) {
    narrowest->margin_m = 0.0;  // somewhere on the way it turned on the spot
    narrowest->turn_radius_m = 0.0;
  }
  return narrowest;
}

}  // namespace tcert
