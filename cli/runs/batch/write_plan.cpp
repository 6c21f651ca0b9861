#include <algorithm>
#include <filesystem>
#include <system_error>
#include <table/atomic_file.hpp>
#include <utility>

#include "cli/runs/batch/arithmetic.hpp"
#include "cli/runs/batch/batch.hpp"
#include "cli/runs/batch/job_scripts.hpp"
#include "cli/runs/program_digest.hpp"
#include "cli/runs/result_folder.hpp"
#include "reports/version.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

void add_input(const std::string& path, std::vector<PlanInput>& inputs) {
  if (path.empty()) {
    return;
  }
  std::error_code error;
  const fs::path place = fs::canonical(path, error);
  if (error || (!fs::is_regular_file(place) && !fs::is_directory(place))) {
    throw NoInput("cannot read '" + path + "': " + (error ? error.message() : "it is no file"));
  }
  const PlanInput input{name_of(path), place.string(), {}};
  const auto same = std::ranges::find(inputs, input.name, &PlanInput::name);
  if (same != inputs.end() && same->place != input.place) {
    throw UsageError("two inputs are called '" + input.name + "'; rename one of them");
  }
  if (same == inputs.end()) {
    inputs.push_back(input);
    inputs.back().digest = digest_path(input.place);
  }
}

/// "60 mixed worlds, 20 hard worlds": sets of one name together.
std::string in_words(const Plan& plan) {
  std::vector<std::pair<std::string, std::uint64_t>> sums;
  for (const auto& [name, count] : plan.items) {
    const auto same = std::ranges::find(sums, name, &std::pair<std::string, std::uint64_t>::first);
    if (same == sums.end()) {
      sums.emplace_back(name, count);
    } else {
      same->second += count;
    }
  }
  std::string text;
  for (const auto& [name, count] : sums) {
    if (count > 0) {
      text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + name;
    }
  }
  return text;
}

/// A plan within its input would change it. \throws UsageError.
void require_outside(const fs::path& input, const fs::path& folder) {
  require_apart(input, folder);
  const fs::path place = fs::weakly_canonical(folder);
  if (std::ranges::mismatch(input, place).in1 == input.end()) {
    throw UsageError("the plan '" + folder.string() + "' lies in its input '" + input.string() +
                     "', which it would change; name a folder outside of it");
  }
}

}  // namespace

std::vector<PlanInput> inputs_of(const OptionTable& table) {
  std::vector<PlanInput> inputs;
  for (const Argument& one : table.arguments()) {
    if (one.role == OptionRole::input) {
      add_input(*one.value, inputs);
    }
  }
  for (const Option& option : table.options()) {
    if (option.role != OptionRole::input) {
      continue;
    }
    if (const auto* const several = std::get_if<std::vector<std::string>*>(&option.value)) {
      for (const std::string& one : **several) {
        add_input(one, inputs);
      }
    } else {
      add_input(text_of(option.value), inputs);
    }
  }
  return inputs;
}

void require_no_process_options(const OptionTable& table) {
  for (const Option& option : table.options()) {
    if (option.role == OptionRole::process && is_given(table.given(), option.name)) {
      throw UsageError("--" + option.name +
                       " does not shape a result: it is none of a plan; threads are told to "
                       "'batch work', and parts are what is kept");
    }
  }
}

ExitCode write_plan(Plan plan,
                    const std::vector<ItemSet>& sets,
                    const std::string& folder,
                    Progress& progress) {
  if (count_of(sets) == 0) {
    throw UsageError("it has nothing that can be made in pieces; run it by itself");
  }
  for (const ItemSet& set : sets) {
    plan.items.emplace_back(set.name, set.count);
  }
  if (plan.count() > kMostItems) {
    throw UsageError("more than 10^12 items");
  }
  plan.version = tool_version();
  plan.program = program_digest();
  plan.arithmetic = arithmetic_digest();
  static_cast<void>(plan.pieces());  // Throws if the words are not those that it reads.
  for (const PlanInput& input : plan.inputs) {
    require_outside(input.place, folder);
  }
  table::AtomicFolder output(folder);
  table::write_file_atomically(output.staging() / "plan.json", to_json(plan));
  const std::string program = fs::canonical("/proc/self/exe").string();
  for (const auto& [name, text] : job_scripts(plan, program)) {
    table::write_file_atomically(output.staging() / name, text);
    if (text.starts_with("#!")) {
      using fs::perms;
      fs::permissions(output.staging() / name,
                      perms::owner_exec | perms::group_exec | perms::others_exec,
                      fs::perm_options::add);
    }
  }
  fs::create_directory(output.staging() / "parts");
  output.commit();
  if (plan.shards > plan.count()) {
    progress.say("More shards than items: some have nothing to do.");
  }
  progress.sum_up(in_words(plan) + " in " + std::to_string(plan.shards) +
                  " shards. With Slurm:\n  sh " + quoted((fs::path(folder) / "submit").string()) +
                  "\nWith GNU parallel:\n  sh " +
                  quoted((fs::path(folder) / "run_parallel").string()) + "\n  tcert batch merge " +
                  quoted(folder));
  return exit_done;
}

}  // namespace tcert::cli
