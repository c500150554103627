// A content hash: a key under which a result is cached.
//
// It is BLAKE2b with 256 bits (RFC 7693): the author of a file cannot make it hash like another. Numbers are
// hashed by their bits (0.0 and -0.0 differ), and everything of varying length is preceded by its length, so
// {"ab", "c"} and {"a", "bc"} differ. Hashes are equal across machines of the same byte order.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace penumbra::platform {

inline constexpr std::size_t content_hash_digits = 64;  // hexadecimal

class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(ContentHash&&) noexcept;
  ContentHash& operator=(ContentHash&&) noexcept;

  ContentHash& update(std::span<const std::byte> bytes);
  ContentHash& update(std::string_view text);
  ContentHash& update(double number);
  // Integers of every width and bool hash as the same 64 bits, so a field may be widened without changing
  // hashes.
  template <std::integral Integer>
  ContentHash& update(Integer number) {
    return update_integer(static_cast<std::uint64_t>(number));
  }
  // Elements must have no padding bytes.
  template <typename Element>
  ContentHash& update(std::span<const Element> elements) {
    return update(std::as_bytes(elements));
  }

  // Resets to the initial state.
  void reset();

  std::string hex() const;  // content_hash_digits, lower-case; more may be added after

 private:
  struct State;

  ContentHash& update_integer(std::uint64_t number);

  std::unique_ptr<State> state_;
};

// Returns whether the text is the hex() of some hash.
bool is_content_hash(std::string_view text);

}  // namespace penumbra::platform
