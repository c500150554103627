#include "platform/content_hash.h"

#include <xxhash.h>

#include <array>
#include <new>

namespace penumbra::platform {

void ContentHash::Free::operator()(XXH3_state_s* state) const {
  XXH3_freeState(state);
}

ContentHash::ContentHash() : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  reset();
}

void ContentHash::reset() {
  XXH3_128bits_reset(state_.get());
}

ContentHash::~ContentHash() = default;
ContentHash::ContentHash(ContentHash&&) noexcept = default;
ContentHash& ContentHash::operator=(ContentHash&&) noexcept = default;

ContentHash& ContentHash::update(std::span<const std::byte> bytes) {
  update_integer(bytes.size());
  XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
  return *this;
}

ContentHash& ContentHash::update(std::string_view text) {
  return update(std::as_bytes(std::span(text)));
}

ContentHash& ContentHash::update(double number) {
  XXH3_128bits_update(state_.get(), &number, sizeof number);
  return *this;
}

ContentHash& ContentHash::update_integer(std::uint64_t number) {
  XXH3_128bits_update(state_.get(), &number, sizeof number);
  return *this;
}

std::string ContentHash::hex() const {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_.get()));
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text(2 * sizeof canonical.digest, '0');
  for (std::size_t i = 0; i < sizeof canonical.digest; ++i) {
    text[2 * i] = digits[canonical.digest[i] >> 4];
    text[2 * i + 1] = digits[canonical.digest[i] & 15];
  }
  return text;
}

}  // namespace penumbra::platform
