// The sources of height fields: a scene's geometry, and images of heights.
#pragma once

#include "bake/block_run.h"
#include "bake/height_field.h"
#include "scene/image_file.h"
#include "scene/scene.h"

namespace penumbra::bake {

struct SampleCounts {
  int width = 513;  // along x
  int depth = 513;  // along z
};

// Returns the scene with its ground alone (Scene::ground_triangles).
scene::Scene ground_of(const scene::Scene& scene);

// Returns the rectangle of the map that the scene's mesh covers.
Area area_of(const scene::Scene& scene);

// Returns counts that put samples at the same distance along both sides of the area, `longest` of them along
// the longer side and at least two along the other.
SampleCounts even_counts(const Area& area, int longest);

// Returns the highest surface at each sample; overhangs and roofs so become solid down to the ground. A
// sample without a surface gets the height of the scene's lowest vertex and is counted in HeightField::holes.
// Throws InputError for counts or an area that check_height_field() refuses, and where the area has no
// surface at all; also throws as run_bake().
HeightField heights_of_scene(const scene::Scene& scene, const Area& area, const SampleCounts& counts,
                             const BakeOptions& run = {});

// The meaning of an image's numbers: the metres that 0 and 65535 stand for.
struct HeightRange {
  double low = 0.0;
  double high = 0.0;
};

// The image's first row, a picture's lowest, is at the smallest z, or with from_largest_z at the largest.
// Throws InputError for a range that is empty or exceeds most_ground_metres, and as check_height_field().
HeightField heights_of_image(const scene::HeightImage& image, const Area& area, const HeightRange& range,
                             bool from_largest_z = false);

}  // namespace penumbra::bake
