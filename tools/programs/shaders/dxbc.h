// A DXBC container: what FXC makes of a program. Its parts are found by four letters: the code ("SHEX"), the
// resources by name ("RDEF"), the inputs and outputs by semantic ("ISGN", "OSGN").
//
// Microsoft publishes the layout as the structures of d3d11shader.h and d3d11TokenizedProgramFormat.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace penumbra::shaders {

// A part's bytes, which may come from anywhere: every read beyond them throws std::invalid_argument.
class DxbcPart {
 public:
  explicit DxbcPart(std::string_view bytes) : bytes_(bytes) {}

  std::size_t size() const { return bytes_.size(); }
  std::uint32_t word(std::size_t offset) const;  // little endian
  std::uint32_t half(std::size_t offset) const;  // 16 bits
  std::uint32_t byte(std::size_t offset) const;
  std::string text(std::size_t offset) const;  // up to the NUL that ends it

 private:
  void require(std::size_t offset, std::size_t count) const;

  std::string_view bytes_;
};

// Throws std::invalid_argument when the bytes are no container or have no such part. The part refers to the
// container's bytes.
DxbcPart dxbc_part(std::string_view container, std::string_view name);

}  // namespace penumbra::shaders
