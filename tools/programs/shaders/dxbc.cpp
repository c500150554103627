#include "shaders/dxbc.h"

#include <stdexcept>

namespace penumbra::shaders {

void DxbcPart::require(std::size_t offset, std::size_t count) const {
  if (offset > bytes_.size() || count > bytes_.size() - offset)
    throw std::invalid_argument("bytecode that ends too early");
}

std::uint32_t DxbcPart::byte(std::size_t offset) const {
  require(offset, 1);
  return static_cast<unsigned char>(bytes_[offset]);
}

std::uint32_t DxbcPart::half(std::size_t offset) const {
  require(offset, 2);
  return byte(offset) | byte(offset + 1) << 8U;
}

std::uint32_t DxbcPart::word(std::size_t offset) const {
  require(offset, 4);
  return half(offset) | half(offset + 2) << 16U;
}

std::string DxbcPart::text(std::size_t offset) const {
  require(offset, 1);
  const std::size_t end = bytes_.find('\0', offset);
  if (end == std::string_view::npos) throw std::invalid_argument("bytecode with a name that does not end");
  return std::string(bytes_.substr(offset, end - offset));
}

DxbcPart dxbc_part(std::string_view container, std::string_view name) {
  constexpr std::size_t kSize = 24;  // behind the letters, a checksum and a version
  constexpr std::size_t kCount = 28;
  const DxbcPart all(container);
  if (!container.starts_with("DXBC") || all.word(kSize) != container.size())
    throw std::invalid_argument("the bytes are no whole DXBC container");
  const std::uint32_t parts = all.word(kCount);
  for (std::uint32_t i = 0; i < parts; ++i) {
    const std::size_t at = all.word(kCount + 4 + std::size_t{4} * i);
    const std::size_t size = all.word(at + 4);
    if (size > container.size() - at - 8) throw std::invalid_argument("bytecode that ends too early");
    if (container.substr(at, 4) == name) return DxbcPart(container.substr(at + 8, size));
  }
  throw std::invalid_argument("the bytecode has no part '" + std::string(name) + "'");
}

}  // namespace penumbra::shaders
