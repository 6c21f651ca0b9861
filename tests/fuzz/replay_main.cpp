// Runs a fuzz target where libFuzzer is not linked: on files and folders of files, or, with
// --spoil SEED COUNT before them, on so many inputs that are made of theirs by edits at random. An
// input that ends the process is left in the file 'spoiled_input'.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::string input;  // the one that is being tried

void try_input() {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

extern "C" void keep_input(int signal) {
  const int file = ::open("spoiled_input", O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const auto written = ::write(file, input.data(), input.size());
  std::signal(signal, SIG_DFL);
  std::raise(written >= 0 ? signal : SIGKILL);
}

std::vector<std::string> files_of(int count, char** names) {
  std::vector<std::string> contents;
  const auto add = [&](const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    contents.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    if (file.bad()) {
      contents.pop_back();
    }
  };
  for (int i = 0; i < count; ++i) {
    if (fs::is_directory(names[i])) {
      std::vector<fs::path> entries;
      for (const fs::directory_entry& entry : fs::directory_iterator(names[i])) {
        entries.push_back(entry.path());
      }
      std::sort(entries.begin(), entries.end());
      std::for_each(entries.begin(), entries.end(), add);
    } else {
      add(names[i]);
    }
  }
  return contents;
}

/// Edits as a disk, an editor or a stranger makes them.
class Spoiler {
 public:
  Spoiler(std::uint64_t seed, const std::vector<std::string>& kept) : engine_(seed), kept_(kept) {}

  void make(std::string& text) {
    text = kept_.empty() ? std::string() : kept_[below(kept_.size())];
    for (std::size_t edits = std::size_t{1} << below(5); edits > 0; --edits) {
      edit(text);
    }
    text.resize(std::min(text.size(), kMost));
  }

 private:
  static constexpr std::size_t kMost = 1U << 16U;
  static constexpr std::array<std::string_view, 24> kTokens = {
      "1e400", "-1",     "nan",     "-inf",         "0x1F", "1e",      "NA", "\"",
      ",,",    "\r\n",   "\n",      "\xEF\xBB\xBF", "[[[[", "{\"a\":", "}",  "9223372036854775808",
      "-0.0",  "5e-324", "\\u0000", "\xFF\xFE",     "null", "#",       "~",  "()"};

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

  void edit(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::size_t{1} << below(9);
    switch (below(8)) {
      case 0:
        if (at < text.size()) {
          text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        }
        break;
      case 1:
        if (at < text.size()) {
          text[at] = static_cast<char>(below(256));
        }
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, std::string(text, at, length));
        break;
      case 4:
        text.insert(at, kTokens[below(kTokens.size())]);
        break;
      case 5:
        if (at + 8 <= text.size()) {
          const std::uint64_t any = engine_() >> below(64);
          std::memcpy(text.data() + at, &any, std::size_t{1} << below(4));
        }
        break;
      case 6:
        if (!kept_.empty()) {
          const std::string& other = kept_[below(kept_.size())];
          const std::size_t from = below(other.size() + 1);
          text.replace(at, std::min(length, text.size() - at), other, from, length);
        }
        break;
      default:
        if (below(8) == 0) {
          text.resize(at);
        }
        break;
    }
  }

  std::mt19937_64 engine_;
  const std::vector<std::string>& kept_;
};

}  // namespace

int main(int argc, char** argv) {
  const bool spoils = argc > 3 && std::string_view(argv[1]) == "--spoil";
  const int first = spoils ? 4 : 1;
  const std::vector<std::string> kept = files_of(argc - first, argv + first);
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGBUS}) {
    std::signal(signal, keep_input);
  }
  std::uint64_t count = 0;
  for (const std::string& one : kept) {
    input = one;
    try_input();
    ++count;
  }
  if (spoils) {
    Spoiler spoiler(std::strtoull(argv[2], nullptr, 10), kept);
    for (std::uint64_t left = std::strtoull(argv[3], nullptr, 10); left > 0; --left, ++count) {
      spoiler.make(input);
      try_input();
    }
  }
  std::printf("%llu inputs\n", static_cast<unsigned long long>(count));
  return count > 0 ? 0 : 1;
}
