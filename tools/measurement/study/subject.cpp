#include "input/input_error.h"
#include "parameters/settings_input.h"
#include "study/study.h"

namespace penumbra::study {

Subject technique_subject(const techniques::TechniqueList& list, const techniques::Technique& technique,
                          bool reversed_z, techniques::LightKind light) {
  if (!technique.is_for(light)) {
    const bool spot = light == techniques::LightKind::spot;
    throw InputError(
        "", "the technique '" + technique.name + "' is not for " + (spot ? "spot lights" : "the sun"),
        spot ? "choose others, or scenes that the sun lights" : "choose others, or scenes with a spot light");
  }
  Subject subject;
  subject.light = light;
  subject.name = technique.name;
  subject.title = technique.title;
  subject.parameters = technique.values;
  subject.cascades = technique.cascades;
  subject.bias = {technique.bias.depth, technique.bias.normal,
                  parameters::soft_quality_named(technique.bias.soft_quality)};
  subject.raster_bias.slope = technique.bias.slope;
  subject.graph = resolve::technique_graph(list, technique, resolve::Taps::as_listed, reversed_z, light);
  if (technique.is_sampled()) {
    subject.unlimited =
        resolve::technique_graph(list, technique, resolve::Taps::unlimited, reversed_z, light);
  }
  return subject;
}

Subject adapter_subject(const resolve::Adapter& adapter, bool reversed_z) {
  Subject subject;
  subject.name = adapter.name;
  subject.title = adapter.name + " (" + adapter.file.filename().string() + ")";
  subject.bias = adapter.bias;
  subject.light_scale = adapter.light_scale;
  subject.graph = resolve::adapter_graph(adapter, reversed_z);
  return subject;
}

}  // namespace penumbra::study
