#include "reports/sha256.hpp"

#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <new>
#include <system_error>
#include <table/regular_file.hpp>
#include <vector>

namespace tcert {
namespace {

void require(int status) {
  if (status != 1) {
    throw std::bad_alloc();  // OpenSSL's digests fail for want of memory only.
  }
}

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

}  // namespace

struct Sha256::Context {
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> evp{EVP_MD_CTX_new(), EVP_MD_CTX_free};

  void start() const { require(EVP_DigestInit_ex(evp.get(), EVP_sha256(), nullptr)); }
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  require(context_->evp ? 1 : 0);
  context_->start();
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::update(std::string_view bytes) {
  require(EVP_DigestUpdate(context_->evp.get(), bytes.data(), bytes.size()));
}

std::string Sha256::finish() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  require(EVP_DigestFinal_ex(context_->evp.get(), digest.data(), &size));
  context_->start();
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string hex;
  for (std::size_t i = 0; i < size; ++i) {
    hex += kDigits[digest[i] >> 4U];
    hex += kDigits[digest[i] & 0xFU];
  }
  return hex;
}

std::string sha256(std::string_view bytes) {
  Sha256 digest;
  digest.update(bytes);
  return digest.finish();
}

void ListDigest::add(std::string_view path, const FileDigest& digest) {
  lines_.update(digest.sha256);
  lines_.update("  ");
  lines_.update(path);
  lines_.update("\n");
  sum_.files += digest.files;
  sum_.bytes += digest.bytes;
}

FileDigest ListDigest::finish() {
  FileDigest result = sum_;
  result.sha256 = lines_.finish();
  sum_ = {};
  return result;
}

FileDigest digest_file(const std::filesystem::path& path) {
  std::string problem;
  const int descriptor = table::open_regular_file(path, problem);
  if (descriptor < 0) {
    throw std::system_error(errno, std::generic_category(), path.string());
  }
  const FileHandle file(::fdopen(descriptor, "rb"), std::fclose);
  if (!file) {
    ::close(descriptor);
    throw std::bad_alloc();
  }
  FileDigest result{1, 0, {}};
  Sha256 digest;
  std::vector<char> buffer(std::size_t{1} << 16U);
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    digest.update({buffer.data(), got});
    result.bytes += got;
  }
  if (std::ferror(file.get()) != 0) {
    throw std::system_error(errno, std::generic_category(), path.string());
  }
  result.sha256 = digest.finish();
  return result;
}

FileDigest digest_folder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path().lexically_relative(folder));
    }
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return a.generic_string() < b.generic_string();
  });
  ListDigest list;
  for (const auto& file : files) {
    list.add(file.generic_string(), digest_file(folder / file));
  }
  return list.finish();
}

FileDigest digest_path(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? digest_folder(path) : digest_file(path);
}

}  // namespace tcert
