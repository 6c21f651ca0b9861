#pragma once
/// \file
/// What a policy is made from.

#include <tcert/course_line.hpp>
#include <tcert/parameters.hpp>
#include <tcert/policy_parameters.hpp>
#include <tcert/risk_field.hpp>
#include <tcert/robot.hpp>

namespace tcert::policies {

struct PolicySetup {
  Robot robot;  ///< R_min = 0 is a robot that turns on the spot; any other keeps its radius.
  CourseLine line;
  CertificateParameters certificate;  ///< Of contacts and of the contact memory.
  PolicyParameters parameters;
  double control_period_s = 0.02;  ///< Time between two steps.
  RiskParameters risk{};           ///< Used where lambda_weight is above 0.
};

/// Rays of a robot that a policy can use: sums over them are exact.
inline constexpr std::size_t kMostRays = 64;

/// Each part by itself, and what sizes a table or the work of a step in proportion.
/// \throws std::invalid_argument naming the value and what it must be.
void validate(const PolicySetup& setup);

}  // namespace tcert::policies
