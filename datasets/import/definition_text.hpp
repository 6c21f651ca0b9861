#pragma once
/// \file
/// The text of a message definition, as far as one line tells.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/import/message_type.hpp"

namespace tcert::recording {

/// Definitions longer than this are refused; the longest public ones have some 50 kB.
inline constexpr std::size_t kLongestDefinition = std::size_t{1} << 20U;

/// The text of a definition file, cut at its lines of '='. Views into that text.
struct DefinitionSections {
  std::string_view root;
  std::map<std::string, std::string_view> nested;  ///< By canonical name.
};

/// \returns nothing, with the reason in `problem`, if a part is not named "MSG: pkg/Type".
[[nodiscard]] std::optional<DefinitionSections> definition_sections(std::string_view text,
                                                                    std::string& problem);

/// A field whose type is still a name.
struct RawField {
  std::string type;  ///< "float64", "geometry_msgs/Pose", "Pose"; without array and string bounds.
  std::string name;
  Arity arity = Arity::scalar;
  std::size_t count = 0;
};

/// The fields of one section; comments, constants and defaults are passed over.
/// \returns nothing, with the reason and the line in `problem`, if a line is no field.
[[nodiscard]] std::optional<std::vector<RawField>> raw_fields(std::string_view section,
                                                              std::string& problem);

}  // namespace tcert::recording
