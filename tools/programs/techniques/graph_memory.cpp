#include "techniques/graph_memory.h"

#include <fmt/format.h>

#include <cmath>

#include "input/input_error.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;
constexpr double kMostGraphBytes = 2048.0 * kMebibyte;

// The sizes at which extents count.
constexpr double kScreenPixels[] = {3840.0, 2160.0};
constexpr double kMapSide = 4096.0;  // along each side
constexpr double kTiles = 4.0;

// Counts the texels of the first mip level, with all layers.
double texels_of(const GraphTexture& texture) {
  const auto divided = [&texture](double width, double height) {
    return std::ceil(width / texture.divisor) * std::ceil(height / texture.divisor);
  };
  switch (texture.extent) {
    case ExtentOf::screen:
      return divided(kScreenPixels[0], kScreenPixels[1]) * texture.layers;
    case ExtentOf::map:
      return divided(kMapSide, kMapSide) * texture.layers;
    case ExtentOf::tile:
      return divided(kMapSide / 2.0, kMapSide / 2.0) * kTiles;
    case ExtentOf::fixed:
      break;
  }
  return 1.0 * texture.size[0] * texture.size[1] * texture.size[2] * texture.layers;
}

double bytes_of(const GraphTexture& texture) {
  const TexelFormat* format = find_texel_format(texture.format);
  const double mips = texture.mips == 1 ? 1.0 : 4.0 / 3.0;
  return texels_of(texture) * texture.samples * mips * (format == nullptr ? 16 : format->bytes);
}

double bytes_of(const PassGraph& graph, const GraphBuffer& buffer) {
  constexpr double kWord = 4.0;
  const GraphTexture* texture = graph.texture(buffer.texture);
  const double blocks = texture == nullptr ? 0.0 : texels_of(*texture) / buffer.divisor / buffer.divisor;
  return kWord * (buffer.words + buffer.words_per_texel * blocks);
}

}  // namespace

void check_memory(const PassGraph& graph) {
  double sum = 0.0;
  const auto add = [&sum](double bytes, const char* kind, const auto& item) {
    sum += bytes;
    if (sum <= kMostGraphBytes) return;
    throw InputError(
        item.where,
        fmt::format("{} '{}': with it, the graph's textures and buffers take {:.0f} MiB, more than the "
                    "{:.0f} MiB that a graph may (of a screen of {} x {} pixels and a map of {} x {})",
                    kind, item.name, sum / kMebibyte, kMostGraphBytes / kMebibyte, kScreenPixels[0],
                    kScreenPixels[1], kMapSide, kMapSide),
        "use fewer or smaller textures, a \"divisor\", or a format of fewer bytes");
  };
  for (const GraphTexture& texture : graph.textures) add(bytes_of(texture), "texture", texture);
  for (const GraphBuffer& buffer : graph.buffers) add(bytes_of(graph, buffer), "buffer", buffer);
}

}  // namespace penumbra::techniques
