// Hashes the content of any value: each field of a struct, and each element of what a field contains. No list
// of fields has to be kept, so a field that is added later is in the hash.
//
// A type that is neither number, text, path, container, optional, vector of GLM nor aggregate has to bring a
// function
//   void add_fields(platform::ContentHash& hash, const Type& value);
// in its own namespace, or does not compile.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "platform/content_hash.h"

namespace penumbra::platform {

// This is declared before all of the functions, because they call each other.
template <typename Value>
void add_all(ContentHash& hash, const Value& value);

namespace fields {

template <typename Value>
concept Own = requires(ContentHash& hash, const Value& value) {
  add_fields(hash, value);
};

template <typename Value>
concept Text = std::convertible_to<const Value&, std::string_view>;

template <typename Value>
concept Pair = requires(const Value& value) {
  value.first;
  value.second;
};

template <typename Value>
concept Optional = requires(const Value& value) {
  { value.has_value() } -> std::same_as<bool>;
  *value;
};

// A vector or matrix of GLM.
template <typename Value>
concept Indexed = requires(const Value& value) {
  typename Value::value_type;
  value.length();
  value[0];
};

// The bytes of such an element are its value. They are hashed at once, because maps and pictures have
// millions.
template <typename Element>
concept Plain = (std::integral<Element> && !std::same_as<Element, bool>) || std::floating_point<Element> ||
                std::same_as<Element, std::byte>;

// A vector of GLM without padding.
template <typename Element>
concept PlainVector = Indexed<Element> && Plain<typename Element::value_type> &&
                      sizeof(Element) == Element::length() * sizeof(typename Element::value_type);

// Calls `use` with the fields of a struct, which has as many as its initialiser takes.
template <typename Struct, typename Use>
void with_fields(const Struct& value, const Use& use) {
  if constexpr (requires {
                  Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
                }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t);
  } else if constexpr (requires {
                         Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
                       }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s);
  } else if constexpr (requires {
                         Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
                       }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r);
  } else if constexpr (requires {
                         Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
                       }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l, m);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value;
    use(a, b, c, d, e, f, g, h, i, j, k, l);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k] = value;
    use(a, b, c, d, e, f, g, h, i, j, k);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h, i, j] = value;
    use(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h, i] = value;
    use(a, b, c, d, e, f, g, h, i);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g, h] = value;
    use(a, b, c, d, e, f, g, h);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f, g] = value;
    use(a, b, c, d, e, f, g);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e, f] = value;
    use(a, b, c, d, e, f);
  } else if constexpr (requires { Struct{{}, {}, {}, {}, {}}; }) {
    const auto& [a, b, c, d, e] = value;
    use(a, b, c, d, e);
  } else if constexpr (requires { Struct{{}, {}, {}, {}}; }) {
    const auto& [a, b, c, d] = value;
    use(a, b, c, d);
  } else if constexpr (requires { Struct{{}, {}, {}}; }) {
    const auto& [a, b, c] = value;
    use(a, b, c);
  } else if constexpr (requires { Struct{{}, {}}; }) {
    const auto& [a, b] = value;
    use(a, b);
  } else if constexpr (requires { Struct{{}}; }) {
    const auto& [a] = value;
    use(a);
  }
}

template <typename Range>
void add_range(ContentHash& hash, const Range& range) {
  using Element = std::ranges::range_value_t<Range>;
  if constexpr (std::ranges::contiguous_range<Range> && (Plain<Element> || PlainVector<Element>)) {
    hash.update(std::as_bytes(std::span<const Element>(std::ranges::data(range), std::ranges::size(range))));
  } else {
    hash.update(static_cast<std::size_t>(std::ranges::distance(range)));
    for (const auto& element : range) add_all<Element>(hash, element);
  }
}

}  // namespace fields

template <typename Value>
void add_all(ContentHash& hash, const Value& value) {
  if constexpr (fields::Own<Value>) {
    add_fields(hash, value);
  } else if constexpr (std::is_enum_v<Value>) {
    hash.update(static_cast<std::int64_t>(value));
  } else if constexpr (std::integral<Value>) {
    hash.update(value);
  } else if constexpr (std::floating_point<Value>) {
    hash.update(static_cast<double>(value));
  } else if constexpr (std::same_as<Value, std::filesystem::path>) {
    hash.update(std::string_view(value.native()));
  } else if constexpr (fields::Text<Value>) {
    hash.update(std::string_view(value));
  } else if constexpr (std::ranges::range<Value>) {
    fields::add_range(hash, value);
  } else if constexpr (fields::Optional<Value>) {
    hash.update(value.has_value());
    if (value) add_all(hash, *value);
  } else if constexpr (fields::Pair<Value>) {
    add_all(hash, value.first);
    add_all(hash, value.second);
  } else if constexpr (fields::Indexed<Value>) {
    for (int i = 0; i < static_cast<int>(value.length()); ++i) add_all(hash, value[i]);
  } else {
    static_assert(std::is_aggregate_v<Value>, "needs an add_fields() of its own");
    fields::with_fields(value, [&](const auto&... field) { (add_all(hash, field), ...); });
  }
}

// Returns a hash of all the values.
template <typename... Values>
std::string hash_of(const Values&... values) {
  ContentHash hash;
  (add_all(hash, values), ...);
  return hash.hex();
}

}  // namespace penumbra::platform
