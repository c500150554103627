// A number of variants: exact up to 2^64 - 2, saturating beyond.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace penumbra::variants {

class VariantCount {
 public:
  constexpr VariantCount() = default;
  constexpr explicit VariantCount(std::uint64_t value) : value_(value) {}

  constexpr std::uint64_t value() const { return value_; }
  constexpr bool saturated() const { return value_ == limit; }

  constexpr VariantCount& operator+=(VariantCount other) {
    value_ = value_ > limit - other.value_ ? limit : value_ + other.value_;
    return *this;
  }
  constexpr VariantCount& operator*=(VariantCount other) {
    value_ = value_ != 0 && other.value_ > limit / value_ ? limit : value_ * other.value_;
    return *this;
  }
  friend constexpr VariantCount operator+(VariantCount a, VariantCount b) { return a += b; }
  friend constexpr VariantCount operator*(VariantCount a, VariantCount b) { return a *= b; }
  constexpr bool operator==(const VariantCount&) const = default;
  friend constexpr bool operator<(VariantCount a, VariantCount b) { return a.value_ < b.value_; }
  friend constexpr bool operator>(VariantCount a, VariantCount b) { return b < a; }

  static constexpr VariantCount at_least_limit() { return VariantCount(limit); }

 private:
  static constexpr std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t value_ = 0;
};

// Returns "1,234,567", or "more than 18,446,744,073,709,551,614" when saturated.
std::string text_of(VariantCount count);

}  // namespace penumbra::variants
