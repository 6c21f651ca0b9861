#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <tcert/parameter_fields.hpp>

namespace tcert {
std::string to_text(double value) {
  std::array<char, 32> text{};
  char* const last = text.data() + text.size();
  const bool plain = std::abs(value) >= 1e-6 && std::abs(value) < 1e9;
  const char* const end =
      plain ? std::to_chars(text.data(), last, value, std::chars_format::fixed).ptr
            : std::to_chars(text.data(), last, value).ptr;
  return {text.data(), static_cast<std::size_t>(end - text.data())};
}

std::string to_string(const FieldBounds& bounds) {
  return bounds.low_allowed ? "from " + to_text(bounds.low) + " to " + to_text(bounds.high)
                            : "above " + to_text(bounds.low) + ", at most " + to_text(bounds.high);
}

void require_in_bounds(const NumberField& field, double value) {
  if (!field.bounds.contain(value)) {
    throw std::invalid_argument(std::string(field.key) + " is " + to_text(value) + "; it must be " +
                                to_string(field.bounds));
  }
}

void require_known(const WordField& field, int value) {
  const auto last = static_cast<int>(std::count(field.words.begin(), field.words.end(), ' '));
  if (value < 0 || value > last) {
    throw std::invalid_argument(std::string(field.key) + " is " + std::to_string(value) +
                                "; it must be from 0 to " + std::to_string(last));
  }
}

}  // namespace tcert
