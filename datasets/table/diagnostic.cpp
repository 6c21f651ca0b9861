#include <table/diagnostic.hpp>

#include <algorithm>
#include <array>
#include <table/printable.hpp>
#include <table/utf8.hpp>
#include <utility>

namespace tcert::table {

namespace {

constexpr std::size_t kLongestValue = 40;

std::string_view severity_name(Severity severity) noexcept {
  constexpr std::array<std::string_view, 3> kNames{"note", "warning", "error"};
  return kNames[static_cast<std::size_t>(severity)];
}

std::string_view cut_between_characters(std::string_view text, std::size_t length) noexcept {
  if (text.size() <= length) {
    return text;
  }
  std::size_t cut = length;
  while (cut > 0 && length - cut < kLongestCharacter && continues_character(text[cut])) {
    --cut;
  }
  return text.substr(0, length - cut < kLongestCharacter ? cut : length);
}

}  // namespace

std::string shortened(std::string_view text) {
  const std::string_view kept = cut_between_characters(text, kLongestValue);
  return printable(kept) + (kept.size() < text.size() ? "..." : "");
}

std::string to_string(const Diagnostic& diagnostic) {
  std::string out = diagnostic.file;
  if (diagnostic.line != 0) {
    out += ':' + std::to_string(diagnostic.line);
  }
  out += out.empty() ? "" : ": ";
  out += severity_name(diagnostic.severity);
  out += ": ";
  if (!diagnostic.column.empty()) {
    out += "column '" + diagnostic.column + "': ";
  }
  if (!diagnostic.value.empty()) {
    out += "found '" + diagnostic.value + "', ";
  }
  out += "expected " + diagnostic.expectation;
  if (diagnostic.count > 1) {
    out += " (and " + std::to_string(diagnostic.count - 1) + " more)";
  }
  return out;
}

bool has_error(std::span<const Diagnostic> diagnostics) noexcept {
  return std::ranges::any_of(diagnostics,
                             [](const Diagnostic& d) { return d.severity == Severity::error; });
}

void DiagnosticGroups::add(Diagnostic diagnostic) {
  Kind kind{diagnostic.severity, diagnostic.file, diagnostic.column, diagnostic.expectation};
  const auto [place, is_new] = index_.try_emplace(std::move(kind), groups_.size());
  if (is_new) {
    groups_.push_back(std::move(diagnostic));
  } else {
    groups_[place->second].count += diagnostic.count;
  }
}

std::vector<Diagnostic> DiagnosticGroups::take() {
  index_.clear();
  return std::exchange(groups_, {});
}

}  // namespace tcert::table
