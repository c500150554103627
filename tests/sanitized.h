// Tests that repeat something thousands of times do so less often with the address sanitizer. Code is many
// times slower then, and most of the inputs come from the fuzz targets.
#pragma once

namespace penumbra {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr int sanitizer_reduction = 50;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr int sanitizer_reduction = 50;
#else
inline constexpr int sanitizer_reduction = 1;
#endif
#else
inline constexpr int sanitizer_reduction = 1;
#endif

}  // namespace penumbra
