#pragma once
/// \file
/// What the parameter lists (parameters/*.def) say of each parameter, and the check of a value
/// against it.

#include <string>
#include <string_view>
#include <type_traits>

namespace tcert {

/// The values that a parameter may have: between `low` and `high`, `low` itself only if
/// `low_allowed`. Every parameter has both, so that no value asks for more memory or work than a
/// machine has.
struct FieldBounds {
  double low;
  double high;
  bool low_allowed;
  /// False for NaN.
  [[nodiscard]] constexpr bool contain(double value) const noexcept {
    return (low_allowed ? value >= low : value > low) && value <= high;
  }
};
[[nodiscard]] constexpr FieldBounds from(double low, double high) noexcept {
  return {low, high, true};
}
[[nodiscard]] constexpr FieldBounds above(double low, double high) noexcept {
  return {low, high, false};
}

struct NumberField {
  std::string_view key;
  std::string_view unit;  ///< Empty if it has none.
  FieldBounds bounds;
  std::string_view text;  ///< One sentence that says when to change it.
};

struct WordField {
  std::string_view key;
  std::string_view words;  ///< In the order of the enumerators, a space between two.
  std::string_view text;
};

/// The shortest digits that read back as the same number.
[[nodiscard]] std::string to_text(double value);

/// "from 0 to 1.5707963267948966", "above 0, at most 1000".
[[nodiscard]] std::string to_string(const FieldBounds& bounds);

/// \throws std::invalid_argument naming the parameter, its value and its bounds.
void require_in_bounds(const NumberField& field, double value);
void require_known(const WordField& field, int value);

/// `visit(field, member)` for every parameter of a list, in its order: `visit_fields(tag, visit)`
/// stands beside each struct that is made from one.
///
/// Checks every member of `group`. \throws std::invalid_argument as above.
template <class Group>
void require_fields(const Group& group) {
  visit_fields(group, [&](const auto& field, auto member) {
    if constexpr (std::is_same_v<std::decay_t<decltype(field)>, NumberField>) {
      require_in_bounds(field, static_cast<double>(group.*member));
    } else {
      require_known(field, static_cast<int>(group.*member));
    }
  });
}

}  // namespace tcert

/// Within a struct: its members.
#define TCERT_MEMBER_WORD(type, member, key, value, words, text) type member = type::value;
#define TCERT_MEMBER_NUMBER(type, member, key, value, unit, bounds, text) type member = value;
/// Within visit_fields.
#define TCERT_VISIT_WORD(type, member, key, value, words, text) \
  visit(WordField{#key, words, text}, &Group::member);
#define TCERT_VISIT_NUMBER(type, member, key, value, unit, bounds, text) \
  visit(NumberField{#key, unit, bounds, text}, &Group::member);
