#include "platform/content_hash.h"

#include <blake2.h>

#include <array>

namespace penumbra::platform {
namespace {

constexpr std::string_view kDigits = "0123456789abcdef";

}  // namespace

struct ContentHash::State {
  blake2b_state blake;

  void update(const void* bytes, std::size_t size) {
    blake2b_update(&blake, static_cast<const std::uint8_t*>(bytes), size);
  }
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) {
  reset();
}

void ContentHash::reset() {
  blake2b_init(&state_->blake, content_hash_digits / 2);
}

ContentHash::~ContentHash() = default;
ContentHash::ContentHash(ContentHash&&) noexcept = default;
ContentHash& ContentHash::operator=(ContentHash&&) noexcept = default;

ContentHash& ContentHash::update(std::span<const std::byte> bytes) {
  update_integer(bytes.size());
  state_->update(bytes.data(), bytes.size());
  return *this;
}

ContentHash& ContentHash::update(std::string_view text) {
  return update(std::as_bytes(std::span(text)));
}

ContentHash& ContentHash::update(double number) {
  state_->update(&number, sizeof number);
  return *this;
}

ContentHash& ContentHash::update_integer(std::uint64_t number) {
  state_->update(&number, sizeof number);
  return *this;
}

std::string ContentHash::hex() const {
  State end = *state_;
  std::array<std::uint8_t, content_hash_digits / 2> digest{};
  blake2b_final(&end.blake, digest.data(), digest.size());
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

bool is_content_hash(std::string_view text) {
  return text.size() == content_hash_digits && text.find_first_not_of(kDigits) == std::string_view::npos;
}

}  // namespace penumbra::platform
