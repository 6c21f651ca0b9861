#include <table/flat_json.hpp>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_set>
#include <utility>

namespace tcert::table {

namespace {

using nlohmann::json;

/// Takes the parser's events; returning false ends the parse.
class FlatHandler final : public nlohmann::json_sax<json> {
 public:
  bool null() override { return add(FlatMember::Kind::null, {}); }
  bool boolean(bool value) override { return add(FlatMember::Kind::flag, value ? "1" : "0"); }
  bool number_integer(number_integer_t value) override {
    return add(FlatMember::Kind::number, std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add(FlatMember::Kind::number, std::to_string(value));
  }
  bool number_float(number_float_t /*value*/, const string_t& text) override {
    return add(FlatMember::Kind::number, text);
  }
  bool string(string_t& text) override { return add(FlatMember::Kind::other, text); }
  bool binary(binary_t& /*bytes*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return !std::exchange(open_, true); }
  bool end_object() override { return true; }
  bool start_array(std::size_t /*size*/) override { return false; }
  bool end_array() override { return false; }

  bool key(string_t& name) override {
    members.push_back({name, FlatMember::Kind::null, {}});
    return is_new(name);
  }

  bool parse_error(std::size_t /*position*/,
                   const std::string& /*token*/,
                   const nlohmann::detail::exception& /*error*/) override {
    return false;
  }

  std::vector<FlatMember> members;

 private:
  bool add(FlatMember::Kind kind, std::string text) {
    if (members.empty()) {
      return false;
    }
    members.back().kind = kind;
    members.back().text = std::move(text);
    return true;
  }

  /// Few keys, as a tick has, are compared one by one; many are looked up.
  bool is_new(const std::string& name) {
    constexpr std::size_t kFew = 128;
    if (members.size() <= kFew) {
      return std::none_of(members.begin(), members.end() - 1, [&name](const FlatMember& earlier) {
        return earlier.key == name;
      });
    }
    if (known_.empty()) {
      for (auto member = members.begin(); member != members.end() - 1; ++member) {
        known_.insert(member->key);
      }
    }
    return known_.insert(name).second;
  }

  bool open_ = false;
  std::unordered_set<std::string> known_;
};

struct PythonWord {
  std::string_view word;
  std::string_view json;
};

constexpr std::array kPythonWords{PythonWord{"NaN", "null"},
                                  PythonWord{"-Infinity", "\"-inf\""},
                                  PythonWord{"Infinity", "\"inf\""}};

/// The text with Python's words for numbers that JSON lacks replaced, texts in quotes left alone.
std::string without_python_words(std::string_view text) {
  std::string out;
  bool quoted = false;
  for (std::size_t at = 0; at < text.size();) {
    const auto* const found =
        quoted ? kPythonWords.end()
               : std::ranges::find_if(kPythonWords, [rest = text.substr(at)](PythonWord one) {
                   return rest.starts_with(one.word);
                 });
    if (found != kPythonWords.end()) {
      out += found->json;
      at += found->word.size();
      continue;
    }
    quoted = quoted != (text[at] == '"');
    if (quoted && text[at] == '\\' && at + 1 < text.size()) {
      out += text[at++];
    }
    out += text[at++];
  }
  return out;
}

}  // namespace

std::optional<std::vector<FlatMember>> parse_flat_json(std::string_view text) {
  std::string replaced;
  if (text.find("NaN") != std::string_view::npos ||
      text.find("Infinity") != std::string_view::npos) {
    replaced = without_python_words(text);
    text = replaced;
  }
  FlatHandler handler;
  if (!json::sax_parse(text.begin(), text.end(), &handler)) {
    return std::nullopt;
  }
  return std::move(handler.members);
}

}  // namespace tcert::table
