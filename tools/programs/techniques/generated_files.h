// Every file that is made from manifests, at its place in the package.
#pragma once

#include <vector>

#include "techniques/emitted_file.h"
#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Of every list: each parameter struct as HLSL beside its manifest and as C#, and each manifest's graphs as
// C#. Of a package with the renderer feature's shader also the feature's tables, and what tests and pages
// read, where the package has a folder for it. Throws InputError as the functions that make the texts do.
std::vector<EmittedFile> generated_files(const TechniqueList& list);

// Throws InputError with the file and its line where the HLSL of a parameter struct was made of an earlier
// manifest: its fields would have one another's values. A file that does not exist, or that somebody wrote, is
// left alone.
void refuse_outdated_parameters(const TechniqueList& list);

}  // namespace penumbra::techniques
