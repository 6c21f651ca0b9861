#pragma once
/// \file
/// Rays whose names say another side than their place.

#include <optional>
#include <table/diagnostic.hpp>
#include <tcert/robot.hpp>

namespace tcert {

/// A warning of rays that are called left and look to the right, or the other way round, by mount
/// and bearing: x is ahead, y to the left, bearings anticlockwise. A crossed ray, mounted on one
/// side and looking to the other, is left alone. O(rays).
[[nodiscard]] std::optional<table::Diagnostic> check_sides(const Robot& robot);

}  // namespace tcert
