#include "parameters/golden_settings.h"

namespace penumbra::parameters {

namespace {

std::vector<SoftShadowParameters> awkward_settings() {
  SoftShadowParameters point;
  point.angular_diameter_degrees = 0;
  point.hdrp_search_degrees = 0;
  point.hdrp_min_filter_degrees = 0;
  const SoftShadowParameters low{.angular_diameter_degrees = -5,
                                 .blocker_samples = -3,
                                 .filter_samples = 0,
                                 .blocker_clump = -1,
                                 .min_filter_texels = -2,
                                 .max_penumbra_metres = -1,
                                 .max_sampling_metres = -1,
                                 .search_radius_metres = -1,
                                 .hdrp_search_degrees = -1,
                                 .hdrp_min_filter_degrees = -1};
  const SoftShadowParameters high{.angular_diameter_degrees = 31,
                                  .blocker_samples = 1000,
                                  .filter_samples = 1000,
                                  .blocker_clump = 9,
                                  .min_filter_texels = 65,
                                  .max_penumbra_metres = 1e7,
                                  .max_sampling_metres = 1e7,
                                  .search_radius_metres = 1e7,
                                  .hdrp_search_degrees = 120,
                                  .hdrp_min_filter_degrees = 180};
  SoftShadowParameters narrow_search;
  narrow_search.angular_diameter_degrees = 20;
  SoftShadowParameters wide_filter;
  wide_filter.hdrp_min_filter_degrees = 25;
  return {SoftShadowParameters{}, point, low, high, narrow_search, wide_filter};
}

}  // namespace

double as_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

SoftShadowParameters as_floats(SoftShadowParameters parameters) {
  for (double SoftShadowParameters::*field :
       {&SoftShadowParameters::angular_diameter_degrees, &SoftShadowParameters::blocker_clump,
        &SoftShadowParameters::min_filter_texels, &SoftShadowParameters::max_penumbra_metres,
        &SoftShadowParameters::max_sampling_metres, &SoftShadowParameters::search_radius_metres,
        &SoftShadowParameters::hdrp_search_degrees, &SoftShadowParameters::hdrp_min_filter_degrees}) {
    parameters.*field = as_float(parameters.*field);
  }
  return parameters;
}

SoftShadowParameters random_settings(SetupGenerator& generator) {
  const auto up_to = [&](double high) { return as_float(generator.uniform(0, high)); };
  SoftShadowParameters parameters;
  parameters.angular_diameter_degrees = up_to(30);
  parameters.blocker_samples = generator.integer(1, 128);
  parameters.filter_samples = generator.integer(1, 64);
  parameters.blocker_clump = up_to(8);
  parameters.min_filter_texels = up_to(64);
  parameters.max_penumbra_metres = up_to(100);
  parameters.max_sampling_metres = up_to(1000);
  parameters.search_radius_metres = up_to(10);
  parameters.hdrp_search_degrees = up_to(40);
  parameters.hdrp_min_filter_degrees = up_to(40);
  return parameters;
}

std::vector<SoftShadowParameters> golden_settings(int random, SetupGenerator& generator) {
  std::vector<SoftShadowParameters> list;
  for (const SoftShadowParameters& awkward : awkward_settings()) list.push_back(as_floats(awkward));
  for (int i = 0; i < random; ++i) list.push_back(random_settings(generator));
  return list;
}

}  // namespace penumbra::parameters
