#pragma once
/// \file
/// The file of a witness: a path, what it proves, and what that rests on, so that another program
/// can check it. The format is described in lib/witness/README.md.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tcert/robot.hpp>
#include <witness/checker.hpp>
#include <witness/free_space.hpp>

#include "reports/table.hpp"
#include "reports/witnessed_edges.hpp"

namespace tcert {

struct WitnessDocument {
  std::optional<SyntheticLabel> synthetic;
  std::string trial_id;
  std::string log_sha256;  ///< Digest of the log's files, as in certificates.csv.
  Robot robot;
  Region start;
  Region goal;
  double pose_bridge_s = 0.0;
  witness::FreeSpaceOptions rule;  ///< Its max_cells is not written.
  witness::FreeCells cells;        ///< F_t.
  witness::Path path;              ///< From S to G; no piece if there is none.
  witness::Checked stated;         ///< Of the path; not refused.
  std::optional<WitnessedEdges> edges{};
};

/// The text is not a witness; what() says what was expected.
class WitnessFormatError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One JSON object of format "tcert-witness", version 1, with a final newline. Numbers are in
/// shortest round-trip form: reading back gives the same bits.
[[nodiscard]] std::string to_json(const WitnessDocument& document);

/// \throws WitnessFormatError; also if the digest of the free space is not that of its runs, or its
/// box holds more than `max_cells` cells.
[[nodiscard]] WitnessDocument witness_from_json(std::string_view text, std::size_t max_cells);

}  // namespace tcert
