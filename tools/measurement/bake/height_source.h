// Where height fields come from: a scene's geometry, and images of heights.
#pragma once

#include "bake/block_run.h"
#include "bake/height_field.h"
#include "scene/height_image.h"
#include "scene/scene.h"

namespace penumbra::bake {

struct SampleCounts {
  int width = 513;  // along x
  int depth = 513;  // along z
};

// The scene with its ground alone (Scene::ground_triangles).
scene::Scene ground_of(const scene::Scene& scene);

// The rectangle of the map that the scene's mesh covers.
Area area_of(const scene::Scene& scene);

// Samples at the same distance along both sides of the area, `longest` along the longer one; at least two.
SampleCounts even_counts(const Area& area, int longest);

// The highest surface at each sample, which overhangs and roofs make solid down to the ground; where there is
// none, the height of the scene's lowest vertex, counted in HeightField::holes. Throws InputError for counts
// or an area that check_height_field() refuses, and where the area has no surface at all; as run_bake.
HeightField heights_of_scene(const scene::Scene& scene, const Area& area, const SampleCounts& counts,
                             const BakeOptions& run = {});

// What an image's numbers mean: metres of 0 and of 65535.
struct HeightRange {
  double low = 0.0;
  double high = 0.0;
};

// The image's first row, a picture's lowest, is at the smallest z, or with from_largest_z at the largest.
// Throws InputError for a range that is empty or exceeds most_ground_metres, and as check_height_field().
HeightField heights_of_image(const scene::HeightImage& image, const Area& area, const HeightRange& range,
                             bool from_largest_z = false);

}  // namespace penumbra::bake
