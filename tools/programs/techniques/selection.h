// The choices of a project: the techniques that shader keywords select, and the options of the renderer
// feature.
#pragma once

#include "techniques/parameter_packing.h"
#include "techniques/pass_graph.h"

namespace penumbra::techniques {

// An option of the renderer feature: a field of ShadowOptions in C#, or an entry that inspectors show beside
// these.
struct FeatureOption {
  std::string name;
  std::string type;  // int, float, bool or enum
  std::string label;
  std::string tooltip;
  std::optional<ParameterRange> range;  // range of numbers
};

// A filter that a keyword selects in shaders, and, with a value, the renderer feature offers; or passes that
// the renderer feature alone draws, in place of its own over the screen.
struct Selection {
  std::string name;               // name in C#
  std::string keyword;            // empty if it is selected without a keyword; for passes, their fallback's
  std::string technique;          // the technique that has the filter: alone, or at the end of a graph
  bool draws_visibility = false;  // the technique's graph ends in a texture, and shaders have no filter
  std::string technique_16_bits;  // the same filter over maps of 16 bits a channel; may be empty
  std::string technique_half_resolution;  // the same passes for every second pixel; may be empty
  FilterCall filter;                      // filter of that technique
  std::vector<GraphTexture> textures;     // textures of its graph that the filter reads
  bool is_sampled = false;                // a filter of which Technique::is_sampled() is true
  bool widens_with_disc = false;          // penumbrae are as wide as the light's disc makes them
  // These structs are set by the feature's C#; values and options set others.
  std::vector<std::string> computed_parameters;
  bool needs_target_45 = false;  // needs Unity's shader target 4.5: it gathers, or searches for bits
  std::string fallback;  // selection in its place where its passes and filter cannot run; may be empty
  // Assets serialise the value, so it is never changed; if it is absent, only shaders select the technique.
  std::optional<int> value;
  std::string title;  // title in inspectors; this and the next are for selections with a value
  std::string doc;
  std::map<std::string, std::string> options;  // option -> field of the parameters that it sets
  std::string where;                           // file:line:column

  bool reads_raw_depth() const;  // the filter reads the shadow map through the point sampler
};

// A quality preset that draws passes of a selection, and its fallback for devices that cannot run them. Both
// have the same options.
struct PresetChoice {
  std::string preset;     // a technique, preset-high for example
  std::string fallback;   // a technique, by the filter of the selection's fallback
  std::string selection;  // the selection that has the preset's passes
};

}  // namespace penumbra::techniques
