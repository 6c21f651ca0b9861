#include "datasets/import/sqlite_database.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <table/diagnostic.hpp>
#include <table/regular_file.hpp>

namespace tcert::recording {
namespace {

constexpr std::uintmax_t kSlack = std::uintmax_t{1} << 20U;
constexpr std::uintmax_t kLongestRow = std::uintmax_t{1} << 30U;
constexpr const char* kCacheSize = "PRAGMA cache_size = -4096";  // kB

/// `path` as it stands in the URI of a file.
std::string uri_of(const std::filesystem::path& path, std::string_view parameters) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : path.string()) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '/' || c == '.' || c == '-' || c == '_';
    if (is_plain) {
      uri += c;
    } else {
      uri += '%';
      uri += kDigits[code >> 4U];
      uri += kDigits[code & 0xFU];
    }
  }
  uri += '?';
  uri += parameters;
  return uri;
}

/// Bytes of the file beside the database; 0 if there is none.
std::uintmax_t size_beside(const std::filesystem::path& path, const char* suffix) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path.string() + suffix, error);
  return error ? 0 : size;
}

/// True if a journal says that a transaction is to be rolled back: its header is not zeroed.
bool has_hot_journal(const std::filesystem::path& path) {
  std::ifstream journal(path.string() + "-journal", std::ios::binary);
  char first = 0;
  return journal.get(first) && first != 0;
}

/// \throws table::OutOfResources if `code` says that there is too little memory, and there is.
/// SQLite says it of some damaged files too: then there is room for the longest row, and more.
void require_memory(sqlite3* database, int code) {
  if (code != SQLITE_NOMEM) {
    return;
  }
  const int longest = database == nullptr ? 0 : sqlite3_limit(database, SQLITE_LIMIT_LENGTH, -1);
  void* room = sqlite3_malloc64(static_cast<std::uint64_t>(longest) + kSlack);
  const bool has_room = room != nullptr;
  sqlite3_free(room);
  if (!has_room || database == nullptr) {
    throw table::OutOfResources("there is not enough memory for the database of a recording");
  }
}

std::string reason_of(sqlite3* database) { return table::shortened(sqlite3_errmsg(database)); }

}  // namespace

void Query::Finalize::operator()(sqlite3_stmt* statement) const noexcept {
  sqlite3_finalize(statement);
}

void Database::Close::operator()(sqlite3* database) const noexcept { sqlite3_close_v2(database); }

bool Query::next() {
  if (!statement_ || !problem_.empty()) {
    return false;
  }
  const int code = sqlite3_step(statement_.get());
  require_memory(sqlite3_db_handle(statement_.get()), code);
  if (code != SQLITE_ROW && code != SQLITE_DONE) {
    problem_ = reason_of(sqlite3_db_handle(statement_.get()));
  }
  if (code != SQLITE_ROW) {
    statement_.reset();
  }
  return code == SQLITE_ROW;
}

bool Query::is_integer(int column) const noexcept {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_INTEGER;
}

bool Query::is_blob(int column) const noexcept {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_BLOB;
}

std::int64_t Query::integer(int column) const noexcept {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string_view Query::text(int column) const {
  const auto* text = sqlite3_column_text(statement_.get(), column);
  const auto length = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  if (text == nullptr) {
    sqlite3* database = sqlite3_db_handle(statement_.get());
    require_memory(database, sqlite3_errcode(database));
    return {};
  }
  return {reinterpret_cast<const char*>(text), length};
}

std::span<const std::byte> Query::blob(int column) const {
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  const auto length = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  if (bytes == nullptr) {
    sqlite3* database = sqlite3_db_handle(statement_.get());
    require_memory(database, sqlite3_errcode(database));
    return {};
  }
  return {static_cast<const std::byte*>(bytes), length};
}

std::optional<Database> Database::open(const std::filesystem::path& path, std::string& problem) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  if (error) {
    problem = error.message();
    return std::nullopt;
  }
  if (has_hot_journal(real)) {
    problem =
        "a write to it was not finished ('" + real.filename().string() +
        "-journal' lies beside it): copy both elsewhere and let 'sqlite3 COPY .tables' roll it "
        "back";
    return std::nullopt;
  }
  const std::uintmax_t log = size_beside(real, "-wal");
  const std::string uri = uri_of(real, log > 0 ? "mode=ro&vfs=unix-none" : "mode=ro&immutable=1");
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(
      uri.c_str(), &handle, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  Database database;
  database.handle_.reset(handle);
  require_memory(handle, code);
  if (code != SQLITE_OK) {
    table::require_resources(path, sqlite3_system_errno(handle));
    problem = reason_of(handle);
    return std::nullopt;
  }
  const auto longest = std::min(kLongestRow, size_beside(real, "") + log + kSlack);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, static_cast<int>(longest));
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  // Before anything is read: only then does the index of the log stay in memory.
  if (log > 0) {
    static_cast<void>(database.query("PRAGMA locking_mode = EXCLUSIVE").next());
  }
  static_cast<void>(database.query(kCacheSize).next());
  return database;
}

bool Database::has_table(std::string_view table, std::span<const std::string_view> columns) {
  const std::string name(table);
  Query plain = query("SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = '" + name +
                      "' AND sql LIKE 'CREATE TABLE%'");
  if (!plain.next()) {
    return false;
  }
  std::size_t found = 0;
  Query stored = query("SELECT name FROM pragma_table_xinfo('" + name + "') WHERE hidden = 0");
  while (stored.next()) {
    found += std::ranges::count(columns, stored.text(0)) > 0 ? 1U : 0U;
  }
  return found == columns.size();
}

Query Database::query(std::string_view sql) {
  Query query;
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(
      handle_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  query.statement_.reset(statement);
  require_memory(handle_.get(), code);
  if (code != SQLITE_OK) {
    query.problem_ = reason_of(handle_.get());
  }
  return query;
}

}  // namespace tcert::recording
