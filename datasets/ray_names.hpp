#pragma once
/// \file
/// Many rays in one line: what is said of a file's beams is said once.

#include <span>
#include <string>
#include <table/diagnostic.hpp>
#include <tcert/robot.hpp>
#include <vector>

namespace tcert {

/// "left_range_m, right_range_m" of up to three, "b000_range_m and 179 more" of more.
[[nodiscard]] std::string joined_names(std::span<const std::string> columns);

/// Joins what differs in nothing but which ray's reading, or which ray's force, it is about: one
/// line with the first place, the names joined and the counts added, where the first one stood.
[[nodiscard]] std::vector<table::Diagnostic> joined_over_rays(
    std::vector<table::Diagnostic> diagnostics, const Robot& robot);

}  // namespace tcert
