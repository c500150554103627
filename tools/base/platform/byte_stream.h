// Binary serialisation, for messages to workers and for cache entries. A reader of truncated or damaged bytes
// returns empty values and reports it at the end; it never reads out of bounds, and never allocates more than
// the bytes could hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace penumbra::platform {

class ByteWriter {
 public:
  void number(std::uint64_t value);
  void text(std::string_view value);  // its length, then its bytes

  // Numbers, and structs of numbers, are stored in their memory representation: both ends are the same
  // program on one machine.
  template <typename Value>
  void values(std::span<const Value> list) {
    static_assert(std::is_trivially_copyable_v<Value>);
    number(list.size());
    bytes_.append(reinterpret_cast<const char*>(list.data()), list.size_bytes());
  }
  template <typename Value>
  void values(const std::vector<Value>& list) {
    values(std::span<const Value>(list));
  }
  template <typename Value>
  void value(const Value& single) {
    values(std::span<const Value>(&single, 1));
  }

  template <typename Elements, typename Write>
  void list(const Elements& elements, const Write& write) {
    number(elements.size());
    for (const auto& element : elements) write(element);
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number();
  bool flag();  // 0 or 1
  std::string text();

  template <typename Value>
  std::vector<Value> values() {
    static_assert(std::is_trivially_copyable_v<Value>);
    const std::uint64_t count = number();
    if (!whole_ || count > rest_.size() / sizeof(Value)) {
      whole_ = false;
      return {};
    }
    std::vector<Value> list(count);
    if (count > 0) std::memcpy(list.data(), rest_.data(), count * sizeof(Value));
    rest_.remove_prefix(count * sizeof(Value));
    return list;
  }
  template <typename Value>
  Value value() {
    const std::vector<Value> single = values<Value>();
    if (single.size() == 1) return single.front();
    whole_ = false;
    return Value{};
  }

  // The value is 0 to `last`.
  template <typename Enumeration>
  Enumeration enumerator(Enumeration last) {
    const std::uint64_t value = number();
    if (value <= static_cast<std::uint64_t>(last)) return static_cast<Enumeration>(value);
    whole_ = false;
    return last;
  }

  template <typename Element, typename Read>
  std::vector<Element> list(const Read& read) {
    const std::uint64_t count = number();
    std::vector<Element> elements;
    if (count > rest_.size()) whole_ = false;  // every element takes a byte at least
    for (std::uint64_t i = 0; whole_ && i < count; ++i) elements.push_back(read());
    return elements;
  }

  void spoil() { whole_ = false; }  // called for an invalid value
  bool exhausted() const { return whole_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool whole_ = true;
};

}  // namespace penumbra::platform
