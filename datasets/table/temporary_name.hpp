#pragma once
/// \file
/// Names of what has no name yet: `.NAME.PID-N.tmp`, `.NAME.PID-N.kept.tmp`.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <table/atomic_file.hpp>

namespace tcert::table {

/// The name of `path` as its temporaries have it: the first 210 bytes. Of a temporary, that of what
/// it is called after, so that both are swept together.
[[nodiscard]] std::string name_in_temporary(const std::filesystem::path& path);

/// Hidden, beside `path`, and not used by another thread or process.
[[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& path,
                                                   Leftover leftover);

/// What a temporary is called after.
struct TemporaryName {
  std::string name;  ///< That the file or folder was to have.
  pid_t process = 0;
};

/// Empty unless it is the name of a temporary that may be swept.
[[nodiscard]] std::optional<TemporaryName> swept_name_from(std::string_view name);

/// True if the process that made the temporary at `path` is dead and nobody holds it: then nobody
/// will ever finish it.
[[nodiscard]] bool is_forsaken(const std::filesystem::path& path,
                               const TemporaryName& name) noexcept;

}  // namespace tcert::table
