#include "hlsl/source_text.h"

#include <gtest/gtest.h>

namespace penumbra::hlsl {
namespace {

TEST(SourceText, LineEndingsAndTheByteOrderMarkAreNormalised) {
  EXPECT_EQ(normalise_source("\xEF\xBB\xBF"
                             "a\r\nb\rc\n"),
            "a\nb\nc\n");
}

#ifdef __linux__
// Reading the first page of a process's memory gives EIO, as a broken disk does.
TEST(SourceText, AFileThatCannotBeReadToItsEndHasNoText) {
  const SourceRead read = read_source("/proc/self/mem");
  EXPECT_EQ(read.text, "");
  EXPECT_EQ(read.problem, "reading it failed");
}
#endif

}  // namespace
}  // namespace penumbra::hlsl
