#include "reports/federation_report.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <federation/submap_text.hpp>

#include "reports/columns_of.hpp"
#include "reports/findings.hpp"

namespace tcert {
namespace {

using federation::Federation;
using federation::Source;
using federation::Submap;
using federation::SubmapEdge;
using federation::WayStep;

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// In words; infinite where one place lies in S and in G.
std::string stated(double margin_m, const char* without_a_way) {
  if (std::isfinite(margin_m)) {
    return fmt::format("{:.4f} m", margin_m);
  }
  return margin_m > 0.0 ? "S and G meet, so that nothing is to be passed," : without_a_way;
}

std::optional<SyntheticLabel> label_of(const std::string& synthetic) {
  if (synthetic.empty()) {
    return std::nullopt;
  }
  SyntheticLabel label;
  std::uint64_t seed = 0;
  const char* const last = synthetic.data() + synthetic.size();
  const auto [end, error] = std::from_chars(synthetic.data(), last, seed);
  if (error == std::errc{} && end == last) {
    label.seed = seed;
  }
  return label;
}

Table sources_table(const Submap& merged, const Federation& found) {
  struct Row {
    const Source& source;
    double own_m;
    std::size_t joins;
  };
  std::vector<std::size_t> joins(merged.sources.size(), 0);
  for (std::size_t e = found.known.edges.size() - found.known.joins; e < found.known.edges.size();
       ++e) {
    for (const EdgeEnd& end : found.known.edges[e].ends) {
      ++joins[found.known.source[end.node]];
    }
  }
  std::vector<Row> rows;
  for (std::size_t s = 0; s < merged.sources.size(); ++s) {
    rows.push_back({merged.sources[s], found.own[s], joins[s]});
  }
  Table table =
      ColumnsOf<Row>()
          .text("source", "source", [](auto& r) { return r.source.name; })
          .text("margins",
                "margins",
                [](auto& r) { return std::string(federation::name_of(r.source.margins)); })
          .integer("nodes", "nodes", [](auto& r) { return r.source.nodes.size(); })
          .integer("edges", "edges", [](auto& r) { return r.source.edges.size(); })
          .integer("joins", "joins", [](auto& r) { return r.joins; })
          .fixed("frame_error_m",
                 "frame error",
                 "m",
                 3,
                 [](auto& r) { return if_finite(r.source.frame_error_m); })
          .fixed("frame_error_rad",
                 "of heading",
                 "rad",
                 4,
                 [](auto& r) { return if_finite(r.source.frame_error_rad); })
          .fixed("certificate_m", "T alone", "m", 4, [](auto& r) { return if_finite(r.own_m); })
          .answer()
          .table("sources", "What each source knows", rows);
  table.footnotes = {
      "T alone: of its own edges, NA where they do not lead from S to G. A source whose frame "
      "error "
      "is NA is joined to no other. Joins: of the union that have an end in it."};
  return table;
}

Table way_table(const Submap& merged, const Federation& found) {
  struct Row {
    const SubmapEdge& edge;
    WayStep step;
    const Federation& found;
    const Submap& merged;
    [[nodiscard]] std::uint32_t node(std::size_t which) const {
      return edge.ends[step.is_reversed ? 1 - which : which].node;
    }
    [[nodiscard]] const Pose& pose(std::size_t which) const {
      return found.known.nodes[node(which)].pose;
    }
    [[nodiscard]] const std::string& source(std::size_t which) const {
      return merged.sources[found.known.source[node(which)]].name;
    }
  };
  std::vector<Row> rows;
  for (const WayStep& step : found.way.steps) {
    rows.push_back({found.known.edges[step.edge], step, found, merged});
  }
  return ColumnsOf<Row>()
      .text("from_source", "of", [](auto& r) { return r.source(0); })
      .fixed("from_x_m", "x", "m", 3, [](auto& r) { return r.pose(0).position.x_m; })
      .fixed("from_y_m", "y", "m", 3, [](auto& r) { return r.pose(0).position.y_m; })
      .text("to_source", "to", [](auto& r) { return r.source(1); })
      .fixed("to_x_m", "x", "m", 3, [](auto& r) { return r.pose(1).position.x_m; })
      .fixed("to_y_m", "y", "m", 3, [](auto& r) { return r.pose(1).position.y_m; })
      .yes_or_no("join", "join", [](auto& r) { return r.source(0) != r.source(1); })
      .fixed("margin_m", "margin", "m", 4, [](auto& r) { return r.edge.margin_m; })
      .answer()
      .table("way", "The widest way from S to G", rows);
}

Table federation_findings(const Submap& merged, const Federation& found) {
  std::vector<Finding> findings;
  double best_m = -std::numeric_limits<double>::infinity();
  std::size_t alone = 0;
  std::size_t unknown = 0;
  federation::MarginKind kind = federation::MarginKind::witness;
  for (std::size_t s = 0; s < merged.sources.size(); ++s) {
    best_m = std::max(best_m, found.own[s]);
    alone += found.own[s] > 0.0 && std::isfinite(found.own[s]) ? 1U : 0U;
    unknown += std::isfinite(merged.sources[s].frame_error_m) &&
                       std::isfinite(merged.sources[s].frame_error_rad)
                   ? 0U
                   : 1U;
    kind = std::max(kind, merged.sources[s].margins);
  }
  findings.push_back(
      {"T_H",
       found.way.margin_m > 0.0 && std::isfinite(found.way.margin_m) ? "issued" : "not issued",
       fmt::format(
           "{} together, {} at best alone; {} of {} sources have a certificate of their own.",
           stated(found.way.margin_m, "No way from S to G is known"),
           stated(best_m, "none"),
           alone,
           merged.sources.size())});
  if (unknown > 0 && merged.sources.size() > 1) {
    findings.push_back(
        {"Frames",
         "",
         fmt::format(
             "{} of {} sources state no bound on the error of their frame and are joined to "
             "none: --frame-error-m and --frame-error-rad state one for them.",
             unknown,
             merged.sources.size())});
  }
  if (kind != federation::MarginKind::witness) {
    findings.push_back(
        {"Margins",
         "",
         fmt::format("Those read by {} are no lower bounds for sure: certify with --witness-edges.",
                     federation::name_of(kind))});
  }
  return findings_table(findings,
                        {"T_H is at most T(E; A) if every edge's margin is a lower bound, frame "
                         "errors are bounded as stated and all sources mean the same S and G."});
}

}  // namespace

FitReport federation_report(const Submap& merged,
                            const Federation& found,
                            const std::vector<GivenSubmap>& given) {
  const std::string text = federation::to_text(merged);
  std::size_t bytes = 0;
  for (const GivenSubmap& one : given) {
    bytes += one.bytes;
  }
  FitReport report;
  report.model = "federate";
  report.synthetic = label_of(merged.synthetic);
  report.findings = federation_findings(merged, found);
  Record summary("summary", "The union");
  summary.integer("files", "files", given.size())
      .integer("bytes_given", "bytes given", bytes)
      .integer("sources", "sources", merged.sources.size())
      .integer("nodes", "nodes", found.known.nodes.size())
      .integer("edges", "edges", found.known.edges.size() - found.known.joins)
      .integer("joins", "joins", found.known.joins)
      .number("certificate_m", "T_H, m", if_finite(found.way.margin_m))
      .integer("bytes_merged", "bytes merged", text.size());
  report.summary = std::move(summary).table();
  report.tables = {sources_table(merged, found), way_table(merged, found)};
  report.attachments = {{"merged", "The union, which others can merge again:", text, "submap"}};
  return report;
}

}  // namespace tcert
