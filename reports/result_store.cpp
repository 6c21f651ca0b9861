#include "reports/result_store.hpp"

#include <system_error>
#include <table/atomic_file.hpp>
#include <table/bytes.hpp>
#include <utility>

#include "reports/sha256.hpp"

namespace tcert {

namespace fs = std::filesystem;

namespace {

/// The first two digits of keys.
bool is_part(std::string_view name) {
  return name.size() == 2 && name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// Of an entry and the name that it belongs under, so that no other entry passes for it.
std::string digest_of(std::string_view key, std::string_view bytes) {
  Sha256 digest;
  digest.update(key);
  digest.update(bytes);
  return digest.finish();
}

}  // namespace

ResultStore::ResultStore(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) {
    throw table::WriteError("cannot create the folder '" + folder_.string() +
                            "': " + error.message());
  }
  for (fs::directory_iterator part(folder_, error), end; !error && part != end;
       part.increment(error)) {
    if (!is_part(part->path().filename().native())) {
      continue;  // The folder may hold other things, which are not ours to sweep.
    }
    table::sweep_leftovers_in(part->path());
  }
}

fs::path ResultStore::path_of(std::string_view key) const {
  return folder_ / key.substr(0, 2) / key.substr(2);
}

std::optional<std::string> ResultStore::get(std::string_view key) const {
  const table::BytesResult file = table::read_raw_file(path_of(key));
  const std::string_view text = file.bytes ? file.bytes->view() : std::string_view();
  const std::size_t line = text.find('\n');
  if (line == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view bytes = text.substr(line + 1);
  return digest_of(key, bytes) == text.substr(0, line) ? std::optional(std::string(bytes))
                                                       : std::nullopt;
}

void ResultStore::put(std::string_view key, std::string_view bytes) const {
  table::AtomicFile file(path_of(key));
  file.write(digest_of(key, bytes) + '\n');
  file.write(bytes);
  file.commit(table::Durable::no);
}

}  // namespace tcert
