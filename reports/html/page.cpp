#include "reports/html/page.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "reports/html/packed.hpp"
#include "reports/sha256.hpp"
#include "reports/table_json.hpp"

namespace tcert {
namespace {

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::runtime_error("cannot read '" + path.string() + "'");
  }
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What a policy calls a script or style by.
std::string source_of(std::string_view text) {
  const std::string digits = sha256(text);
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  return "'sha256-" + base64(bytes) + "'";
}

std::string policy(const PageAssets& assets) {
  return "default-src 'none'; script-src " + source_of(assets.script) + "; style-src " +
         source_of(assets.style) + "; img-src data:; base-uri 'none'; form-action 'none'";
}

void require_harmless(const std::string& text, std::string_view what) {
  std::string lower = text;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  for (const char* end : {"</script", "</style", "<!--"}) {
    if (lower.find(end) != std::string::npos) {
      throw std::runtime_error("the page's " + std::string(what) + " holds '" + end +
                               "', which would end it early");
    }
  }
}

std::string without_tags(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string joined(const std::vector<std::string>& lines) {
  std::size_t size = 0;
  for (const std::string& line : lines) {
    size += line.size() + 1;
  }
  std::string text;
  text.reserve(size);
  for (const std::string& line : lines) {
    text += line;
    text += '\n';
  }
  return text;
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

PageAssets read_page_assets(const std::filesystem::path& folder) {
  PageAssets assets{file_text(folder / "page.html"),
                    file_text(folder / "page.css"),
                    file_text(folder / "page.js"),
                    {},
                    file_text(folder / "licences.txt")};
  std::istringstream packages(file_text(folder / "packages.txt"));
  for (std::string line; std::getline(packages, line);) {
    assets.packages.push_back(line);
  }
  return assets;
}

std::string page(const PageAssets& assets, const PageData& data) {
  require_harmless(assets.script, "script");
  require_harmless(assets.style, "style");
  const std::vector<std::pair<std::string_view, std::string>> parts = {
      {"policy", policy(assets)},
      {"title", escaped_html(data.title)},
      {"style", assets.style},
      {"report", without_tags(data.report)},
      {"trials", data.trials},
      {"series", joined(data.series)},
      {"worlds", joined(data.worlds)},
      {"frames", joined(data.frames)},
      {"licences", packed(dumped(OrderedJson(assets.licences), -1))},
      {"script", assets.script},
  };
  // In the order of the template, so that nothing is looked for in what was filled in.
  std::string out;
  std::size_t done = 0;
  for (const auto& [name, text] : parts) {
    const std::string place = "{{" + std::string(name) + "}}";
    const std::size_t at = assets.html.find(place, done);
    if (at == std::string::npos) {
      throw std::runtime_error("page.html has no " + place + " where it is expected");
    }
    out.append(assets.html, done, at - done);
    out += text;
    done = at + place.size();
  }
  return out.append(assets.html, done);
}

}  // namespace tcert
