// A technique's filter as one HLSL file, for those who copy it into an engine of their own.
#pragma once

#include "techniques/technique_list.h"

namespace penumbra::techniques {

struct SingleFile {
  std::string text;
  std::vector<std::filesystem::path> pasted;  // every file that the text was made of
};

// The text of technique_call.h with each include pasted once, before the file that includes it; includes of
// other packages stay. A file's guard is defined and not asked, so that an include of the library after the
// text adds nothing twice. The comment at the head says what to call and to bind, and the licences. `version`
// is the program's. Throws InputError for a technique that draws its visibility by passes over the screen,
// and where an #include cannot be pasted.
SingleFile single_file(const TechniqueList& list, const Technique& technique, const std::string& version);

}  // namespace penumbra::techniques
