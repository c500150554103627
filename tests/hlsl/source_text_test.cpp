#include "hlsl/source_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace penumbra::hlsl {
namespace {

TEST(SourceText, LineEndingsAndTheByteOrderMarkAreNormalised) {
  EXPECT_EQ(normalise_source("\xEF\xBB\xBF"
                             "a\r\nb\rc\n"),
            "a\nb\nc\n");
}

// Such directives would place what is wrong with the file in another one, or in a line that it does not have.
TEST(SourceText, LineDirectivesOfAFileAreBlanked) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "penumbra_source_text_line.hlsl";
  std::ofstream(file)
      << "#line 9\n \t# line 3 \"a\" \\\n  4\nfloat line; // #line 2\n#lines\na #line 5\n#line";
  const SourceRead read = read_source(file);
  std::filesystem::remove(file);
  EXPECT_EQ(read.text, "       \n \t             \\\n   \nfloat line; // #line 2\n#lines\na #line 5\n     ");
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
