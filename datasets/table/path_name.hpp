#pragma once
/// \file
/// The one rule for names that become paths: of trials, worlds, figures, inputs of a manifest.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace tcert::table {

/// Longest name in bytes: with what is put round it ("trial_<id>_series.vl.json") it stays below
/// the 255 bytes that file systems allow.
inline constexpr std::size_t kLongestFileName = 230;

/// The rule in words, fit to follow "expected ".
inline constexpr std::string_view kFileNameRule =
    "a name that can be that of a file: not empty, without / and \\ and control characters, no '.' "
    "at its beginning, at most 230 bytes";

/// True if `name` may become the name of a file or folder of ours: see kFileNameRule. So it is
/// neither '.' nor '..', nor hidden, nor a temporary.
[[nodiscard]] bool is_file_name(std::string_view name) noexcept;

/// True if `name` is one step downwards of a path and no more: not empty, '.' or '..', without '/'
/// and zero bytes. For names of what somebody else has made.
[[nodiscard]] bool is_path_step(std::string_view name) noexcept;

/// True if `path` leads to something below the folder that it is relative to: every part is
/// is_path_step(), and it does not begin with '/'.
[[nodiscard]] bool leads_below(const std::filesystem::path& path);

/// `name` as a name of a file: what may not be in one becomes '_', what is too long is cut between
/// characters.
[[nodiscard]] std::string as_file_name(std::string_view name);

/// True for the names of what AtomicFile and AtomicFolder have not committed: a '.' before, '.tmp'
/// behind. Such a thing is never a result, nor an input.
[[nodiscard]] bool is_temporary_name(std::string_view name) noexcept;

}  // namespace tcert::table
