// The ticks of a bundle for programs that link the core alone: export_ticks BUNDLE FILE

#include <fstream>
#include <iostream>

#include "datasets/bundle.hpp"
#include "datasets/trial_reader.hpp"
#include "support/tick_file.hpp"

int main(int argc, char** argv) {
  using namespace tcert;
  if (argc != 3) {
    std::cerr << "export_ticks BUNDLE FILE\n";
    return 2;
  }
  const BundleResult opened = open_bundle(argv[1]);
  if (!opened.bundle || !opened.bundle->info.parameters.empty()) {
    std::cerr << "not a bundle, or one with parameters of its own\n";
    return 1;
  }
  const Bundle& bundle = *opened.bundle;
  test_support::TickFile file{bundle.info.robot, bundle.info.course, bundle.info.seed, {}};
  for (const TrialRow& row : bundle.trials) {
    const TrialResult trial = read_trial(bundle, row);
    if (!trial.log) {
      continue;
    }
    TickTable table = resample(*trial.log);
    test_support::TickFile::Trial& out = file.trials.emplace_back();
    out.id = row.trial_id;
    for (std::size_t k = 0; k < table.size(); ++k) {
      out.ticks.push_back(table[k]);
    }
    out.readings = std::move(table.readings);
  }
  std::ofstream stream(argv[2], std::ios::binary);
  write_tick_file(stream, file);
  stream.flush();
  return stream ? 0 : 1;
}
