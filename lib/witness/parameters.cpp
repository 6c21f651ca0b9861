#include <tcert/elementary.hpp>
#include <witness/parameters.hpp>

namespace tcert::witness {

FreeSpaceOptions free_space_options(const WitnessParameters& parameters,
                                    const CertificateParameters& certificate) noexcept {
  return {parameters.witness_cell_m,
          {certificate.least_obstacle_m,
           0.5 / elementary::tan(0.5 * certificate.sharpest_corner_rad),
           parameters.reading_bound_m},
          parameters.max_witness_cells};
}

}  // namespace tcert::witness
