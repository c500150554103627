// Normals for vertices whose file has none, as Unity's model importer derives them: faces that meet at an
// angle below 60 degrees are smoothed into each other, weighted by their angle at the vertex (Thuermer and
// Wuethrich 1998), so that the cut of a polygon into triangles does not show; sharper edges stay sharp.
#pragma once

#include "scene/model_file.h"

namespace penumbra::scene {

// Fills every zero normal of a corner. Vertices that need one are split, one for each corner that uses them.
// No triangle may be without area. Normals point where counter-clockwise winding says outside is.
void add_missing_normals(ModelFile& model);

}  // namespace penumbra::scene
