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

Plan plan_from(const Json& json) {
  Plan plan;
  json.at("command").get_to(plan.command);
  for (const Json& one : json.at("arguments")) {
    plan.arguments.push_back({one.at("text").get<std::string>(), one.at("input").get<bool>()});
  }
  for (const Json& one : json.at("inputs")) {
    plan.inputs.push_back({one.at("name").get<std::string>(),
                           one.at("place").get<std::string>(),
                           {one.at("files").get<std::uint64_t>(),
                            one.at("bytes").get<std::uint64_t>(),
                            one.at("sha256").get<std::string>()}});
  }
  for (const Json& one : json.at("items")) {
    plan.items.emplace_back(one.at("name").get<std::string>(),
                            one.at("count").get<std::uint64_t>());
  }
  json.at("shards").get_to(plan.shards);
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
  for (const PlanInput& input : plan.inputs) {
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
    found.plan = plan_from(Json::parse(text));
    const Plan& plan = found.plan;
    if (plan.shards < 1 || plan.shards > kMostShards || plan.count() > kMostItems) {
      throw BadData(file + ": found shards or items out of their ranges");
    }
  } catch (const Json::exception& error) {
    throw BadData(file + " is no plan of this tool: " + error.what());
  }
  require_same_machine(found.plan, file);
  return found;
}

}  // namespace tcert::cli
