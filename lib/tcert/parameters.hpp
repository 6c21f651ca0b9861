#pragma once
/// \file
/// Parameters of the certificate. Every ablation and sweep is another value of these.

#include <cstdint>
#include <numbers>
#include <tcert/parameter_fields.hpp>

namespace tcert {

/// How the free width at a tick is read from the two sides.
enum class ClearanceReading {
  width,    ///< left + right: the width across the heading.
  radial,   ///< 2 min(left, right): the disc centred on the robot.
  swept,    ///< T_t by the disc that fits into the swept area; what a tick says at once by width.
  witness,  ///< As width, but T_t is left to a path that is found and checked after the run.
};

/// How the turn radius at a tick is read (paper 3.1, P2).
enum class CurvatureReading {
  path,             ///< From the executed path.
  contact,          ///< From three contacts of one ray, the wall's side accounted for.
  contact_literal,  ///< From three contacts as the paper prints it; for sensitivity only.
  none,             ///< Ablation A3: no curvature constraint.
};

/// What unprobed space is taken for (paper 3.3, A2).
enum class UnknownSpace {
  occupied,  ///< Pessimistic: a sound lower bound.
  free,      ///< Ablation A2: free until contradicted.
};

/// Whether slope, step and slip bound the margin (paper 2.1, Remark 1).
enum class FootingReading {
  felt,     ///< Where the log has them.
  ignored,  ///< Ablation A4: the plane alone.
};

/// Names, defaults, bounds and what each is for: parameters/certificate.def.
struct CertificateParameters {
#define TCERT_WORD TCERT_MEMBER_WORD
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <tcert/parameters/certificate.def>
};

/// See parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const CertificateParameters& /*list*/, Visit&& visit) {
  using Group = CertificateParameters;
#define TCERT_WORD TCERT_VISIT_WORD
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <tcert/parameters/certificate.def>
}

/// Each within its bounds, and those that together size a table or the work of a tick in
/// proportion. \throws std::invalid_argument naming the parameter, its value and what it must be.
void validate(const CertificateParameters& parameters);

struct Robot;
/// The same for a robot with these parameters: what the certifier asks for.
void validate(const Robot& robot, const CertificateParameters& parameters);

}  // namespace tcert
