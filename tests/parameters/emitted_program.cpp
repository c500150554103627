// The test emitted_source_compiles builds this from freshly emitted headers: they compile and hold the
// figures.
#include "constants.h"
#include "disk_tables.h"
#include "expected.h"

int main() {
  namespace constants = penumbra::cascade_constants;
  static_assert(constants::kDepthToRadial[3] == EXPECTED_DEPTH_TO_RADIAL);
  static_assert(constants::kWorldToShadow.size() == 4 && constants::kWorldToShadow[0].size() == 16);
  static_assert(penumbra::disk_tables::kPoisson128.size() == 128);
  return 0;
}
