#pragma once
/// \file
/// The risk field of a policy (paper 5): what its headings cost by the chance of meeting something.

#include <cstdint>
#include <tcert/felt_rays.hpp>
#include <tcert/headings.hpp>
#include <tcert/policy_setup.hpp>
#include <tcert/risk_field.hpp>

namespace tcert::policies {

/// Observes every memory_period_s what the rays feel and where the body stands. The constructor
/// takes all memory; every other member is noexcept.
class FeltRisk {
 public:
  /// \throws std::invalid_argument if the risk parameters are out of range.
  explicit FeltRisk(const PolicySetup& setup);

  void reset() noexcept;

  /// One control step at a usable pose.
  void take(const BodyFrame& body, std::span<const FeltRay> rays, std::int64_t time_ns) noexcept;

  /// Adds w_r times the integral of rho ds over risk_ahead_m along each heading, rho = lambda w_B.
  void add_cost(HeadingCosts& costs, const BodyFrame& body) const noexcept;

  [[nodiscard]] const RiskField& field() const noexcept { return field_; }

 private:
  RiskField field_;
  double weight_m_;  // w_r w_B
  double ahead_m_;
  double half_width_m_;
  std::uint32_t every_;  // steps
  std::uint32_t step_ = 0;
  bool began_ = false;
  std::int64_t first_ns_ = 0;
  double time_s_ = 0.0;
};

}  // namespace tcert::policies
