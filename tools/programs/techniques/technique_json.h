// The techniques with all the defaults that their manifests leave out, for programs that compare with them.
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// {structs: [{name, fields: [{name, type}]}],
//  techniques: [{name, title, family, source, keywords, values: {field: number or numbers},
//                textures: [{name, extent, divisor, size, format, mips, layers, samples}],
//                passes: [{name, kind, runs, file, program, reads, writes, function}]}],
//  looks: [{name, title, doc, angularDiameterDegrees, maxPenumbraMetres}]}
// in the list's order; passes in the order in which they run.
std::string techniques_json(const TechniqueList& list);

}  // namespace penumbra::techniques
