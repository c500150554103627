#include "parameters/emit_constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "parameters/settings_input.h"

namespace penumbra::parameters {

namespace {

using Values = std::vector<double>;

Values row_major(const glm::dmat4& matrix) {
  Values values;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) values.push_back(matrix[column][row]);
  }
  return values;
}

Values four(const glm::dvec4& v) {
  return {v.x, v.y, v.z, v.w};
}

std::vector<float> floats(const Values& values) {
  std::vector<float> rounded;
  for (const double value : values) rounded.push_back(static_cast<float>(value));
  return rounded;
}

// The list has every value of a cascade once: JSON keys, source names and descriptions all come from it.
struct Figure {
  const char* key;
  const char* name;
  const char* meaning;
  int columns;
  std::function<Values(const Cascade&)> values;
};

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = {
      {"view", "View", "World to light view; looks down -Z.", 16,
       [](const Cascade& c) { return row_major(c.view); }},
      {"projection", "Projection", "Light view to clip, not reversed.", 16,
       [](const Cascade& c) { return row_major(c.projection); }},
      {"world_to_shadow", "WorldToShadow", "World to atlas UV (x, y) and stored depth (z).", 16,
       [](const Cascade& c) { return row_major(c.world_to_shadow); }},
      {"offset_scale", "OffsetScale", "The tile in atlas UV: x, y, width, height.", 4,
       [](const Cascade& c) { return four(c.offset_scale); }},
      {"split_sphere", "SplitSphere", "World centre and radius in metres.", 4,
       [](const Cascade& c) { return four(c.split_sphere); }},
      {"uv_per_metre", "UvPerMetre", "Tile UV per metre across the light.", 1,
       [](const Cascade& c) { return Values{c.uv_per_metre}; }},
      {"depth_per_metre", "DepthPerMetre", "Stored depth per metre along the light.", 1,
       [](const Cascade& c) { return Values{c.depth_per_metre}; }},
      {"depth_to_radial", "DepthToRadial", "Penumbra radius in tile UV per unit of stored depth gap.", 1,
       [](const Cascade& c) { return Values{c.depth_to_radial}; }},
      {"radial_to_depth", "RadialToDepth", "Its inverse; 0 at angular diameter 0, where there is none.", 1,
       [](const Cascade& c) { return Values{c.radial_to_depth.value_or(0.0)}; }},
      {"depth_to_radial_hdrp", "DepthToRadialHdrp",
       "HDRP's m00/m22 of the device projection: twice the geometric radius.", 1,
       [](const Cascade& c) { return Values{c.depth_to_radial_hdrp}; }},
      {"texel_size_metres", "TexelSizeMetres", "Side of a shadow-map texel in metres.", 1,
       [](const Cascade& c) { return Values{c.texel_size_metres}; }},
      {"max_penumbra_texels", "MaxPenumbraTexels", "Penumbra radius over the whole depth range, in texels.",
       1, [](const Cascade& c) { return Values{c.max_penumbra_texels}; }},
  };
  return list;
}

Values bias(const Cascade& cascade) {
  return {cascade.depth_bias_metres, cascade.normal_bias_metres};
}

// The largest difference of a printed float from its double, in the spacing of floats there. Tests compare
// the doubles with a second derivation in long double.
double worst_ulp(const Cascade& cascade) {
  double worst = 0.0;
  const auto compare = [&worst](const Values& values) {
    for (const double value : values) {
      const auto at = static_cast<float>(value);
      const float spacing = std::nextafter(std::abs(at), HUGE_VALF) - std::abs(at);
      worst = std::max(worst, std::abs(static_cast<double>(at) - value) / static_cast<double>(spacing));
    }
  };
  for (const Figure& figure : figures()) compare(figure.values(cascade));
  compare(bias(cascade));
  return worst;
}

