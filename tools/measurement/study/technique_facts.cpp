#include "study/technique_facts.h"

#include <algorithm>
#include <array>

#include "gpu/format.h"
#include "resolve/graph_resources.h"

namespace penumbra::study {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;

// The atlas as URP lays it out: one tile, two beside each other, or four in a square.
resolve::GraphExtents extents_of(const Record& record) {
  resolve::GraphExtents extents;
  extents.map.width = record.map_size;
  extents.map.tile = record.cascades == 1 ? record.map_size : record.map_size / 2;
  extents.map.height = record.cascades == 2 ? extents.map.tile : record.map_size;
  extents.map.origins.resize(static_cast<std::size_t>(record.cascades));
  return extents;
}

double bytes_of(const techniques::GraphTexture& texture, const resolve::GraphExtents& extents) {
  const std::array<int, 3> size = resolve::texture_size_of(texture, extents);
  const int most = gpu::mip_count(size[0], size[1], size[2]);
  const int mips = texture.mips == 0 ? most : std::min(texture.mips, most);
  double texels = 0.0;
  for (int mip = 0; mip < mips; ++mip)
    texels += static_cast<double>(gpu::mip_size(size[0], mip)) * gpu::mip_size(size[1], mip) *
              gpu::mip_size(size[2], mip);
  const std::size_t layers = texture.extent == techniques::ExtentOf::tile
                                 ? extents.map.origins.size()
                                 : static_cast<std::size_t>(texture.layers);
  return texels * static_cast<double>(layers) * texture.samples *
         static_cast<double>(gpu::texel_bytes(gpu::find_format(texture.format).value()));
}

}  // namespace

FactsOfTechniques facts_of(const techniques::TechniqueList& list) {
  FactsOfTechniques facts;
  for (const techniques::Technique& technique : list.techniques)
    facts[technique.name] = {technique.use_when, technique.not_when, technique.graph.textures,
                             !technique.graph.draws(techniques::DrawnCasters::volumes)};
  return facts;
}

double map_mebibytes(const Record& record, const std::vector<techniques::GraphTexture>& textures) {
  const resolve::GraphExtents extents = extents_of(record);
  double bytes =
      static_cast<double>(extents.map.width) * extents.map.height * (record.map_format == "D16" ? 2.0 : 4.0);
  for (const techniques::GraphTexture& texture : textures) {
    if (texture.extent != techniques::ExtentOf::screen && texture.previous_of.empty())
      bytes += bytes_of(texture, extents);
  }
  return bytes / kMebibyte + record.baked_mebibytes.value_or(0.0);
}

bool has_advice(const std::vector<TechniqueRow>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const TechniqueRow& row) { return !row.use_when.empty() || !row.not_when.empty(); });
}

std::string rows_explained(const std::vector<TechniqueRow>& rows) {
  const bool baked = std::any_of(rows.begin(), rows.end(), [](const TechniqueRow& row) { return row.baked; });
  std::string text =
      baked
          ? "Maps: the shadow map, the textures that are made of it and those that are baked from the scene, "
            "without those of the picture's size."
          : "Maps: the shadow map and the textures that are made of it, without those of the "
            "picture's size.";
  if (has_advice(rows))
    text += " When to use it: the library's advice, from its own measurements and not from the figures here.";
  return text;
}

double middle_light(const Results& results) {
  const std::vector<double> lights = light_sizes(results);
  return lights[lights.size() / 2];
}

std::vector<TechniqueRow> technique_rows(const Results& results, const FactsOfTechniques& facts) {
  std::vector<TechniqueRow> rows;
  if (facts.empty()) return rows;
  const std::vector<double> lights = light_sizes(results);
  const std::vector<SummaryLine> lines = summarise(results);
  for (const Choice& choice : choices(results)) {
    TechniqueRow row;
    row.choice = choice;
    row.rmse_penumbra.resize(lights.size());
    for (const SummaryLine& line : lines) {
      if (line.choice != choice) continue;
      const auto light = std::find(lights.begin(), lights.end(), line.light_degrees) - lights.begin();
      row.rmse_penumbra[static_cast<std::size_t>(light)] = line.rmse_penumbra;
      if (line.light_degrees == middle_light(results)) row.fetches = line.fetches;
    }
    const auto known = facts.find(choice.technique);
    const TechniqueFacts fact = known == facts.end() ? TechniqueFacts{} : known->second;
    const auto record = std::find_if(results.records.begin(), results.records.end(), [&](const Record& each) {
      return each.technique == choice.technique && choice_of(results, each) == choice;
    });
    row.map_mebibytes = map_mebibytes(*record, fact.textures);
    row.baked = record->baked_mebibytes.has_value();
    if (!fact.has_shadow_map) row.map_mebibytes -= map_mebibytes(*record, {});
    row.use_when = fact.use_when;
    row.not_when = fact.not_when;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace penumbra::study
