#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/regular_file.hpp>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/output.hpp"
#include "cli/commands/standard_streams.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/interrupt.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

const Command& command_of(const std::string& name) {
  std::vector<std::string> names;
  for (const Command* command : commands()) {
    if (command->name == name) {
      return *command;
    }
    names.emplace_back(command->name);
  }
  throw UsageError("unknown command '" + name + "'" + did_you_mean(name, names));
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    throw UsageError("needs a command");
  }
  const std::string& first = arguments.front();
  if (first == "--help" || first == "-h") {
    return kHelp.run({});
  }
  if (first == "--version" || first == "-V") {
    return kVersion.run({});
  }
  return command_of(first).run(Arguments(arguments).subspan(1));
}

/// True if nothing of that name can be used, whatever the system has.
bool is_of_a_name(const std::error_code& error) {
  constexpr std::array kKinds{std::errc::no_such_file_or_directory,
                              std::errc::not_a_directory,
                              std::errc::is_a_directory,
                              std::errc::permission_denied,
                              std::errc::filename_too_long,
                              std::errc::too_many_symbolic_link_levels};
  return std::ranges::any_of(kKinds, [&](std::errc kind) { return error == kind; });
}

int exit_code_of_current_exception(const std::string& who) {
  try {
    throw;
  } catch (const BrokenPipe&) {
    return exit_done;
  } catch (const UsageError& error) {
    say(who + ": " + error.what() + "\nSee '" + who + " --help'.");
    return exit_usage;
  } catch (const NoInput& error) {
    say(who + ": " + error.what());
    return exit_no_input;
  } catch (const BadData& error) {
    say(who + ": " + error.what());
    return exit_bad_data;
  } catch (const table::WriteError& error) {
    say(who + ": " + error.what());
    return exit_cannot_write;
  } catch (const table::OutOfResources& error) {
    say(who + ": " + error.what());
    return exit_system;
  } catch (const std::bad_alloc&) {
    say(who +
        ": there is not enough memory; fewer trials at a time (--trials), fewer --threads, or "
        "smaller bounds (max_nodes, max_edges, max_memory_cells, max_swept_cells) take less");
    return exit_system;
  } catch (const std::filesystem::filesystem_error& error) {
    if (is_of_a_name(error.code())) {
      say(who + ": cannot use '" + error.path1().string() + "': " + error.code().message());
      return exit_no_input;
    }
    say(who + ": the system refused: " + error.what());
    return exit_system;
  } catch (const std::system_error& error) {
    if (is_of_a_name(error.code())) {
      say(who + ": cannot use " + error.what());
      return exit_no_input;
    }
    say(who + ": the system refused: " + error.what());
    return exit_system;
  } catch (const std::exception& error) {
    // oneTBB says in words alone that it could not start a thread.
    if (std::string_view(error.what()).starts_with("pthread_create")) {
      say(who + ": the system refused a thread: " + error.what() + "; fewer --threads take less");
      return exit_system;
    }
    say(who + ": internal error: " + error.what());
    return exit_internal;
  }
}

std::string name_of(const std::vector<std::string>& arguments) {
  for (const Command* command : commands()) {
    if (!arguments.empty() && command->name == arguments.front()) {
      return "tcert " + arguments.front();
    }
  }
  return "tcert";
}

}  // namespace
}  // namespace tcert::cli

int main(int argc, char** argv) {
  using namespace tcert::cli;
  open_standard_streams();
  // A reader that has gone, and a file that may not grow, show as a failed write, not as a signal.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::string who = "tcert";
  try {
    watch_interrupts();
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    who = name_of(arguments);
    return run(arguments);
  } catch (...) {
    return exit_code_of_current_exception(who);
  }
}
