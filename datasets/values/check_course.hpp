#pragma once
/// \file
/// Trials that do not lie on their course.

#include <optional>
#include <table/diagnostic.hpp>
#include <tcert/robot.hpp>
#include <vector>

#include "datasets/ticks.hpp"
#include "datasets/values/value_finding.hpp"

namespace tcert {

/// A first fresh pose outside S, and a success of which no fresh pose lies in G, each with the
/// distance in metres. O(ticks x vertices) for the second, O(vertices) for a run that ends in G.
[[nodiscard]] std::vector<ValueFinding> check_course(const Course& course,
                                                     const std::optional<bool>& success,
                                                     const TickTable& ticks);

/// A note if the course has no G: then there is never a certificate T_t.
[[nodiscard]] std::optional<table::Diagnostic> check_goal_is_known(const Course& course);

}  // namespace tcert
