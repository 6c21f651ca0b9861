#pragma once
/// \file
/// A robot, a course and the ticks of its trials in one binary file, for programs that link the
/// core and nothing else.

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert::test_support {

struct TickFile {
  struct Trial {
    std::string id;
    std::vector<Tick> ticks;  ///< Their rays point into readings.
    std::vector<RayReading> readings;
  };
  Robot robot;
  Course course;
  std::optional<std::uint64_t> seed;  ///< Of synthetic ticks.
  std::vector<Trial> trials;
};

/// In the byte order of this machine.
void write_tick_file(std::ostream& out, const TickFile& file);

/// \throws std::runtime_error if the file is cut short.
[[nodiscard]] TickFile read_tick_file(std::istream& in);

}  // namespace tcert::test_support
