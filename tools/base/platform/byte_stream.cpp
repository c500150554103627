#include "platform/byte_stream.h"

namespace penumbra::platform {

// Each byte has seven bits, the lowest first; all but the last byte have the eighth bit set.
void ByteWriter::number(std::uint64_t value) {
  for (; value >= 0x80; value >>= 7U) bytes_ += static_cast<char>(value | 0x80U);
  bytes_ += static_cast<char>(value);
}

void ByteWriter::text(std::string_view value) {
  number(value.size());
  bytes_ += value;
}

std::uint64_t ByteReader::number() {
  std::uint64_t value = 0;
  for (unsigned shift = 0; whole_ && !rest_.empty() && shift < 64; shift += 7) {
    const auto byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
    if (byte < 0x80) return value;
  }
  whole_ = false;
  return 0;
}

bool ByteReader::flag() {
  const std::uint64_t value = number();
  if (value > 1) spoil();
  return value == 1;
}

std::string ByteReader::text() {
  const std::uint64_t length = number();
  if (!whole_ || length > rest_.size()) {
    whole_ = false;
    return {};
  }
  std::string value(rest_.substr(0, length));
  rest_.remove_prefix(length);
  return value;
}

}  // namespace penumbra::platform
