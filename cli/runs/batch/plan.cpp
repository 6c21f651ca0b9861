#include "cli/runs/batch/plan.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <table/bytes.hpp>
#include <table/json_shape.hpp>
#include <table/regular_file.hpp>

#include "cli/runs/batch/arithmetic.hpp"
#include "cli/runs/program_digest.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// \throws Json::exception for anything but a count.
std::uint64_t count_at(const Json& json, const char* key) {
  return json.at(key).get_ref<const Json::number_unsigned_t&>();
}

Plan plan_from(const Json& json, const std::string& file) {
  if (count_at(json, "plan") != 1) {
    throw BadData(file + ": it is of another version of plans; plan anew");
  }
  Plan plan;
  json.at("command").get_to(plan.command);
  for (const Json& one : json.at("arguments")) {
    plan.arguments.push_back({one.at("text").get<std::string>(), one.at("input").get<bool>()});
  }
  for (const Json& one : json.at("inputs")) {
    plan.inputs.push_back(
        {one.at("name").get<std::string>(),
         one.at("place").get<std::string>(),
         {count_at(one, "files"), count_at(one, "bytes"), one.at("sha256").get<std::string>()}});
  }
  for (const Json& one : json.at("items")) {
    plan.items.emplace_back(one.at("name").get<std::string>(), count_at(one, "count"));
  }
  plan.shards = count_at(json, "shards");
  json.at("version").get_to(plan.version);
  json.at("program").get_to(plan.program);
  json.at("arithmetic").get_to(plan.arithmetic);
  return plan;
}

/// \throws BadData.
void require_same_machine(const Plan& plan, const std::string& file) {
  if (plan.program != program_digest()) {
    throw BadData(file + ": it was made by another program (version " + plan.version +
                  "); use that one, or plan anew with this one");
  }
  if (plan.arithmetic != arithmetic_digest()) {
    throw BadData(file +
                  ": this processor computes exp and the like otherwise than the one on which it "
                  "was planned, in the last bit; run it on nodes of one kind (sbatch "
                  "--constraint), and plan it on one of them");
  }
}

/// \throws NoInput, BadData.
void require_same_inputs(const Plan& plan) {
  for (const PlanInput& input : plan.inputs) {
    const bool is_named = std::ranges::any_of(plan.arguments, [&](const ManifestArgument& one) {
      return one.is_input && one.text == input.name;
    });
    if (!is_named) {
      throw BadData("the plan has an input '" + input.place + "' that its command does not name");
    }
    std::string found;
    try {
      found = digest_path(input.place).sha256;
    } catch (const std::system_error& error) {
      throw NoInput("cannot read the input '" + input.place + "' of the plan: " + error.what());
    }
    if (found != input.digest.sha256) {
      throw BadData("the input '" + input.place +
                    "' is not what it was when the plan was made; plan anew");
    }
  }
}

}  // namespace

std::uint64_t Plan::count() const noexcept {
  std::uint64_t sum = 0;
  for (const auto& [name, count] : items) {
    sum += count;
  }
  return sum;
}

ItemRange Plan::range_of(std::uint64_t shard) const noexcept {
  const auto first = [&](std::uint64_t k) { return (k * count() + shards - 1) / shards; };
  return {first(shard), first(shard + 1)};
}

Pieces Plan::pieces() const {
  const FindInput find = [this](const std::string& name,
                                bool /*first*/) -> std::optional<std::string> {
    for (const PlanInput& input : inputs) {
      if (input.name == name) {
        return input.place;
      }
    }
    return std::nullopt;
  };
  try {
    return pieces_of(command, arguments, find);
  } catch (const NotReproducible& error) {
    throw BadData(std::string("the plan: ") + error.what());
  }
}

void require_items(const Plan& plan, const std::vector<ItemSet>& sets) {
  const bool same = std::ranges::equal(plan.items, sets, [](const auto& one, const ItemSet& set) {
    return one.first == set.name && one.second == set.count;
  });
  if (!same) {
    throw BadData("the plan lists other items than its command has; plan anew");
  }
}

std::string to_json(const Plan& plan) {
  Json arguments = Json::array();
  for (const ManifestArgument& one : plan.arguments) {
    arguments.push_back({{"text", one.text}, {"input", one.is_input}});
  }
  Json inputs = Json::array();
  for (const PlanInput& one : plan.inputs) {
    inputs.push_back({{"name", one.name},
                      {"place", one.place},
                      {"files", one.digest.files},
                      {"bytes", one.digest.bytes},
                      {"sha256", one.digest.sha256}});
  }
  Json items = Json::array();
  for (const auto& [name, count] : plan.items) {
    items.push_back({{"name", name}, {"count", count}});
  }
  const Json json{{"plan", 1},
                  {"command", plan.command},
                  {"arguments", arguments},
                  {"inputs", inputs},
                  {"items", items},
                  {"shards", plan.shards},
                  {"version", plan.version},
                  {"program", plan.program},
                  {"arithmetic", plan.arithmetic}};
  return json.dump(2) + '\n';
}

ReadPlan read_plan(const fs::path& folder) {
  const fs::path path = folder / "plan.json";
  const std::string file = "'" + path.string() + "'";
  const table::BytesResult read = table::read_file(path);
  if (!read.bytes) {
    throw NoInput("cannot read " + file + ": " + read.problem +
                  "; a plan is made by 'tcert batch plan'");
  }
  const std::string_view text = read.bytes->view();
  ReadPlan found;
  found.digest = sha256(text);
  found.folder = folder;
  if (const std::string_view problem = table::json_shape_problem(text); !problem.empty()) {
    throw BadData(file + ": " + std::string(problem));
  }
  try {
    found.plan = plan_from(Json::parse(text), file);
  } catch (const Json::exception& error) {
    throw BadData(file + " is no plan of this tool: " + error.what());
  }
  const Plan& plan = found.plan;
  const bool is_counted =
      std::ranges::all_of(plan.items, [](const auto& set) { return set.second <= kMostItems; });
  if (plan.shards < 1 || plan.shards > kMostShards || plan.items.size() > kMostShards ||
      !is_counted || plan.count() > kMostItems) {
    throw BadData(file + ": found shards or items out of their ranges");
  }
  require_same_machine(plan, file);
  static_cast<void>(plan.pieces());
  require_same_inputs(plan);
  return found;
}

}  // namespace tcert::cli
