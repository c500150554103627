// Graphs of passes of the package's .shader, put together by hand.
#pragma once

#include <string>
#include <vector>

#include "platform/data_directory.h"
#include "resolve/compiled_graph.h"

namespace penumbra::resolve {

struct HandPass {
  std::string program;
  int divisor = 1;              // divisor of the screen's size
  bool reads_previous = false;  // the previous texture is read as _PenumbraSourceTexture
};

// Each pass draws into a texture of its own, "t0" the first; the last has the visibility. Resolve reads a
// mask, the number of a pass.
inline ShadowGraph hand_graph(const std::vector<HandPass>& passes, bool reversed_z = true,
                              std::vector<std::string> keywords = {}, int mask = -1) {
  ShadowGraph made;
  made.name = "by hand";
  made.package = platform::data_directory();
  made.reversed_z = reversed_z;
  made.keywords = std::move(keywords);
  const auto texture_of = [](std::size_t i) { return "t" + std::to_string(i); };
  for (std::size_t i = 0; i < passes.size(); ++i) {
    techniques::GraphTexture texture;
    texture.name = texture_of(i);
    texture.divisor = passes[i].divisor;
    made.graph.textures.push_back(texture);
    techniques::GraphPass pass;
    pass.name = pass.program = passes[i].program;
    pass.kind = techniques::PassKind::raster;
    pass.file = "Shaders/PenumbraShadows.shader";
    pass.writes = {{"", texture_of(i)}};
    const bool resolves = passes[i].program == "Resolve";
    if (passes[i].reads_previous)
      pass.reads.emplace_back("_PenumbraSourceTexture", texture_of(i - 1));
    else if (resolves)
      pass.absent.emplace_back("_PenumbraSourceTexture");
    if (mask >= 0 && resolves)
      pass.reads.emplace_back("_PenumbraMaskTexture", texture_of(static_cast<std::size_t>(mask)));
    else if (resolves)
      pass.absent.emplace_back("_PenumbraMaskTexture");
    made.graph.passes.push_back(pass);
  }
  made.graph.visibility = texture_of(passes.size() - 1);
  if (mask >= 0) made.graph.mask = texture_of(static_cast<std::size_t>(mask));
  return made;
}

}  // namespace penumbra::resolve