std::string json_value(const Figure& figure, const Cascade& cascade) {
  if (std::string_view(figure.key) == "radial_to_depth" && !cascade.radial_to_depth) return "null";
  const std::vector<float> values = floats(figure.values(cascade));
  if (figure.columns == 1) return fmt::format("{}", values.front());
  return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string json_cascade(const Cascade& cascade) {
  std::string text = fmt::format("    {{\n      \"index\": {},\n", cascade.index);
  for (const Figure& figure : figures()) {
    text += fmt::format("      \"{}\": {},\n", figure.key, json_value(figure, cascade));
  }
  const std::vector<float> biases = floats(bias(cascade));
  text += fmt::format("      \"bias\": {{\"depth\": {}, \"normal\": {}}},\n", biases[0], biases[1]);
  return text + fmt::format("      \"ulp\": {:.4f}\n    }}", worst_ulp(cascade));
}

// A row of the table for people.
struct TableRow {
  const char* label;
  std::function<std::string(const Cascade&)> text;
};

std::string six_digits(double value) {
  return fmt::format("{:.6g}", value);
}

const std::vector<TableRow>& table_rows() {
  static const std::vector<TableRow> rows = {
      {"tile x, y",
       [](const Cascade& c) { return fmt::format("{:.4g}, {:.4g}", c.offset_scale.x, c.offset_scale.y); }},
      {"tile width, height",
       [](const Cascade& c) { return fmt::format("{:.4g}, {:.4g}", c.offset_scale.z, c.offset_scale.w); }},
      {"split sphere x (m)", [](const Cascade& c) { return six_digits(c.split_sphere.x); }},
      {"split sphere y (m)", [](const Cascade& c) { return six_digits(c.split_sphere.y); }},
      {"split sphere z (m)", [](const Cascade& c) { return six_digits(c.split_sphere.z); }},
      {"split sphere radius (m)", [](const Cascade& c) { return six_digits(c.split_sphere.w); }},
      {"depth range (m)", [](const Cascade& c) { return six_digits(1.0 / c.depth_per_metre); }},
      {"texel (m)", [](const Cascade& c) { return six_digits(c.texel_size_metres); }},
      {"uv per metre", [](const Cascade& c) { return six_digits(c.uv_per_metre); }},
      {"depth to radial", [](const Cascade& c) { return six_digits(c.depth_to_radial); }},
      {"radial to depth",
       [](const Cascade& c) {
         return c.radial_to_depth ? six_digits(*c.radial_to_depth) : std::string("none");
       }},
      {"depth to radial, HDRP", [](const Cascade& c) { return six_digits(c.depth_to_radial_hdrp); }},
      {"largest penumbra radius (texels)",
       [](const Cascade& c) { return six_digits(c.max_penumbra_texels); }},
      {"depth bias (m)", [](const Cascade& c) { return six_digits(c.depth_bias_metres); }},
      {"normal bias (m)", [](const Cascade& c) { return six_digits(c.normal_bias_metres); }},
  };
  return rows;
}

}  // namespace

std::string constants_table(const CascadeSet& set) {
  std::string text = fmt::format(
      "light {:.6g} {:.6g} {:.6g}, angular diameter {:.6g} degrees\natlas {} x {}, tiles of {}, {} Z, "
      "projections {}\ndepth range: {}\n\n{:<26}",
      set.light_direction.x, set.light_direction.y, set.light_direction.z, set.angular_diameter_degrees,
      set.atlas_width, set.atlas_height, set.tile_resolution, set.reversed_z ? "reversed" : "conventional",
      set.clip_depth == ClipDepth::zero_to_one ? "0 .. 1" : "-1 .. 1", set.depth_range_source, "cascade");
  for (const Cascade& cascade : set.cascades) text += fmt::format(" {:>14}", cascade.index);
  for (const TableRow& row : table_rows()) {
    text += fmt::format("\n{:<26}", row.label);
    for (const Cascade& cascade : set.cascades) text += fmt::format(" {:>14}", row.text(cascade));
  }
  text += fmt::format("\n{:<26}", "largest error (ULP)");
  for (const Cascade& cascade : set.cascades) text += fmt::format(" {:>14.4f}", worst_ulp(cascade));
  return text + "\n";
}

std::string constants_json(const CascadeSet& set) {
  std::string text = fmt::format(
      "{{\n  \"angular_diameter_degrees\": {},\n  \"matrix_order\": \"row-major\",\n  \"reversed_z\": {},\n"
      "  \"clip_depth\": \"{}\",\n  \"light_direction\": [{}, {}, {}],\n  \"atlas\": [{}, {}],\n"
      "  \"tile_resolution\": {},\n  \"depth_range_source\": \"{}\",\n  \"cascades\": [\n",
      set.angular_diameter_degrees, set.reversed_z, name_of(set.clip_depth), set.light_direction.x,
      set.light_direction.y, set.light_direction.z, set.atlas_width, set.atlas_height, set.tile_resolution,
      set.depth_range_source);
  for (std::size_t i = 0; i < set.cascades.size(); ++i) {
    text += json_cascade(set.cascades[i]) + (i + 1 < set.cascades.size() ? ",\n" : "\n");
  }
  return text + "  ]\n}\n";
}

std::string constants_source(const CascadeSet& set, Language language) {
  SourceFile file;
  file.name = "CascadeConstants";
  file.comment = {
      "Constants of the cascades of one directional light, for one camera and one frame.",
      "Written by `penumbra constants`. Lengths in metres, matrices row-major, one entry per cascade.",
      "",
      fmt::format("Angular diameter {} degrees, {} Z, projections {}.", set.angular_diameter_degrees,
                  set.reversed_z ? "reversed" : "conventional", name_of(set.clip_depth)),
      fmt::format("Atlas {} x {} texels, tiles of {}.", set.atlas_width, set.atlas_height,
                  set.tile_resolution),
      "Depth range: " + set.depth_range_source + "."};
  const auto add = [&](const char* name, const char* meaning, int columns, const auto& values_of) {
    FloatTable table{name, meaning, columns, {}};
    for (const Cascade& cascade : set.cascades) {
      const std::vector<float> values = floats(values_of(cascade));
      table.values.insert(table.values.end(), values.begin(), values.end());
    }
    file.tables.push_back(std::move(table));
  };
  for (const Figure& figure : figures()) add(figure.name, figure.meaning, figure.columns, figure.values);
  add("ShadowBias", "URP's _ShadowBias.xy: depth and normal bias in metres, both at most 0.", 2, bias);
  return source_text(file, language);
}

}  // namespace penumbra::parameters
