// The manual pages and the completions, held against what --help prints: every command, every
// option.

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "support/shell.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::Shell;
using test_support::to_string;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Manual : public ::testing::Test {
 protected:
  ProcessResult done(const std::string& line) {
    ProcessResult run = shell_.run(line);
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return run;
  }

  /// "certify", "import carmen", ...: the commands that `help` lists, and forms of them.
  std::vector<std::string> forms() {
    std::vector<std::string> all;
    std::istringstream lines(done("$T help").out);
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
      if (line == "Commands:") {
        inside = true;
      } else if (line.empty()) {
        inside = false;
      } else if (inside) {
        all.push_back(line.substr(2, line.find(' ', 2) - 2));
      }
    }
    all.insert(all.end(),
               {"import carmen",
                "import barn",
                "calibrate rays",
                "calibrate tracking",
                "calibrate guards",
                "assure perturb",
                "assure monitor",
                "simulate terrain"});
    return all;
  }

  /// Names of options as --help prints them, at the beginning of lines.
  std::vector<std::string> options_of(const std::string& form) {
    std::vector<std::string> names;
    std::istringstream lines(done("$T " + form + " --help").out);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("  --")) {
        names.push_back(line.substr(4, line.find(' ', 4) - 4));
      }
    }
    EXPECT_FALSE(names.empty()) << form;
    return names;
  }

  bool has(const std::string& program) {
    return shell_.run("command -v " + program).exit_code == 0;
  }

  /// What bash offers for a line; the last word is being written.
  std::string offered(const std::string& line) {
    shell_.work().write("ask.sh",
                        "source ./tcert.bash\nread -ra COMP_WORDS <<<\"$1\"\n"
                        "case \"$1\" in *' ') COMP_WORDS+=('') ;; esac\n"
                        "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_tcert\n"
                        "echo \" ${COMPREPLY[*]} \"\n");
    return done("bash ask.sh '" + line + "'").out;
  }

  Shell shell_;
};

std::string with_hyphens(std::string text) {
  std::string out;
  for (const char c : text) {
    out += c == '-' ? "\\-" : std::string(1, c);
  }
  return out;
}

