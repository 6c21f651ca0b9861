#include <table/path_name.hpp>

#include <algorithm>
#include <table/utf8.hpp>

namespace tcert::table {
namespace {

bool is_control_byte(char c) noexcept {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20U || code == 0x7FU;
}

bool may_be_in_a_name(char c) noexcept { return !is_control_byte(c) && c != '/' && c != '\\'; }

}  // namespace

bool is_file_name(std::string_view name) noexcept {
  return !name.empty() && name.size() <= kLongestFileName && name.front() != '.' &&
         std::ranges::all_of(name, may_be_in_a_name);
}

bool is_path_step(std::string_view name) noexcept {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\0", 2)) == std::string_view::npos;
}

bool leads_below(const std::filesystem::path& path) {
  return !path.empty() && path.is_relative() &&
         std::ranges::all_of(
             path, [](const std::filesystem::path& part) { return is_path_step(part.native()); });
}

std::string as_file_name(std::string_view name) {
  std::size_t length = std::min(name.size(), kLongestFileName);
  while (length > 0 && length < name.size() && continues_character(name[length])) {
    --length;
  }
  std::string result(name.substr(0, length));
  std::ranges::replace_if(
      result, [](char c) { return !may_be_in_a_name(c); }, '_');
  if (result.empty()) {
    return "_";
  }
  if (result.front() == '.') {
    result.front() = '_';
  }
  return result;
}

bool is_temporary_name(std::string_view name) noexcept {
  return name.size() > 5 && name.starts_with('.') && name.ends_with(".tmp");
}

}  // namespace tcert::table
