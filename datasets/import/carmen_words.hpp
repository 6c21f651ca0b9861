#pragma once
/// \file
/// The words of one record of a CARMEN log, one after another.

#include <optional>
#include <string>
#include <string_view>
#include <tcert/geometry.hpp>

namespace tcert {

inline constexpr std::size_t kMostCarmenBeams = 4096;

/// What a record lacks: the field, the word in its place, what it should have been.
struct CarmenFault {
  std::string field;
  std::string value;
  std::string expectation;
};

/// The first word of a line, taken off it; empty for a blank line.
[[nodiscard]] std::string_view take_word(std::string_view& line) noexcept;

/// Reads up to the first word that is wrong; what comes after it is left as it was. The line lies
/// in a table::Bytes.
class CarmenWords {
 public:
  explicit CarmenWords(std::string_view rest) noexcept : rest_(rest) {}

  /// The next word, whatever it is; empty at the end of the line.
  std::string_view text() noexcept;

  void number(const char* field, double& value);

  /// What `holds` says is right with the number, `expectation` says in words.
  template <class Holds>
  void number(const char* field, double& value, const Holds& holds, const char* expectation) {
    number(field, value);
    require(holds(value), field, expectation);
  }

  /// A whole number from `least` to kMostCarmenBeams; 0 after a fault.
  [[nodiscard]] std::size_t count(const char* field, double least, const char* expectation);

  /// Metres, 0 or more; `inf` is infinite, `-inf` 0 and `nan` NaN.
  void range(double& value);

  /// Three numbers, at most kLargestPose in size.
  void pose(const char* x, const char* y, const char* theta, Pose& pose);

  /// Unless `holds`, the word that was read last is wrong, or `value`, which was read before.
  void require(bool holds, const char* field, const char* expectation, std::string value = {});

  [[nodiscard]] const std::optional<CarmenFault>& fault() const noexcept { return fault_; }

 private:
  [[nodiscard]] bool scanned(double& value) const noexcept;

  std::string_view rest_;
  std::string_view word_;
  std::optional<CarmenFault> fault_;
};

}  // namespace tcert
