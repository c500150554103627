// The surfaces that built-in scenes are made of. Colours are linear Rec. 709 reflectances of such materials
// in daylight, estimated and not measured.
#pragma once

#include "scene/material.h"

namespace penumbra::scene::surfaces {

Material concrete();
Material asphalt();
Material lawn();
Material earth();
Material sandstone();
Material marble();
Material plaster(int tint);  // cream, ochre, rose, pale blue, white, by tint modulo 5
Material terracotta();
Material roof_tile();
Material wood();
Material bark();
Material leaf(int tint);  // four greens, by tint modulo 4
Material galvanised_steel();
Material painted_iron();
Material cloth(int tint);  // red, white, green, navy, by tint modulo 4
Material dark_glass();
Material rubber();
Material car_paint(int tint);     // red, grey, blue, white, by tint modulo 4
Material painted_wood(int tint);  // blue, yellow, red, white, green, orange, by tint modulo 6

}  // namespace penumbra::scene::surfaces
