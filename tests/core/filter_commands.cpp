// Reads quadratic programs of the barrier filter, a line each: v w, then so many rows a_v a_w
// least. Writes what it makes of them: feasible v w. scripts/check_barrier.R compares with R's
// quadprog.

#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <tcert/barrier_filter.hpp>
#include <vector>

int main() {
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    tcert::Command wanted;
    words >> wanted.speed_mps >> wanted.yaw_rate_rps;
    std::vector<tcert::BarrierRow> rows;
    tcert::BarrierRow row;
    while (words >> row.speed >> row.yaw_rate >> row.least) {
      rows.push_back(row);
    }
    const tcert::FilteredCommand found = tcert::nearest_command(wanted, rows, {});
    std::printf("%d %.17g %.17g\n",
                found.feasible ? 1 : 0,
                found.command.speed_mps,
                found.command.yaw_rate_rps);
  }
  return 0;
}
