#include "preparation/bare_source.h"

#include <gmock/gmock.h>

namespace penumbra::preparation {
namespace {

using testing::ElementsAre;

TEST(IncludeGuard, StandsAroundTheWholeFile) {
  EXPECT_EQ(include_guard("\n#ifndef A_INCLUDED\n#define A_INCLUDED\nfloat a;\n#endif\n\n"), "A_INCLUDED");
  EXPECT_EQ(include_guard("# ifndef  A \n\n#define A 1\n#endif"), "A");
  EXPECT_EQ(
      include_guard("#ifndef A\n#define A\n#if B\n#else\n#endif\n#ifdef C\n#elif D\n#endif\n#endif // A\n"),
      "A");
}

TEST(IncludeGuard, AnythingElseIsNone) {
  for (const char* text :
       {"", "float a;\n", "#ifndef A\n#define A\n",           // never closed
        "#ifndef A\n#define B\n#endif\n",                     // another macro
        "#ifndef A\n#define AB\n#endif\n",                    // another macro, too
        "#ifndef A\nfloat a;\n#define A\n#endif\n",           // code before it
        "float a;\n#ifndef A\n#define A\n#endif\n",           // outside
        "#ifndef A\n#define A\n#endif\nfloat a;\n",           // behind
        "#ifndef A\n#define A\n#else\nfloat a;\n#endif\n",    // what is read the second time differs
        "#ifndef A\n#define A\n#elif B\nfloat a;\n#endif\n",  // what is read the second time differs
        "#ifndef A\n#define A\n#endif\n#ifndef B\n#define B\n#endif\n", "#ifdef A\n#define A\n#endif\n",
        "#if 1\n#define A\n#endif\n", "#ifndef\n#define\n#endif\n"})
    EXPECT_EQ(include_guard(text), "") << text;
}

TEST(IncludeGuard, LinesThatGoOnAreNoDirectives) {
  EXPECT_EQ(include_guard("#ifndef A\n#define A\n#define B \\\n#endif\nfloat a;\n#endif\n"), "A");
}

TEST(IncludeGuard, UndefinedMacrosAreKnown) {
  EXPECT_THAT(undefined_macros("#undef A\n  # undef  B \n#ifdef C\n#undef C\n#endif\n#define D\n"),
              ElementsAre("A", "B", "C"));
}

}  // namespace
}  // namespace penumbra::preparation
