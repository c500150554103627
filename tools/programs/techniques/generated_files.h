// Every file that is made from manifests, at its place in the package.
#pragma once

#include "shaders/package_shader.h"
#include "techniques/parameter_emit.h"
#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Every list gives each parameter struct as HLSL beside its manifest, the structs as C#, and the graphs as a
// table. A package with the renderer feature's shader gives the feature's tables, too, and what tests and
// pages read, where it has a folder for that. Throws InputError as the functions that make the texts do.
std::vector<EmittedFile> generated_files(const TechniqueList& list);

// Throws InputError with the file and its line where the HLSL of a parameter struct was made of an earlier
// manifest: its fields would have one another's values. A file that does not exist, or that somebody wrote,
// is left alone.
void refuse_outdated_parameters(const TechniqueList& list);

// The programs that each quality preset keeps of the renderer feature's shader in a player: its chain's
// passes, and the keywords that are on in each. A program is a vertex and a fragment stage of one pass with
// one keyword set, for one graphics API.
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
