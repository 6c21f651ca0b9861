#include "reports/paper_names.hpp"

namespace tcert {

const std::vector<PaperName>& paper_names() {
  static const std::vector<PaperName> names = {
      {"CB-V", "steers by a camera; the paper's baseline that sees"},
      {"M1", "one of the same trials that the paper does not describe"},
      {"M2", "one of the same trials that the paper does not describe"},
      {"M3", "steers by touch alone and remembers where it touched something"},
      {"TD*Lite", "a planner, for the paper a classical comparison"},
      {"TVFH", "a steering rule, for the paper a classical comparison"},
  };
  return names;
}

std::string paper_names_text() {
  return "Algorithms: CB-V steers by a camera; M3 steers by touch alone and remembers where it "
         "touched something; TD*Lite and TVFH are the paper's classical comparisons; M1 and M2 ran "
         "in the same trials, and the paper does not describe them.";
}

}  // namespace tcert
