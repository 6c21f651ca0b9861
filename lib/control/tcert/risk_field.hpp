#pragma once
/// \file
/// The risk field rho(x) of what was touched (paper 5): an intensity of obstacles per area, and its
/// integral along a way.

#include <array>
#include <cstddef>
#include <cstdint>
#include <tcert/geometry.hpp>
#include <tcert/parameter_fields.hpp>
#include <tcert/risk_intensity.hpp>
#include <tcert/robot.hpp>
#include <vector>

namespace tcert {

enum class RiskIntensity : std::uint8_t {
  gamma,   ///< gamma_intensity(): finite.
  lambda,  ///< lambda_intensity(), the prior where nothing was observed.
};

/// See parameters/risk.def.
struct RiskParameters {
#define TCERT_WORD TCERT_MEMBER_WORD
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <tcert/parameters/risk.def>
};

/// See parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const RiskParameters& /*list*/, Visit&& visit) {
  using Group = RiskParameters;
#define TCERT_WORD TCERT_VISIT_WORD
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <tcert/parameters/risk.def>
}

/// \throws std::invalid_argument naming the member that is out of range.
void validate(const RiskParameters& parameters);

/// That the work of a tick is bounded: the ways that are looked along and the body are at most
/// 1,000 cells long. \throws std::invalid_argument.
void validate(const RiskParameters& parameters, const Robot& robot);

/// Counts of hits and misses on a hash grid. Risk is soft: it shapes what the robot prefers within
/// what the certificate allows, and loosens nothing.
///
/// The constructor takes all memory; every other member is noexcept and allocates nothing. Times
/// are in seconds and never fall between two clears. What lies on the border of two cells belongs
/// by half to each, so that a mirrored run makes the mirrored field, to the last bit.
class RiskField {
 public:
  static constexpr std::int32_t kSide = 8;  ///< Cells along a side of a block.

  /// \throws std::invalid_argument if the parameters are out of range; std::bad_alloc.
  explicit RiskField(const RiskParameters& parameters);

  void clear() noexcept;

  /// A ray of `clear_m` from `from`: a miss in every cell that it crosses by half a cell or more,
  /// and if it `touches`, a hit in the cell of its tip instead of a miss there. O(cells crossed).
  void observe_ray(
      Point from, Point unit_direction, double clear_m, bool touches, double time_s) noexcept;

  /// The body stands here: a miss in every cell whose centre it covers.
  void observe_body(Point centre, double radius_m, double time_s) noexcept;

  /// What is counted in the cell of a point by now; zeros if nobody observed it.
  [[nodiscard]] CellCounts counts_at(Point at, double time_s) const noexcept;

  /// lambda of the cell of a point, 1/m^2.
  [[nodiscard]] double intensity_at(Point at, double time_s) const noexcept;

  /// Integral of lambda ds along a straight line, 1/m: times the width of the body it is the risk
  /// integral of paper 5. Exact, lambda being constant on cells. O(cells along the line).
  [[nodiscard]] double integral_along(Point from,
                                      Point unit_direction,
                                      double length_m,
                                      double time_s) const noexcept;

  /// 1 - exp(-integral of lambda dA) over the strip that a body of `width_m` sweeps along a
  /// straight line. The integral is exact along the way, by midpoints at most a cell apart across
  /// it.
  [[nodiscard]] double collision_probability(Point from,
                                             Point unit_direction,
                                             double length_m,
                                             double width_m,
                                             double time_s) const noexcept;

  /// True once an observation found no room, until the next clear.
  [[nodiscard]] bool is_full() const noexcept { return full_; }

 private:
  struct Block {
    std::int32_t bx = 0;
    std::int32_t by = 0;
    double halvings = -1.0;  // time of the counts in half-lives; negative: not used
    std::array<double, std::size_t{kSide} * kSide> hits{};
    std::array<double, std::size_t{kSide} * kSide> misses{};
  };
  [[nodiscard]] std::size_t slot_of(std::int32_t bx, std::int32_t by) const noexcept;
  [[nodiscard]] const Block* find(std::int32_t bx, std::int32_t by) const noexcept;
  [[nodiscard]] Block* claim(std::int32_t bx, std::int32_t by, double halvings) noexcept;
  void count(
      std::int32_t column, std::int32_t row, double hits, double misses, double halvings) noexcept;
  [[nodiscard]] CellCounts counts_of(std::int32_t column,
                                     std::int32_t row,
                                     double halvings) const noexcept;
  [[nodiscard]] double intensity_of(const CellCounts& counts) const noexcept;
  [[nodiscard]] double halvings_at(double time_s) const noexcept {
    return time_s / parameters_.half_life_s;
  }
  [[nodiscard]] bool is_far(Point at, double length_m) const noexcept;

  RiskParameters parameters_;
  std::vector<Block> blocks_;  // a power of two
  std::size_t used_ = 0;
  bool full_ = false;
};

}  // namespace tcert
