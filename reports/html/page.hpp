#pragma once
/// \file
/// The report page: one HTML file of the page's own scripts and style and the data that they show.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tcert {

/// What the build has made of reports/page: installed as share/tcert/page.
struct PageAssets {
  std::string html;  ///< With {{policy}}, {{title}} ... in the places of what page() fills in.
  std::string style;
  std::string script;
  std::vector<std::string> packages;  ///< "vega 6.4.0 (BSD-3-Clause)".
  std::string licences;               ///< Of everything that is in the script.
};

/// \throws std::runtime_error if a file is not there, naming it.
[[nodiscard]] PageAssets read_page_assets(const std::filesystem::path& folder);

/// What a page shows. Lines are packed() JSON, one element each.
struct PageData {
  std::string title;
  std::string report;  ///< JSON: tables, figures, methods, provenance.
  std::string trials;  ///< The list of trials; empty if there is none.
  /// One a trial, in the order of the list, or none: the number of its world, if it has one, a
  /// space, and its trial_block().
  std::vector<std::string> series;
  std::vector<std::string> worlds;
  std::vector<std::string> frames;
};

/// The page. Its Content-Security-Policy lets nothing run but the script and the style of `assets`,
/// by their SHA-256, and reaches no network. Data cannot end the block it stands in: '<' in JSON is
/// written as an escape, and packed lines have none.
/// \throws std::runtime_error if the script or the style holds what would end it early.
[[nodiscard]] std::string page(const PageAssets& assets, const PageData& data);

/// `text` for an element or an attribute in quotes.
[[nodiscard]] std::string escaped_html(std::string_view text);

}  // namespace tcert
