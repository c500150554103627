// One answer in a folder that keeps them: a file of a title, a key, a payload, and the hash of these three.
//
// It is written beside its place and renamed, so several processes may share a folder: a reader sees a whole
// entry or none. What is truncated, damaged, or of another title or key reads as absent.
#pragma once

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace penumbra::reference {

// title: what the payload means, and its version. key: letters and digits that name everything the answer
// depends on.
class CacheEntryWriter {
 public:
  CacheEntryWriter(std::string_view title, const std::string& key) : content_(std::string(title) + key) {}

  template <typename Element>
  void append(std::span<const Element> elements) {
    static_assert(std::is_trivially_copyable_v<Element>);
    content_.append(reinterpret_cast<const char*>(elements.data()), elements.size_bytes());
  }
  template <typename Value>
  void append(const Value& value) {
    append(std::span<const Value>(&value, 1));
  }

  // Makes the folder. False when that or the file fails (full disk, permissions): nothing partial is left,
  // and what a cache does not keep is computed again.
  bool write(const std::filesystem::path& file);

 private:
  std::string content_;
};

class CacheEntryReader {
 public:
  // Nothing for a file that is no whole entry of this title and key.
  static std::optional<CacheEntryReader> open(const std::filesystem::path& file, std::string_view title,
                                              const std::string& key);

  // Elements in the order they were appended; none, and exhausted() never true, when there are not as many.
  template <typename Element>
  std::vector<Element> take(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<Element>);
    if (count > bytes_left() / sizeof(Element)) {
      whole_ = false;
      return {};
    }
    std::vector<Element> elements(count);
    if (count != 0) std::memcpy(elements.data(), payload_.data() + taken_, count * sizeof(Element));
    taken_ += count * sizeof(Element);
    return elements;
  }
  template <typename Value>
  Value take() {
    const std::vector<Value> one = take<Value>(1);
    return one.empty() ? Value{} : one.front();
  }

  std::size_t bytes_left() const { return payload_.size() - taken_; }
  bool exhausted() const { return whole_ && bytes_left() == 0; }

 private:
  explicit CacheEntryReader(std::string payload) : payload_(std::move(payload)) {}

  std::string payload_;
  std::size_t taken_ = 0;
  bool whole_ = true;
};

}  // namespace penumbra::reference
