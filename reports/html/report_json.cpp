#include "reports/html/report_json.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "analysis/study/trials/parameters.hpp"
#include "reports/figure/set_figures.hpp"
#include "reports/figure/vega_lite.hpp"
#include "reports/html/findings_json.hpp"
#include "reports/html/glossary.hpp"
#include "reports/html/trial_block.hpp"
#include "reports/table_json.hpp"
#include "reports/version.hpp"

namespace tcert {
namespace {

using Json = OrderedJson;

std::string tool_words(std::string_view version, std::string_view commit) {
  return "tcert " + std::string(version) + ", commit " + std::string(commit.substr(0, 12));
}

std::string shown_name(const Result& result) {
  return result.name == "." ? "results" : result.name;
}

Json json_table(const PageTable& page_table, std::size_t id) {
  const Table& table = page_table.table;
  Json json;
  json["id"] = id;
  json["name"] = table.name;
  json["title"] = table.title;
  json["source"] = page_table.source;
  json["group"] = page_table.group.empty() ? page_table.source : page_table.group;
  json["main"] = page_table.is_main;
  json["n"] = table.n ? Json(*table.n) : Json();
  json["columns"] = Json::array();
  for (const Column& column : table.columns) {
    json["columns"].push_back({{"name", column.name},
                               {"heading", column.heading.empty() ? column.name : column.heading},
                               {"unit", column.unit},
                               {"numeric", column.kind != ColumnKind::text}});
  }
  json["rows"] = Json::array();
  for (const auto& cells : table.rows) {
    Json row = Json::array();
    for (std::size_t c = 0; c < cells.size(); ++c) {
      row.push_back(printed(cells[c], table.columns[c]));
    }
    json["rows"].push_back(std::move(row));
  }
  json["footnotes"] = table.footnotes;
  json["csv"] = render(table, TableFormat::csv);
  return json;
}

Json json_figure(const Figure& figure, std::size_t id) {
  return {{"id", id},
          {"name", figure.name},
          {"title", figure.title},
          {"caption", figure.caption},
          {"wide", figure.columns > 1},
          {"spec", vega_lite(figure)},
          {"csv", figure_csv(figure)}};
}

std::string words_of(const std::string& setting) { return setting.empty() ? "NA" : setting; }

Json json_files(const std::vector<ManifestFile>& files) {
  Json rows = Json::array();
  for (const ManifestFile& file : files) {
    rows.push_back(Json::array({file.path,
                                std::to_string(file.digest.files),
                                std::to_string(file.digest.bytes),
                                file.digest.sha256}));
  }
  return rows;
}

/// The command as it was given, inputs by their names alone.
std::string command_words(const WrittenResult& manifest) {
  std::string words = "tcert " + manifest.command;
  if (manifest.arguments) {
    for (const ManifestArgument& argument : *manifest.arguments) {
      words += ' ' + argument.text;
    }
  }
  return words;
}

Json json_result(const Result& result) {
  const WrittenResult& manifest = result.manifest;
  Json json;
  json["name"] = shown_name(result);
  json["command"] = command_words(manifest);
  json["tool"] = tool_words(manifest.tool_version, manifest.tool_commit);
  json["seed"] = manifest.seed ? Json(*manifest.seed) : Json();
  json["options"] = Json::array();
  for (const auto& [key, value] : manifest.options) {
    json["options"].push_back(Json::array({key, words_of(value)}));
  }
  json["inputs"] = json_files(manifest.inputs);
  json["outputs"] = json_files(manifest.outputs);
  return json;
}

Json parameter_rows(const Settings& parameters) {
  Json rows = Json::array();
  for (const auto& [key, value] : parameters) {
    std::string unit;
    std::string doc;
    for (const study::ParameterInfo& info : study::parameter_table()) {
      if (info.key == key) {
        unit = info.unit;
        doc = info.doc;
      }
    }
    rows.push_back(Json::array({key, value.empty() ? "not set" : value, unit, doc}));
  }
  return rows;
}

/// One table of parameters for all results that share them, in the order of the results.
Json json_settings(const std::vector<Result>& results) {
  std::vector<std::pair<Settings, std::string>> sets;
  for (const Result& result : results) {
    const Settings& parameters = result.manifest.parameters;
    if (parameters.empty()) {
      continue;
    }
    const auto same = std::find_if(
        sets.begin(), sets.end(), [&](const auto& set) { return set.first == parameters; });
    if (same == sets.end()) {
      sets.emplace_back(parameters, shown_name(result));
    } else {
      same->second += ", " + shown_name(result);
    }
  }
  Json json = Json::array();
  for (const auto& [parameters, names] : sets) {
    json.push_back({{"title", "Every parameter, as it took effect: " + names},
                    {"rows", parameter_rows(parameters)}});
  }
  return json;
}

std::vector<std::string> methods_text(const PageContents& contents) {
  std::vector<std::string> text = {
      "At every tick the robot's rays prove a free width across the path and the path has a turn "
      "radius; the tick's margin m_t is the smaller of what both leave to the body. Ticks are "
      "gathered into edges of the corridor graph, each with the least margin on it.",
      "The on-policy corridor value V_t is the bottleneck of the widest path through that graph "
      "from the start S to the node where the robot is; the certificate T_t is that from S to the "
      "goal G. It never falls, and is issued when it is first above 0. While unknown space counts "
      "as occupied it is meant as a lower bound on T(E; A), the best margin that any way through "
      "the place E has for the robot A.",
      "TC_early, the feature of a trial, is the 10th percentile of the series over the early "
      "window, by time and by way, the worse of the two.",
      "Missing values are NA, never 0. Tables round in print only: their CSV has every digit. What "
      "each table and figure does with intervals, clusters and ties stands below it.",
  };
  text.push_back("In the viewer a long trial shows fewer ticks than it has: " +
                 std::string(decimation_rule()));
  if (!contents.packages.empty()) {
    std::string drawn = "Drawn with ";
    for (const std::string& package : contents.packages) {
      drawn += (&package == &contents.packages.front() ? "" : ", ") + package;
    }
    text.push_back(drawn + ".");
  }
  return text;
}

Json json_column(const PageColumn& column) {
  return {{"name", column.name},
          {"heading", column.heading},
          {"unit", column.unit},
          {"decimals", column.decimals},
          {"steps", column.steps}};
}

Json json_series() {
  Json json;
  json["rule"] = decimation_rule();
  json["readout"] = Json::array();
  json["panels"] = Json::array();
  for (const PagePanel& panel : page_panels()) {
    json["panels"].push_back(
        {{"title", panel.title}, {"unit", panel.unit}, {"columns", Json::array()}});
  }
  for (const PageColumn& column : page_columns()) {
    json["readout"].push_back(json_column(column));
    if (column.panel >= 0) {
      json["panels"][static_cast<std::size_t>(column.panel)]["columns"].push_back(
          json_column(column));
    }
  }
  return json;
}

/// Of what stands in findings, tables, captions and methods.
Json json_glossary(const Json& json, const PageContents& contents) {
  std::string text = json["findings"].dump(-1, ' ', false, Json::error_handler_t::replace);
  for (const Json& table : json["tables"]) {
    text += table["columns"].dump(-1, ' ', false, Json::error_handler_t::replace) +
            table["rows"].dump(-1, ' ', false, Json::error_handler_t::replace) +
            table["footnotes"].dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  for (const Figure& figure : contents.figures) {
    text += figure.title + ' ' + figure.caption + ' ';
  }
  for (const std::string& paragraph : methods_text(contents)) {
    text += paragraph + ' ';
  }
  const bool of_paper =
      std::any_of(contents.tables.begin(), contents.tables.end(), [](const PageTable& one) {
        return one.table.name == "speed" && has_published_speeds(one.table);
      });
  Json entries = Json::array();
  for (const GlossaryEntry& entry : glossary_of(text, of_paper)) {
    entries.push_back(Json::array({entry.term, entry.meaning}));
  }
  return entries;
}

Json json_frames(const PageFrames& set, std::size_t id) {
  Json json = {{"id", id}, {"title", set.title}, {"frames", Json::array()}};
  for (const PageFrames::Frame& frame : set.frames) {
    json["frames"].push_back({{"name", frame.name}, {"type", frame.type}, {"line", frame.line}});
  }
  return json;
}

}  // namespace

std::string report_json(const PageContents& contents) {
  Json json;
  json["title"] = contents.title;
  json["lead"] = contents.lead;
  json["tool"] = tool_words(tool_version(), tool_commit());
  json["synthetic"] = contents.synthetic ? Json(to_string(*contents.synthetic)) : Json();
  json["findings"] = findings_json(contents.findings);
  json["tables"] = Json::array();
  for (std::size_t i = 0; i < contents.tables.size(); ++i) {
    json["tables"].push_back(json_table(contents.tables[i], i));
  }
  json["figures"] = Json::array();
  for (std::size_t i = 0; i < contents.figures.size(); ++i) {
    json["figures"].push_back(json_figure(contents.figures[i], i));
  }
  json["glossary"] = json_glossary(json, contents);
  json["series"] = json_series();
  json["frames"] = Json::array();
  for (std::size_t i = 0; i < contents.frames.size(); ++i) {
    json["frames"].push_back(json_frames(contents.frames[i], i));
  }
  json["methods"]["text"] = methods_text(contents);
  json["methods"]["settings"] = json_settings(contents.results);
  json["provenance"] = Json::array();
  for (const Result& result : contents.results) {
    json["provenance"].push_back(json_result(result));
  }
  json["left_out"] = contents.left_out;
  return dumped(json, -1);
}

}  // namespace tcert
