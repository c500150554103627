#include "preprocessing/random_macros.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "preprocessing/both_preprocessors.h"

namespace penumbra::preprocessing {
namespace {

constexpr std::uint32_t usual_count = 3000;

// PENUMBRA_MACRO_PROGRAMS=N reads the first N.
std::uint32_t wanted_count() {
  const char* const set = std::getenv("PENUMBRA_MACRO_PROGRAMS");
  return set != nullptr ? static_cast<std::uint32_t>(std::strtoul(set, nullptr, 10)) : usual_count;
}

TEST(RandomMacros, AreReadAsGlslangReadsThem) {
  const std::uint32_t count = wanted_count();
  std::uint32_t left = 0;
  std::uint32_t differ = 0;
  for (std::uint32_t seed = 0; seed < count && differ < 3; ++seed) {
    const std::string text = random_macros(seed);
    const BothTexts both = both_texts(text);
    if (both.left_to_glslang) ++left;
    if (both.own == both.of_glslang) continue;
    ++differ;
    ADD_FAILURE() << "seed " << seed << ":\n"
                  << text << "\nown:\n"
                  << both.own << "\nglslang's:\n"
                  << both.of_glslang;
  }
  RecordProperty("left_to_glslang", static_cast<int>(left));
  EXPECT_LT(left, count * 2 / 3) << "too few are read by the project's own preprocessor";
}

}  // namespace
}  // namespace penumbra::preprocessing
