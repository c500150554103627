// Mutates JSON documents so that they stay JSON: libFuzzer's own mutations, of bytes, seldom get past the
// parser. A document's values are replaced by its own names and values, so that many mutants are nearly
// valid.
#include "fuzz/json_mutator.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace penumbra::fuzz {
namespace {

using nlohmann::json;
using Random = std::minstd_rand;

constexpr std::size_t kMostCopies = 300;

const std::vector<json>& edges() {
  static const std::vector<json> all{nullptr,
                                     true,
                                     false,
                                     0,
                                     1,
                                     -1,
                                     2,
                                     255,
                                     65536,
                                     2147483647,
                                     -2147483648LL,
                                     4294967296LL,
                                     9007199254740993LL,
                                     0.5,
                                     -0.0,
                                     1e-300,
                                     1e300,
                                     "",
                                     "..",
                                     "../x",
                                     "/etc/passwd",
                                     "a/b",
                                     ".",
                                     "\n",
                                     "\t*/",
                                     "\"",
                                     "'",
                                     "\\",
                                     std::string("a\0b", 3),
                                     "\xE2\x80\xA8",
                                     "\xE2\x80\xAE",
                                     "<script>",
                                     "]]>",
                                     "=1",
                                     std::string(5000, 'a'),
                                     json::array(),
                                     json::object(),
                                     json::array({json::array({json::array()})})};
  return all;
}

class Mutation {
 public:
  Mutation(json& document, unsigned seed) : document_(document), random_(seed) {}

  void apply() {
    for (std::size_t i = 1 + below(4); i > 0; --i) {
      collect();
      change(*nodes_[below(nodes_.size())]);
    }
  }

 private:
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  void collect() {
    nodes_.clear();
    keys_.clear();
    collect(document_);
  }

  void collect(json& value) {
    nodes_.push_back(&value);
    if (value.is_object())
      for (const auto& [key, element] : value.items()) keys_.push_back(key);
    if (value.is_structured())
      for (json& element : value) collect(element);
  }

  // A value of the document, as often as not of the same type, or an edge.
  json other(const json& value) {
    if (below(3) == 0) return edges()[below(edges().size())];
    for (int attempt = 0; attempt < 8; ++attempt) {
      const json& found = *nodes_[below(nodes_.size())];
      if (found.type() == value.type() && found != value) return found;
    }
    return *nodes_[below(nodes_.size())];
  }

  void change(json& value) {
    if (value.is_object() && !value.empty() && below(4) != 0) return change_object(value);
    if (value.is_array() && !value.empty() && below(4) != 0) return change_array(value);
    if (value.is_number() && below(2) == 0) {
      const double number = value.get<double>();
      value = below(2) == 0 ? number + 1.0 : -number * static_cast<double>(1 + below(3));
      if (value.get<double>() == std::floor(value.get<double>()) && std::abs(value.get<double>()) < 1e9)
        value = static_cast<std::int64_t>(value.get<double>());
      return;
    }
    json replacement = other(value);
    value = std::move(replacement);
  }

  void change_object(json& object) {
    const std::string key =
        std::next(object.begin(), static_cast<std::ptrdiff_t>(below(object.size()))).key();
    switch (below(3)) {
      case 0:
        object.erase(key);
        break;
      case 1: {
        json element = object[key];
        if (below(2) == 0) object.erase(key);
        object[keys_[below(keys_.size())]] = std::move(element);
        break;
      }
      default: {
        json replacement = other(object[key]);
        object[key] = std::move(replacement);
      }
    }
  }

  void change_array(json& array) {
    const auto at = static_cast<std::ptrdiff_t>(below(array.size()));
    switch (below(4)) {
      case 0:
        array.erase(array.begin() + at);
        break;
      case 1: {
        const json element = array[static_cast<std::size_t>(at)];
        const std::size_t copies = below(8) == 0 ? kMostCopies : 1;
        for (std::size_t i = 0; i < copies; ++i) array.push_back(element);
        break;
      }
      case 2:
        std::swap(array[static_cast<std::size_t>(at)], array[below(array.size())]);
        break;
      default: {
        json element = other(array[static_cast<std::size_t>(at)]);
        array.insert(array.begin() + at, std::move(element));
      }
    }
  }

  json& document_;
  Random random_;
  std::vector<json*> nodes_;
  std::vector<std::string> keys_;
};

}  // namespace

std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  json document = seed % 8 == 0 ? json(json::value_t::discarded)
                                : json::parse(data, data + size, nullptr, /*allow_exceptions=*/false);
  if (document.is_discarded()) return LLVMFuzzerMutate(data, size, most);
  Mutation(document, seed).apply();
  const std::string text = document.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}

}  // namespace penumbra::fuzz
