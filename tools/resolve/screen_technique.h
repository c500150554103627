// From a technique of the manifests to the passes, keywords and uniforms with which the renderer feature runs
// it.
#pragma once

#include "resolve/screen_chain.h"
#include "techniques/technique_list.h"

namespace penumbra::resolve {

// The values of a technique as Shadows.hlsl reads them: _PenumbraSamples, _PenumbraLimits, _PenumbraHdrp.
UniformValues shadows_uniforms(const techniques::Technique& technique);

// The passes of a technique that runs over the screen.
ScreenChainDescription screen_chain(const techniques::Technique& technique);

}  // namespace penumbra::resolve
