#pragma once
/// \file
/// The edges of a corridor graph in the file of a witness.

#include <nlohmann/json.hpp>
#include <witness/free_cells.hpp>

#include "reports/witnessed_edges.hpp"

namespace tcert {

[[nodiscard]] nlohmann::ordered_json edges_json(const WitnessedEdges& edges);

/// \throws WitnessFormatError, or what the JSON library throws, if it is none.
[[nodiscard]] WitnessedEdges edges_from(const nlohmann::ordered_json& json,
                                        const witness::Lattice& lattice);

}  // namespace tcert
