// Checks the walls of the project over its text. Each rule takes a tree (path from the repository's root,
// with '/', to the file's text) and returns what breaks it, as "path:line: why".
#pragma once

#include <map>
#include <string>
#include <vector>

namespace penumbra::architecture {

using Tree = std::map<std::string, std::string>;
using Violations = std::vector<std::string>;

// In tools/, an include of another room goes down this list: cli, measurement (study, lighting, bake,
// reference, resolve, scene), checking (cost, validation, lint), programs (gpu, techniques, shaders,
// preparation, variants, shaderlab, project, fxc, preprocessing, hlsl, spirv), base (parameters, platform,
// input). Measurement and checking know nothing of each other, and checking and programs nothing of
// parameters. Every room stands in its group's folder.
Violations tool_includes_point_down(const Tree& tree);

// The rule of includes also holds for the rooms that a room's CMakeLists.txt names: after USES, or as
// penumbra::NAME.
Violations tool_links_point_down(const Tree& tree);

// Includes of shaders go down this list: Shaders, the umbrella beside the folders, Pipelines, then Filters,
// Screen and Far (which know each other as little as they know the pipelines), Core, Platform.
Violations shader_includes_point_down(const Tree& tree);

// Headers of an operating system stand in tools/base/platform alone.
Violations system_headers_stay_in_platform(const Tree& tree);

// A header that other rooms include brings no large third-party header with it, directly or through others.
// tools/base/input/located_json.h is the exception: JSON is what it offers; and the headers of
// tools/programs/spirv, for SPIR-V's enumerations, as long as no other room's header brings them further.
Violations public_headers_stay_light(const Tree& tree);

// Nothing is left unfinished: no word that marks work to be done.
Violations nothing_is_unfinished(const Tree& tree);

// No file names a path of the machine it was written on, or a host it was downloaded from.
Violations nothing_names_a_machine(const Tree& tree);

}  // namespace penumbra::architecture
