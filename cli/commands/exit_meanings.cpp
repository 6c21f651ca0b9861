#include "cli/commands/exit_meanings.hpp"

#include <array>

namespace tcert::cli {
namespace {

constexpr std::array<ExitMeaning, 10> kMeanings{
    {{"0", "done"},
     {"1", "a check found something"},
     {"2", "wrong usage"},
     {"3", "done, but some trials, cells or lines were rejected, or parts of a batch are missing"},
     {"4 to 8", "ends of 'tcert explore'"},
     {"65", "bad data"},
     {"66", "no such input"},
     {"70", "a fault of this tool"},
     {"71", "the system has too little of something (memory, descriptors, threads)"},
     {"73", "cannot write"}}};

}  // namespace

std::span<const ExitMeaning> exit_meanings() { return kMeanings; }

}  // namespace tcert::cli
