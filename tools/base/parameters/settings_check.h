// The first problem of a camera, a light and shadow settings, named so that a reader of JSON can point at the
// key and a reader of flags at the flag. fit_cascades() and all code that reads settings use it.
#pragma once

#include <optional>
#include <string>

#include "parameters/cascades.h"

namespace penumbra::parameters {

struct SettingProblem {
  std::string key;      // JSON pointer of the setting in a --config file: "/shadows/cascades"
  std::string problem;  // "is 5, outside 1 .. 4"
  std::string remedy;
};

std::optional<SettingProblem> find_problem(const Camera& camera, const Light& light,
                                           const ShadowSettings& settings);

}  // namespace penumbra::parameters
