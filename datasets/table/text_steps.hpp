#pragma once
/// \file
/// Small steps through a text. Internal to the readers of times.

#include <cstddef>
#include <string_view>
#include <table/decimal.hpp>

namespace tcert::table {

/// Takes a number of `least` to `most` digits from the front of `rest`; false if there are fewer.
inline bool take_number(std::string_view& rest,
                        std::size_t least,
                        std::size_t most,
                        int& value) noexcept {
  std::size_t count = 0;
  value = 0;
  while (count < most && count < rest.size() && decimal_detail::is_digit(rest[count])) {
    value = value * 10 + (rest[count] - '0');
    ++count;
  }
  rest.remove_prefix(count);
  return count >= least;
}

/// Takes one of the characters from the front of `rest`; false if it is none of them.
inline bool take_one_of(std::string_view& rest, std::string_view characters) noexcept {
  if (rest.empty() || characters.find(rest.front()) == std::string_view::npos) {
    return false;
  }
  rest.remove_prefix(1);
  return true;
}

}  // namespace tcert::table
