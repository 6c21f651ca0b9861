#pragma once
/// \file
/// Completion of commands, options and their words in a shell, made from what the commands take.

#include <string>
#include <vector>

#include "cli/commands/command_form.hpp"

namespace tcert::cli {

struct CompletionShell {
  std::string name;   ///< "bash".
  std::string place;  ///< Where it is installed, below share/.
  std::string (*script)(const std::vector<NamedForm>& forms);
};

/// bash, zsh and fish.
[[nodiscard]] const std::vector<CompletionShell>& completion_shells();

[[nodiscard]] std::string bash_completion(const std::vector<NamedForm>& forms);
[[nodiscard]] std::string zsh_completion(const std::vector<NamedForm>& forms);
[[nodiscard]] std::string fish_completion(const std::vector<NamedForm>& forms);

/// The comment of every script: only what has it is replaced.
[[nodiscard]] std::string completion_mark(const std::string& shell);

/// Keys of the parameter table, for --set; `between` stands between them.
[[nodiscard]] std::string parameter_keys(const std::string& between);

/// What may stand first behind a form's name: words that make another form of it, and those that
/// its first argument may be.
[[nodiscard]] std::vector<std::string> first_words_of(const NamedForm& form,
                                                      const std::vector<NamedForm>& all);

/// With a blank between.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

}  // namespace tcert::cli
