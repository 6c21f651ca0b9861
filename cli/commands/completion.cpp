#include "cli/commands/completion.hpp"

#include <algorithm>

#include "analysis/study/trials/parameters.hpp"

namespace tcert::cli {

const std::vector<CompletionShell>& completion_shells() {
  static const std::vector<CompletionShell> shells{
      {"bash", "bash-completion/completions/tcert", bash_completion},
      {"zsh", "zsh/site-functions/_tcert", zsh_completion},
      {"fish", "fish/vendor_completions.d/tcert.fish", fish_completion}};
  return shells;
}

std::string completion_mark(const std::string& shell) {
  return "# Completion of tcert for " + shell + ", made by 'tcert help completion " + shell +
         "'.\n";
}

std::string parameter_keys(const std::string& between) {
  std::string keys;
  for (const study::ParameterInfo& parameter : study::parameter_table()) {
    keys += (keys.empty() ? "" : between) + std::string(parameter.key);
  }
  return keys;
}

std::vector<std::string> first_words_of(const NamedForm& form, const std::vector<NamedForm>& all) {
  std::vector<std::string> words;
  if (!form.form.arguments.empty()) {
    words = form.form.arguments.front().words;
  }
  for (const NamedForm& other : all) {
    const bool is_of_it =
        !other.form.word.empty() && other.name == form.name + ' ' + other.form.word;
    if (is_of_it && std::ranges::find(words, other.form.word) == words.end()) {
      words.push_back(other.form.word);
    }
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

}  // namespace tcert::cli
