#include "cli/commands/completion.hpp"

namespace tcert::cli {
namespace {

/// What the functions below it say is the only thing that is about tcert.
constexpr std::string_view kBashFunctions = R"bash(
# Sets 'form' to the command at the cursor, with its word if it has one, and 'at' to how many words it has.
_tcert_form() {
  form=${line[0]} at=1
  case "${line[0]} ${line[1]}" in
    @FORMS@) form="${line[0]} ${line[1]}" at=2 ;;
  esac
}

_tcert() {
  local line=() form at current='' before='' i position=0
  # Bash makes three words of --format=md; the sign between is none.
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [ "${COMP_WORDS[i]}" = '=' ] || line+=("${COMP_WORDS[i]}")
  done
  current=${COMP_WORDS[COMP_CWORD]}
  [ "$current" = '=' ] && current=''
  COMPREPLY=()
  if [ ${#line[@]} -eq 0 ]; then
    COMPREPLY=($(compgen -W "$_tcert_commands --help --version" -- "$current"))
    return
  fi
  _tcert_form
  for ((i = at; i < ${#line[@]}; ++i)); do
    before=''
    case "${line[i]}" in
      --*) [ -n "$(_tcert_value "$form" "${line[i]}")" ] && before=${line[i]} && ((++i)) ;;
      *) ((++position)) ;;
    esac
  done
  # The last word is an option whose value is being written.
  if [ -n "$before" ] && [ $i -gt ${#line[@]} ]; then
    local value
    value=$(_tcert_value "$form" "$before")
    case "$value" in
      '<path>') compopt -o default 2>/dev/null ;;
      '<key>')
        compopt -o nospace 2>/dev/null
        COMPREPLY=($(compgen -S = -W "$_tcert_keys" -- "$current"))
        ;;
      '<value>') ;;
      *) COMPREPLY=($(compgen -W "$value" -- "$current")) ;;
    esac
    return
  fi
  case "$current" in
    -*) COMPREPLY=($(compgen -W "$(_tcert_options "$form")" -- "$current")) ;;
    *)
      local words=''
      [ $position -eq 0 ] && words=$(_tcert_first "$form")
      COMPREPLY=($(compgen -W "$words" -- "$current"))
      [ -z "$words" ] && compopt -o default 2>/dev/null
      ;;
  esac
}
complete -F _tcert tcert
)bash";

std::string value_of(const OptionForm& option) {
  if (!option.words.empty()) {
    return joined(option.words);
  }
  if (option.name == "set") {
    return "<key>";
  }
  return option.is_path() ? "<path>" : "<value>";
}

/// name() { case "$1" in ... esac; }
std::string function_of(const std::string& name, const std::string& on, const std::string& cases) {
  return name + "() {\n  case \"" + on + "\" in\n" + cases + "  esac\n}\n";
}

std::string one_case(const std::string& word, const std::string& answer) {
  return "    '" + word + "') echo '" + answer + "' ;;\n";
}

}  // namespace

std::string bash_completion(const std::vector<NamedForm>& forms) {
  std::string commands;
  std::string options;
  std::string values;
  std::string first;
  std::string with_word;
  for (const NamedForm& one : forms) {
    if (one.form.word.empty()) {
      commands += (commands.empty() ? "" : " ") + one.name;
    } else {
      with_word += (with_word.empty() ? "'" : " | '") + one.name + "'";
    }
    std::vector<std::string> names;
    for (const OptionForm& option : one.form.options) {
      names.push_back("--" + option.name);
      if (!option.shown.empty()) {
        values += one_case(one.name + " --" + option.name, value_of(option));
      }
    }
    options += one_case(one.name, joined(names));
    if (const auto words = first_words_of(one, forms); !words.empty()) {
      first += one_case(one.name, joined(words));
    }
  }
  std::string functions(kBashFunctions);
  const std::string mark = "@FORMS@";
  functions.replace(functions.find(mark), mark.size(), with_word);
  return completion_mark("bash") + "_tcert_commands='" + commands + "'\n_tcert_keys='" +
         parameter_keys(" ") + "'\n\n# Options of a form.\n" +
         function_of("_tcert_options", "$1", options) +
         "\n# What is behind an option: words, <path>, <key>, <value>; nothing behind a switch.\n" +
         function_of("_tcert_value", "$1 $2", values) +
         "\n# What may stand first behind a form.\n" + function_of("_tcert_first", "$1", first) +
         functions;
}

}  // namespace tcert::cli
