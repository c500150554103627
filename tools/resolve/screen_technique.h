// From a technique of the manifests to the passes, keywords and uniforms with which the renderer feature runs
// it.
#pragma once

#include "resolve/screen_chain.h"
#include "techniques/technique_list.h"

namespace penumbra::resolve {

// The passes of a technique that runs over the screen.
ScreenChainDescription screen_chain(const techniques::TechniqueList& list,
                                    const techniques::Technique& technique);

}  // namespace penumbra::resolve
