#include "shaders/gl_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace penumbra::shaders {
namespace {

constexpr const char* good_gl =
    "#version 450\nlayout(location = 0) out vec4 c;\nvoid main()\n{\n    c = vec4(1.0);\n}\n";
constexpr const char* good_es =
    "#version 310 es\nprecision highp float;\nlayout(location = 0) out vec4 c;\nvoid main()\n{\n    c = "
    "vec4(1.0);\n}\n";

TEST(GlCheck, AcceptsWhatEachDialectAllows) {
  EXPECT_TRUE(gl_check({{hlsl::Stage::fragment, good_gl}}, Target::glsl450).empty());
  EXPECT_TRUE(gl_check({{hlsl::Stage::fragment, good_es}}, Target::essl310).empty());
}

TEST(GlCheck, HoldsEachDialectToItsOwnRules) {
  // ESSL has no implicit conversion from int; desktop GL 4.5's core 450 has none of its profile.
  const std::string es =
      "#version 310 es\nprecision highp float;\nlayout(location = 0) out vec4 c;\nvoid main()\n{\n    float "
      "x = 1;\n    c = vec4(x);\n}\n";
  const std::string gl =
      "#version 450\nlayout(location = 0) out vec4 c;\nvoid main()\n{\n    float x = 1;\n    c = "
      "vec4(x);\n}\n";
  EXPECT_TRUE(hlsl::has_errors(gl_check({{hlsl::Stage::fragment, es}}, Target::essl310)));
  EXPECT_FALSE(hlsl::has_errors(gl_check({{hlsl::Stage::fragment, gl}}, Target::glsl450)));
}

TEST(GlCheck, ErrorsHaveThePlaceInTheEmittedText) {
  const std::vector<hlsl::Diagnostic> diagnostics =
      gl_check({{hlsl::Stage::fragment,
                 "#version 450\nlayout(location = 0) out vec4 c;\nvoid main()\n{\n    c = missing;\n}\n"}},
               Target::glsl450);
  ASSERT_TRUE(hlsl::has_errors(diagnostics));
  EXPECT_EQ(diagnostics.front().file, "glsl450");
  EXPECT_EQ(diagnostics.front().line, 5);
  EXPECT_EQ(diagnostics.front().source_line, "    c = missing;");
  EXPECT_THAT(diagnostics.front().message, testing::HasSubstr("missing"));
}

TEST(GlCheck, LinksStagesWithEachOther) {
  const std::string vertex =
      "#version 450\nlayout(location = 0) out vec3 a;\nvoid main()\n{\n    a = vec3(1.0);\n    gl_Position = "
      "vec4(0.0);\n}\n";
  const std::string fits =
      "#version 450\nlayout(location = 0) in vec3 a;\nlayout(location = 0) out vec4 c;\nvoid main() { c = "
      "a.xyzz; }\n";
  const std::string clashes =
      "#version 450\nlayout(location = 0) flat in ivec2 b;\nlayout(location = 0) out vec4 c;\nvoid main() { "
      "c = "
      "vec4(b.xyxy); }\n";
  EXPECT_FALSE(hlsl::has_errors(
      gl_check({{hlsl::Stage::vertex, vertex}, {hlsl::Stage::fragment, fits}}, Target::glsl450)));
  EXPECT_TRUE(hlsl::has_errors(
      gl_check({{hlsl::Stage::vertex, vertex}, {hlsl::Stage::fragment, clashes}}, Target::glsl450)));
}

TEST(GlCheck, ThreadsDoNotDisturbEachOther) {
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&wrong] {
      for (int i = 0; i < 6; ++i) {
        if (hlsl::has_errors(gl_check({{hlsl::Stage::fragment, good_gl}}, Target::glsl450))) ++wrong;
        if (hlsl::has_errors(gl_check({{hlsl::Stage::fragment, good_es}}, Target::essl310))) ++wrong;
        if (!hlsl::has_errors(gl_check({{hlsl::Stage::fragment, "#version 450\nbroken"}}, Target::glsl450)))
          ++wrong;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(GlCheck, NamesTheDriver) {
  EXPECT_THAT(gl_driver(Target::essl310), testing::HasSubstr("OpenGL ES"));
  EXPECT_FALSE(gl_driver(Target::glsl450).empty());
}

}  // namespace
}  // namespace penumbra::shaders
