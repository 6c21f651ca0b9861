#include "cli/commands/completion.hpp"

namespace tcert::cli {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return out + "'";
}

std::string option_line(const std::string& form, const OptionForm& option) {
  std::string line = "complete -c tcert -n '__tcert_is \"" + form + "\"' -l " + option.name;
  if (!option.words.empty()) {
    line += " -x -a " + quoted(joined(option.words));
  } else if (option.name == "set") {
    line += " -x -a " + quoted(parameter_keys("= ") + '=');
  } else if (option.is_path()) {
    line += " -r -F";
  } else if (!option.shown.empty()) {
    line += " -x";
  }
  return line + " -d " + quoted(option.text) + '\n';
}

constexpr std::string_view kFishFunctions = R"fish(
# The command at the cursor, with its word if it has one.
function __tcert_form
    set -l line (commandline -opc)
    switch "$line[2] $line[3]"
        case @FORMS@
            echo "$line[2] $line[3]"
        case '*'
            echo "$line[2]"
    end
end

function __tcert_is
    set -l form (__tcert_form)
    test "$form" = "$argv[1]"
end

function __tcert_begins
    test (count (commandline -opc)) -eq 1
end

complete -c tcert -f
complete -c tcert -n __tcert_begins -l help -d 'the commands'
complete -c tcert -n __tcert_begins -s V -l version -d 'of this build'
)fish";

}  // namespace

std::string fish_completion(const std::vector<NamedForm>& forms) {
  std::string with_word;
  std::string lines;
  for (const NamedForm& one : forms) {
    if (one.form.word.empty()) {
      lines += "complete -c tcert -n __tcert_begins -a " + one.name + " -d " + quoted(one.summary) +
               '\n';
    } else {
      with_word += (with_word.empty() ? "'" : " '") + one.name + "'";
    }
    const auto words = first_words_of(one, forms);
    const std::string condition = "complete -c tcert -n '__tcert_is \"" + one.name + "\"' ";
    lines += condition + (words.empty() ? "-F" : "-F -a " + quoted(joined(words))) + '\n';
    for (const OptionForm& option : one.form.options) {
      lines += option_line(one.name, option);
    }
  }
  std::string functions(kFishFunctions);
  const std::string mark = "@FORMS@";
  functions.replace(functions.find(mark), mark.size(), with_word);
  return completion_mark("fish") + functions + lines;
}

}  // namespace tcert::cli
