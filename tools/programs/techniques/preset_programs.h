// The programs that each quality preset keeps of the renderer feature's shader in a player: its chain's
// passes, and the keywords that are on in each. A program is a vertex and a fragment stage of one pass with
// one keyword set, for one graphics API.
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

// Returns the programs in the order in which they are drawn, and then those of the preset's fallback.
std::vector<PresetProgram> programs_of(const TechniqueList& list, const Technique& preset,
                                       const shaders::PackageShader& shader);

// Returns {shader, programs: how many it has unstripped, presets: [{name, title, programs: [{pass,
// keywords}]}]}, with the presets in the list's order.
std::string preset_programs_json(const TechniqueList& list, const shaders::PackageShader& shader);

}  // namespace penumbra::techniques