TEST_F(Manual, HasAPageOfEveryCommandWithEveryOption) {
  done("$T help man --output pages");
  const std::string tool = shell_.work().read("pages/man1/tcert.1");
  for (const std::string& form : forms()) {
    std::string name = "tcert-" + form;
    name.replace(name.find(' ') == std::string::npos ? name.size() : name.find(' '), 1, "-");
    name.resize(name.find_last_not_of('-') + 1);
    const std::string page = shell_.work().read("pages/man1/" + name + ".1");
    EXPECT_TRUE(holds(tool, ".BR " + with_hyphens(name) + " (1)")) << name;
    std::size_t at = 0;
    for (const char* const section :
         {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXAMPLE", "EXIT STATUS", "SEE ALSO"}) {
      const std::size_t next = page.find(std::string("\n.SH ") + section + "\n", at);
      ASSERT_NE(next, std::string::npos) << name << " has no " << section << " in its place";
      at = next;
    }
    for (const std::string& option : options_of(form)) {
      EXPECT_TRUE(holds(page, "\n\\fB" + with_hyphens("--" + option) + "\\fR"))
          << name << " --" << option;
    }
  }
  for (const char* const topic : {"parameters", "columns", "bundle"}) {
    EXPECT_FALSE(shell_.work().read(std::string("pages/man7/tcert-") + topic + ".7").empty());
  }
}

TEST_F(Manual, IsPrintedPageByPageAndSaysWhichThereAre) {
  done("$T help man --output pages");
  EXPECT_EQ(done("$T help man").out, shell_.work().read("pages/man1/tcert.1"));
  EXPECT_EQ(done("$T help man import-carmen").out,
            shell_.work().read("pages/man1/tcert-import-carmen.1"));
  const ProcessResult none = shell_.run("$T help man certfy");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_TRUE(holds(none.err, "did you mean 'tcert-certify'?")) << none.err;
}

TEST_F(Manual, ReplacesItsOwnFilesAlone) {
  done("$T help man --output pages && $T help man --output pages");
  done("$T help completion zsh --output z/_tcert && $T help completion zsh --output z/_tcert");
  shell_.work().write("pages/man1/tcert.1", "mine");
  EXPECT_EQ(shell_.run("$T help man --output pages").exit_code, 73);
  EXPECT_EQ(shell_.work().read("pages/man1/tcert.1"), "mine");
  EXPECT_EQ(shell_.run("$T help columns --output x").exit_code, 2);
}

TEST_F(Manual, IsReadWithoutAWarning) {
  done("$T help man --output pages");
  std::string command;
  if (has("man")) {
    command = "LC_ALL=C.UTF-8 MANWIDTH=100 MANROFFSEQ= man -l --warnings=all \"$p\"";
  } else if (has("groff")) {
    command = "groff -man -Tutf8 -ww \"$p\"";
  } else {
    GTEST_SKIP() << "neither man nor groff is installed";
  }
  const ProcessResult run = done("for p in pages/man*/*; do " + command +
                                 " >text || exit 1; test -s text || exit 1; done");
  EXPECT_EQ(run.err, "");
}

TEST_F(Manual, CompletesInBash) {
  if (!has("bash")) {
    GTEST_SKIP() << "bash is not installed";
  }
  done("$T help completion bash > tcert.bash");
  EXPECT_EQ(offered("tcert cer"), " certify \n");
  EXPECT_EQ(offered("tcert certify --fo"), " --format \n");
  EXPECT_EQ(offered("tcert certify corpus --format m"), " md \n");
  EXPECT_EQ(offered("tcert certify --format = js"), " json jsonl \n");
  EXPECT_EQ(offered("tcert certify --set edge_l"), " edge_length_m= \n");
  EXPECT_EQ(offered("tcert fit co"), " cox concordance \n");
  EXPECT_EQ(offered("tcert fit --level 0.9 co"), " cox concordance \n");
  EXPECT_EQ(offered("tcert fit cox co"), "  \n") << "the kind is there; what follows is no kind";
  EXPECT_EQ(offered("tcert import "), " barn carmen log \n");
  EXPECT_EQ(offered("tcert import carmen --goal-r"), " --goal-radius \n");
  EXPECT_EQ(offered("tcert help para"), " parameters \n");
  for (const std::string& form : forms()) {
    const std::string all = offered("tcert " + form + " --");
    for (const std::string& option : options_of(form)) {
      EXPECT_TRUE(holds(all, " --" + option + " ")) << form << " --" << option;
    }
  }
}

TEST_F(Manual, CompletesInFish) {
  const std::string script = done("$T help completion fish > tcert.fish; cat tcert.fish").out;
  for (const std::string& form : forms()) {
    for (const std::string& option : options_of(form)) {
      EXPECT_TRUE(holds(script, "__tcert_is \"" + form + "\"' -l " + option + ' '))
          << form << " --" << option;
    }
  }
  if (!has("fish")) {
    GTEST_SKIP() << "fish is not installed: the script was not run";
  }
  const auto offers = [&](const std::string& line) {
    return done("HOME=$PWD fish -c 'source tcert.fish; complete -C \"" + line + "\"'").out;
  };
  EXPECT_TRUE(offers("tcert cer").starts_with("certify\t"));
  EXPECT_TRUE(offers("tcert certify --fo").starts_with("--format\t"));
  EXPECT_TRUE(offers("tcert certify --format m").starts_with("md"));
  EXPECT_TRUE(offers("tcert import carmen --goal-r").starts_with("--goal-radius\t"));
  EXPECT_TRUE(offers("tcert import ca").starts_with("carmen"));
}

TEST_F(Manual, CompletesInZsh) {
  const std::string script = done("$T help completion zsh > _tcert; cat _tcert").out;
  EXPECT_TRUE(script.starts_with("#compdef tcert\n"));
  for (const std::string& form : forms()) {
    const std::size_t begin = script.find("\n    '" + form + "')\n");
    ASSERT_NE(begin, std::string::npos) << form;
    const std::string part = script.substr(begin, script.find(";;\n", begin) - begin);
    for (const std::string& option : options_of(form)) {
      EXPECT_TRUE(holds(part, "--" + option + "=[") || holds(part, "--" + option + "["))
          << form << " --" << option;
    }
  }
  if (!has("zsh")) {
    GTEST_SKIP() << "zsh is not installed: the script was not run";
  }
  done("zsh -n _tcert");
  // A shell on a terminal of its own, to which the line and a tab are typed.
  shell_.work().write("ask.zsh", R"zsh(
zmodload zsh/zpty
zpty asked zsh -f -i
zpty -w asked 'PS1= PROMPT_EOL_MARK=; autoload -U compinit; compinit -u -D; source ./_tcert; bindkey "^I" complete-word; clear'
zpty -w -n asked "$1"$'\t'
for ((i = 0; i < 150; ++i)); do
  while zpty -r -t asked more; do text+=$more; done
  [[ $text == *"$2"* ]] && print yes && exit
  sleep 0.2
done
print -r -- "no: $text"
)zsh");
  const auto typed = [&](const std::string& line, const std::string& completed) {
    return done("TERM=dumb zsh -f ask.zsh '" + line + "' '" + completed + "'").out;
  };
  EXPECT_EQ(typed("tcert cer", "tcert certify "), "yes\n");
  EXPECT_EQ(typed("tcert certify --fo", "tcert certify --format="), "yes\n");
}

}  // namespace
}  // namespace tcert
