// Values to bytes and back, for messages to workers and for entries of the cache. A reader of bytes that are
// truncated or damaged gives empty values and says so at the end; it never reads past them, and never
// allocates more than they could hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::validation {

class ByteWriter {
 public:
  void number(std::uint64_t value);
  void text(std::string_view value);  // its length, then its bytes

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

  template <typename Element, typename Read>
  std::vector<Element> list(const Read& read) {
    const std::uint64_t count = number();
    std::vector<Element> elements;
    if (count > rest_.size()) whole_ = false;  // every element takes a byte at least
    for (std::uint64_t i = 0; whole_ && i < count; ++i) elements.push_back(read());
    return elements;
  }

  void spoil() { whole_ = false; }  // a value that cannot be
  bool exhausted() const { return whole_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool whole_ = true;
};

}  // namespace penumbra::validation
