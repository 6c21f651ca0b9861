#include <cstddef>

#include "cli/commands/completion.hpp"

namespace tcert::cli {
namespace {

/// Within '...[...]' of _arguments.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
      (out += '\\') += c;
    } else {
      out += c;
    }
  }
  return out;
}

std::string action_of(const OptionForm& option) {
  if (!option.words.empty()) {
    return "(" + joined(option.words) + ")";
  }
  if (option.name == "set") {
    return "_tcert_keys";
  }
  return option.is_path() ? "_files" : " ";
}

std::string option_spec(const OptionForm& option) {
  const std::string text = "[" + escaped(option.text) + "]";
  if (option.shown.empty()) {
    return "'--" + option.name + text + "'";
  }
  return std::string("'") + (option.repeats ? "*" : "") + "--" + option.name + "=" + text + ":" +
         escaped(option.shown) + ":" + action_of(option) + "'";
}

std::string arguments_of(const NamedForm& one, const std::vector<NamedForm>& forms) {
  const auto* const separator = " \\\n        ";
  std::string text = "_arguments -S";
  for (const OptionForm& option : one.form.options) {
    text += separator + option_spec(option);
  }
  std::vector<std::string> words = first_words_of(one, forms);
  const std::vector<ArgumentForm>& arguments = one.form.arguments;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::vector<std::string>& of_it = i == 0 ? words : arguments[i].words;
    text += separator + ("'" + std::to_string(i + 1) + ":" + escaped(arguments[i].name) + ":") +
            (of_it.empty() ? "_files" : "(" + joined(of_it) + ")") + "'";
  }
  if (arguments.empty() && !words.empty()) {
    text += separator + ("'1:WORD:(" + joined(words) + ")'");
  }
  return text + separator + "'*:FILE:_files'";
}

}  // namespace

std::string zsh_completion(const std::vector<NamedForm>& forms) {
  std::string commands;
  std::string with_word;
  std::string cases;
  for (const NamedForm& one : forms) {
    if (one.form.word.empty()) {
      commands += "    '" + one.name + ":" + escaped(one.summary) + "'\n";
    } else {
      with_word += (with_word.empty() ? "'" : " | '") + one.name + "'";
    }
    cases += "    '" + one.name + "')\n      " + arguments_of(one, forms) + " ;;\n";
  }
  return "#compdef tcert\n" + completion_mark("zsh") + "\n_tcert_keys() {\n  compadd -S = -- " +
         parameter_keys(" ") + "\n}\n\n_tcert() {\n  local -a commands\n  commands=(\n" + commands +
         "    '--help:the commands'\n    '--version:of this build'\n  )\n"
         "  if (( CURRENT == 2 )); then\n    _describe -t commands command commands\n    return\n"
         "  fi\n  local form=${words[2]} at=1\n  if (( CURRENT > 3 )); then\n"
         "    case \"${words[2]} ${words[3]}\" in\n      " +
         with_word +
         ") form=\"${words[2]} ${words[3]}\" at=2 ;;\n    esac\n  fi\n"
         "  shift $at words\n  (( CURRENT -= at ))\n  case $form in\n" +
         cases + "  esac\n}\n\n" +
         "if [ \"$funcstack[1]\" = _tcert ]; then\n  _tcert \"$@\"\nelse\n  compdef _tcert "
         "tcert\nfi\n";
}

}  // namespace tcert::cli
