#include "cli/commands/option_description.hpp"

namespace tcert::cli {
namespace {

namespace po = boost::program_options;

/// How one option is read; its default is shown, if it is not empty.
class Semantic {
 public:
  explicit Semantic(const Option& option) : option_(option) {}

  const po::value_semantic* operator()(bool* value) const {
    return po::bool_switch(value)->default_value(*value);
  }
  const po::value_semantic* operator()(double* value) const {
    return shown(po::value(value)->default_value(*value, text_of(option_.value)));
  }
  const po::value_semantic* operator()(std::int64_t* value) const {
    return shown(po::value(value)->default_value(*value));
  }
  const po::value_semantic* operator()(std::string* value) const {
    auto* const semantic = po::value(value);
    return shown(value->empty() ? semantic : semantic->default_value(*value));
  }
  const po::value_semantic* operator()(std::optional<std::string>* value) const {
    return shown(po::value<std::string>()->notifier(
        [value](const std::string& text) { value->emplace(text); }));
  }
  template <class Number>
  const po::value_semantic* operator()(std::optional<Number>* value) const {
    return shown(po::value<Number>()->notifier([value](Number number) { value->emplace(number); }));
  }
  const po::value_semantic* operator()(std::vector<std::string>* values) const {
    return shown(po::value(values)->composing());
  }

 private:
  template <class Value>
  const po::value_semantic* shown(po::typed_value<Value>* semantic) const {
    return semantic->value_name(option_.shown);
  }

  const Option& option_;
};

}  // namespace

po::options_description description_of(const std::string& heading,
                                       const OptionTable& table,
                                       std::size_t begin,
                                       std::size_t end) {
  po::options_description description(heading);
  for (std::size_t i = begin; i < end; ++i) {
    const Option& option = table.options()[i];
    description.add_options()(
        option.name.c_str(), std::visit(Semantic(option), option.value), option.text.c_str());
  }
  return description;
}

}  // namespace tcert::cli
