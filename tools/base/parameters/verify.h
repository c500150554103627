// The error of every float that is emitted, in ULP of that float, against a second derivation in long double.
//
// The second derivation takes other roads on purpose: the sphere from the corners' positions, up by
// Gram-Schmidt, world_to_shadow by inverting the map from shadow to world, scales from the tile's extent in
// metres instead of the matrix's rows. An error of the formula therefore shows, not only one of rounding.
//
// One ULP of an entry is the spacing of floats at it; of an entry smaller than 2^-24 of its vector's or
// matrix row's largest, the spacing there: what is smaller than the row's own rounding cannot be seen in a
// result.
#pragma once

#include <string>
#include <vector>

#include "parameters/cascades.h"

namespace penumbra::parameters {

struct FieldError {
  std::string field;  // as the JSON calls it
  double ulp = 0.0;   // the worst entry's
};

using CascadeErrors = std::vector<FieldError>;

double worst_ulp(const CascadeErrors& errors);

// One list per cascade. For a fit: everything from the settings on.
std::vector<CascadeErrors> verify_fit(const Camera& camera, const Light& light,
                                      const ShadowSettings& settings, const CascadeSet& set);

// For dumped matrices: what follows from them.
std::vector<CascadeErrors> verify_dump(const ShadowSettings& settings, const CascadeSet& set);

// |emitted - exact| in spacings of floats at max(|emitted|, 2^-24 * scale).
double ulp_error(float emitted, long double exact, double scale);

}  // namespace penumbra::parameters
