#include "reports/result_store.hpp"

#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "datasets/atomic_file.hpp"
#include "reports/sha256.hpp"

namespace tcert {

namespace fs = std::filesystem;

ResultStore::ResultStore(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) {
    throw WriteError("cannot create the folder '" + folder_.string() + "': " + error.message());
  }
}

fs::path ResultStore::path_of(std::string_view key) const {
  return folder_ / key.substr(0, 2) / key.substr(2);
}

std::optional<std::string> ResultStore::get(std::string_view key) const {
  std::ifstream file(path_of(key), std::ios::binary);
  std::string digest;
  if (!file || !std::getline(file, digest)) {
    return std::nullopt;
  }
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return sha256(bytes) == digest ? std::optional(std::move(bytes)) : std::nullopt;
}

void ResultStore::put(std::string_view key, std::string_view bytes) const {
  AtomicFile file(path_of(key));
  file.write(sha256(bytes) + '\n');
  file.write(bytes);
  file.commit(Durable::no);
}

}  // namespace tcert
