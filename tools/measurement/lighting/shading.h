// The light that a surface reflects to the camera.
//
// Lambertian diffuse reflection, and a specular term by GGX (B. Walter et al., "Microfacet Models for
// Refraction through Rough Surfaces", EGSR 2007) with the joint Smith term and Schlick's Fresnel term at the
// 4 % of common materials; the energy of the specular term is subtracted from the diffuse one. The sky's
// specular reflection is B. Karis' fit ("Physically Based Shading on Mobile", 2014) times the sky light
// around. Where the triangle turns from the sun before its interpolated normal does, light fades by M. Chiang
// et al., "Taming the Shadow Terminator" (SIGGRAPH 2019). A translucent surface transmits its share of the
// light from behind diffusely. Spaces: all directions unit and away from the surface. Reentrant.
#pragma once

#include <glm/vec3.hpp>

#include "lighting/seen_materials.h"

namespace penumbra::lighting {

struct Sunlight {
  glm::vec3 to_sun;
  glm::vec3 irradiance;  // irradiance of a surface that faces the sun
};

// Returns the radiance per unit of the sun's visibility: the part that shadows take away. It is 0 on faces
// turned from the sun.
glm::vec3 lit_by_sun(const SurfacePoint& point, const glm::vec3& to_camera, const Sunlight& sun);

// Returns the same for light that comes through from behind. It is 0 on faces that the sun shines upon.
glm::vec3 lit_through(const SurfacePoint& point, const Sunlight& sun);

// sky_light has the meaning that sky_light.h gives it.
glm::vec3 lit_by_sky(const SurfacePoint& point, const glm::vec3& to_camera, const glm::vec3& sky_light);

}  // namespace penumbra::lighting
