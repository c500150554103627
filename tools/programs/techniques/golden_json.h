#pragma once

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Values of every parameter struct and the vectors that they are packed into. The emitted C# is compared with
// them.
//
// Returns {struct: [{values: {field: number, numbers or "NaN"}, vectors: [[x, y, z, w]]}]}. Each struct has
// cases with the defaults, both ends of every range, values beyond them, NaN, and some between; the vectors
// hold what is kept of them. Every number is a float exactly.
std::string packing_cases_json(const TechniqueList& list);

// The techniques with all the defaults that their manifests leave out, for programs that compare with them.
//
// {structs: [{name, fields: [{name, type}]}],
//  techniques: [{name, title, family, source, keywords, values: {field: number or numbers},
//                textures: [{name, extent, divisor, size, format, mips, layers, samples}],
//                passes: [{name, kind, runs, file, program, reads, writes, function}]}],
//  looks: [{name, title, doc, angularDiameterDegrees, maxPenumbraMetres}]}
// in the list's order; passes in the order in which they run.
std::string techniques_json(const TechniqueList& list);

}  // namespace penumbra::techniques
