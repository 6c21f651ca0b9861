#pragma once
/// \file
/// Submaps as text, for robots that exchange them.
///
/// Lines of cells with a comma between two, in this order; `#` begins a comment, empty lines count
/// for nothing, lines may end with CR LF. Numbers are decimal, in m and rad, in shortest digits
/// that read back as the same.
///
///     tcert-submap,1                format and version
///     synthetic,SEED                if the data are; - without one, several of more
///     agent,BODY_WIDTH,MIN_TURN_RADIUS,TRACKING_BUFFER,CURVATURE_BUFFER
///     source,NAME,KIND,FRAME_ERROR_M,FRAME_ERROR_RAD
///                                   KIND: witness, swept, radial or width; an error -: not known
///     node,X,Y,YAW,PLACE,MARGIN     of the source above; S, G, SG or -; a margin -: of its edges
///     edge,NODE,SIDE,NODE,SIDE,MARGIN,SPREAD
///                                   nodes of the source, from 0; front or back; a spread -: not
///                                   known
///
/// What is read is bounded: kMostBytes, and a node or an edge a line.

#include <federation/submap.hpp>
#include <string_view>

namespace tcert::federation {

inline constexpr std::size_t kMostBytes = std::size_t{1} << 26U;

/// Why a text is no submap.
struct TextProblem {
  std::size_t line = 0;    ///< From 1.
  std::size_t column = 0;  ///< Cell in the line, from 1; 0: the line as a whole.
  std::string found;       ///< At most 80 characters of it.
  std::string expected;
};

/// "line 3, cell 2: found 'x', expected ...".
[[nodiscard]] std::string to_string(const TextProblem& problem);

struct ReadSubmap {
  std::optional<Submap> submap;  ///< In order; empty if there is a problem.
  TextProblem problem;           ///< The first.
};

/// O(n log n). Throws nothing but std::bad_alloc.
[[nodiscard]] ReadSubmap read_submap(std::string_view text);

/// \pre it is in order.
[[nodiscard]] std::string to_text(const Submap& submap);

}  // namespace tcert::federation
