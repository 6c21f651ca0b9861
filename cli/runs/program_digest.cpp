#include "cli/runs/program_digest.hpp"

#include "reports/sha256.hpp"

namespace tcert::cli {

const std::string& program_digest() {
  static const std::string digest = digest_file("/proc/self/exe").sha256;
  return digest;
}

}  // namespace tcert::cli
