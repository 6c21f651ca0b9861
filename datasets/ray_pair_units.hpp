#pragma once
/// \file
/// Whether bends are in radians and clearances in metres.

#include <cstddef>
#include <string>
#include <table/diagnostic.hpp>

namespace tcert {

/// Looks at each pair, and says at the end what cannot be in its unit: an error if it is more than
/// a fifth of the pairs, else a warning. A negative clearance is a warning.
class RayPairUnits {
 public:
  RayPairUnits();

  /// `bend` and `clearance` are the cells that hold the two numbers.
  void look_at(double bend_rad,
               double clearance_m,
               std::size_t line,
               const std::string& bend,
               const std::string& clearance);

  void say(const std::string& file, table::DiagnosticGroups& problems) const;

 private:
  struct Odd {
    const char* column;
    const char* expectation;
    bool is_unit;  ///< Another unit would explain it.
    std::size_t count = 0;
    std::size_t line = 0;  ///< Of the first.
    std::string value;

    void add(std::size_t at, const std::string& cell);
  };

  Odd bend_;
  Odd clearance_;
  Odd negative_;
  std::size_t pairs_ = 0;
};

}  // namespace tcert
