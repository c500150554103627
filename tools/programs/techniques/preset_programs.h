// What each quality preset keeps of the renderer feature's shader in a player: its chain's passes, and the
// keywords that are on in each. A program is a vertex and a fragment stage of one pass with one keyword set,
// for one graphics API.
#pragma once

#include <string>
#include <vector>

#include "shaders/package_shader.h"
#include "techniques/technique_list.h"

namespace penumbra::techniques {

struct PresetProgram {
  std::string pass;
  std::vector<std::string> keywords;

  bool operator==(const PresetProgram& other) const = default;
};

// In the order they are drawn, and then those of what the preset falls back to.
std::vector<PresetProgram> programs_of(const TechniqueList& list, const Technique& preset,
                                       const shaders::PackageShader& shader);

// {shader, programs: how many it has unstripped, presets: [{name, title, programs: [{pass, keywords}]}]}, of
// the presets in the list's order.
std::string preset_programs_json(const TechniqueList& list, const shaders::PackageShader& shader);

}  // namespace penumbra::techniques
