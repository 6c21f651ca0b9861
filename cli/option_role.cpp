#include "cli/option_role.hpp"

namespace tcert::cli {
namespace {

namespace po = boost::program_options;

class HasRole {
 public:
  explicit HasRole(OptionRole role) noexcept : role_(role) {}
  virtual ~HasRole() = default;
  HasRole(const HasRole&) = delete;
  HasRole& operator=(const HasRole&) = delete;
  [[nodiscard]] OptionRole role() const noexcept { return role_; }

 private:
  OptionRole role_;
};

template <class T>
class ValueOfRole final : public po::typed_value<T>, public HasRole {
 public:
  ValueOfRole(T& value, OptionRole role) : po::typed_value<T>(&value), HasRole(role) {}
};

template <class T>
po::typed_value<T>* of_role(T& value, OptionRole role, const char* shown) {
  return (new ValueOfRole<T>(value, role))->value_name(shown);  // the description owns it
}

}  // namespace

po::typed_value<std::string>* input(std::string& value, const char* shown) {
  return of_role(value, OptionRole::input, shown);
}

po::typed_value<std::string>* output(std::string& value, const char* shown) {
  return of_role(value, OptionRole::output, shown);
}

po::typed_value<std::int64_t>* process(std::int64_t& value, const char* shown) {
  return of_role(value, OptionRole::process, shown);
}

po::typed_value<std::string>* process(std::string& value, const char* shown) {
  return of_role(value, OptionRole::process, shown);
}

po::typed_value<bool>* process_switch(bool& value) {
  return (new ValueOfRole<bool>(value, OptionRole::process))->default_value(false)->zero_tokens();
}

OptionRole role_of(const po::option_description& option) {
  const auto* const value = dynamic_cast<const HasRole*>(option.semantic().get());
  return value != nullptr ? value->role() : OptionRole::shapes;
}

}  // namespace tcert::cli
