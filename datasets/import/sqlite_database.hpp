#pragma once
/// \file
/// An SQLite database of somebody else, opened for reading and left as it is.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace tcert::recording {

/// A query that is being answered.
class Query {
 public:
  /// True if there is a (further) row. False at the end and after an error, which problem() tells.
  /// \throws table::OutOfResources.
  [[nodiscard]] bool next();

  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

  [[nodiscard]] bool is_integer(int column) const noexcept;
  [[nodiscard]] bool is_blob(int column) const noexcept;
  [[nodiscard]] std::int64_t integer(int column) const noexcept;

  /// Both are valid until next(). \throws table::OutOfResources.
  [[nodiscard]] std::string_view text(int column) const;
  [[nodiscard]] std::span<const std::byte> blob(int column) const;

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  std::string problem_;
};

/// Nothing of a database is written, no file is made beside it, and no lock is taken:
///
/// - Without a write-ahead log beside it, the file is opened as one that does not change
///   (immutable), so that SQLite looks for nothing else and a read-only folder will do.
/// - With one ("-wal", left by a recorder that was killed), what stands in the log counts: SQLite
///   reads it with its index in memory (exclusive locking mode, on a VFS without locks, and without
///   the checkpoint at closing that would move the log into the database).
/// - With a hot rollback journal ("-journal") the file holds half a transaction; it is refused.
///
/// A recorder that is still at work may write while it is read; what does not fit together then is
/// said as damage.
class Database {
 public:
  /// Nothing, with the reason in `problem`. \throws table::OutOfResources.
  [[nodiscard]] static std::optional<Database> open(const std::filesystem::path& path,
                                                    std::string& problem);

  /// True if `table` is a plain table (no view, no virtual table) whose columns, all stored and not
  /// computed, include each of `columns`.
  [[nodiscard]] bool has_table(std::string_view table, std::span<const std::string_view> columns);

  /// A query that cannot be prepared has no rows and a problem().
  [[nodiscard]] Query query(std::string_view sql);

 private:
  struct Close {
    void operator()(sqlite3* database) const noexcept;
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

}  // namespace tcert::recording
