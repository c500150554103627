// A check that the stages of a program fit: each is compiled alone, so no compiler compares them.
//
// It is based on the rules of Direct3D 11's runtime for signatures (D3D11.3 functional specification, 5.4
// "Linkage between stages"): a stage reads only semantics that the stage before it writes, of the same type
// and with no more components, and the last stage before the rasteriser writes SV_Position. It does not check
// that the registers of both signatures are the same.
#pragma once

#include <vector>

#include "validation/engine.h"

namespace penumbra::validation {

// Adds an error to the results of variants that do not fit a variant of the stage before it, for every
// combination of keywords that exists at run time. `results` are those of the units of engine.shard; what the
// comparison needs from other shards is compiled as well. Throws like run_units().
void link_stages(const std::vector<CompileUnit>& units, const EngineOptions& engine,
                 std::vector<UnitResult>& results);

}  // namespace penumbra::validation
