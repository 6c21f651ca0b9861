#include <cstdio>
#include <stdexcept>
#include <string>
#include <terrain/limits.hpp>

namespace tcert::terrain {

void require_within(std::string_view name, double value) {
  const Limit limit = limit_of(name);
  if (is_within(limit, value)) {
    return;
  }
  std::array<char, 96> text{};
  std::snprintf(text.data(),
                text.size(),
                ": found %g, expected a number from %g to %g",
                value,
                limit.low,
                limit.high);
  throw std::invalid_argument(std::string(name) + text.data());
}

}  // namespace tcert::terrain
