#pragma once
/// \file
/// The names of files in the metadata.yaml of rosbag2, which is read for nothing else.

#include <string>
#include <string_view>
#include <vector>

namespace tcert::recording {

/// The entries of `relative_file_paths`, as a list of lines "- name" or in brackets, quoted or not;
/// none if the text has no such key.
[[nodiscard]] std::vector<std::string> relative_file_paths(std::string_view yaml);

/// Less if `a` stands before `b` where people count: "bag_2.db3" before "bag_10.db3".
[[nodiscard]] bool counts_before(std::string_view a, std::string_view b) noexcept;

}  // namespace tcert::recording
