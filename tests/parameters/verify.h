// The error of every emitted float, in ULP of that float, against a second derivation in long double.
//
// The second derivation deliberately uses other formulas: the sphere from the corners' positions, up by
// Gram-Schmidt, world_to_shadow by inverting the map from shadow to world, scales from the tile's extent in
// metres instead of the matrix's rows. So it also detects errors of the formulas, not only of rounding.
//
// One ULP of an entry is the spacing of floats at it; for an entry smaller than 2^-24 of the largest in its
// vector or matrix row, the spacing there: smaller differences are below the row's own rounding error.
#pragma once

#include <string>
#include <vector>

#include "parameters/cascades.h"

namespace penumbra::parameters {

struct FieldError {
  std::string field;  // the JSON's name of it
  double ulp = 0.0;   // error of the worst entry
};

using CascadeErrors = std::vector<FieldError>;

double worst_ulp(const CascadeErrors& errors);

// These return one list per cascade. For a fit, the check covers everything from the settings on.
std::vector<CascadeErrors> verify_fit(const Camera& camera, const Light& light,
                                      const ShadowSettings& settings, const CascadeSet& set);

// For dumped matrices, the check covers what follows from them.
std::vector<CascadeErrors> verify_dump(const ShadowSettings& settings, const CascadeSet& set);

// Returns |emitted - exact| in spacings of floats at max(|emitted|, 2^-24 * scale).
double ulp_error(float emitted, long double exact, double scale);

}  // namespace penumbra::parameters
