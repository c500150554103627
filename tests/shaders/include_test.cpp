// Tests Unity's include rules, and what is said when an include fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/input_error.h"
#include "shader_files.h"
#include "shaders/compile.h"
#include "shaders/source_memory.h"

namespace penumbra::shaders {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::string only_message(const CompileResult& result) {
  return result.diagnostics.size() == 1 ? format(result.diagnostics.front())
                                        : std::to_string(result.diagnostics.size()) + " messages";
}

TEST(Include, PackageRootComesBeforeTheFoldersBeside) {
  const ShaderFiles files;
  files.write("roots/core/Lib/A.hlsl", "#define WIDTH 4\n");
  files.write("Packages/com.x.core/Lib/A.hlsl", "#error the wrong one\n");
  files.write("main.hlsl", compute_shader("WIDTH", "#include \"Packages/com.x.core/Lib/A.hlsl\"\n"));
  CompileRequest request = files.request("main.hlsl");
  request.package_roots = {{"com.x.core", files.path("roots/core")}};
  const CompileResult result = compile(request);
  EXPECT_FALSE(hlsl::has_errors(result.diagnostics));
  EXPECT_THAT(result.dependencies, Contains(files.path("roots/core/Lib/A.hlsl")));
}

TEST(Include, ALeadingSlashMeansBesideTheIncludingFile) {
  const ShaderFiles files;
  files.write("inc/a.hlsl", "#define A 1\n");
  files.write("main.hlsl", compute_shader("A", "#include \"/inc/a.hlsl\"\n"));
  EXPECT_FALSE(hlsl::has_errors(compile(files.request("main.hlsl")).diagnostics));
}

TEST(Include, TheLastLineNeedsNoNewline) {
  const ShaderFiles files;
  files.write("a.hlsl", "#include \"b.hlsl\"");
  files.write("b.hlsl", "static const float b = 1;");
  files.write("main.hlsl", compute_shader("1") + "#include \"a.hlsl\"");
  EXPECT_FALSE(hlsl::has_errors(compile(files.request("main.hlsl")).diagnostics));
}

TEST(Include, LooksBesideTheIncludingFileThenInTheIncludeFolders) {
  const ShaderFiles files;
  files.write("lib/a.hlsl", "#include \"inner/b.hlsl\"\n#include \"c.hlsl\"\n");
  files.write("lib/inner/b.hlsl", "#include \"../d.hlsl\"\n");
  files.write("lib/d.hlsl", "#define D 1\n");
  files.write("lib/c.hlsl", "#define C 2\n");
  files.write("other/c.hlsl", "#error the wrong one\n");
  files.write("main.hlsl", compute_shader("C + D", "#include \"a.hlsl\"\n"));
  CompileRequest request = files.request("main.hlsl");
  request.include_directories = {files.path("other"), files.path("lib")};
  EXPECT_EQ(hlsl::has_errors(compile(request).diagnostics), false);
}

// A file that is read for two shaders finds what is beside each of them.
TEST(Include, LooksBesideTheCompiledFileToo) {
  const ShaderFiles files;
  files.write("package.json", "");
  files.write("shared/a.hlsl", "#include \"size.hlsl\"\n");
  SourceMemory memory;
  for (const char* folder : {"one", "two"}) {
    const std::string place(folder);
    files.write(place + "/size.hlsl", "#define SIZE 1\n");
    files.write(place + "/main.hlsl", compute_shader("SIZE", "#include \"../shared/a.hlsl\"\n"));
    const PreprocessedSource expanded = expand(files.request(place + "/main.hlsl"), memory);
    EXPECT_TRUE(expanded.sources.contains(files.path(place + "/size.hlsl").string())) << folder;
  }
}

// Errors of an include show the line they are about.
TEST(Include, NoLineOfAFileOutsideIsShown) {
  const ShaderFiles files;
  const ShaderFiles elsewhere;
  elsewhere.write("secret.txt", "password=hunter2\n");
  files.write("main.hlsl",
              compute_shader("1", "#include \"" + elsewhere.path("secret.txt").string() + "\"\n"));
  const CompileResult result = compile(files.request("main.hlsl"));
  EXPECT_THAT(only_message(result),
              testing::AllOf(HasSubstr("main.hlsl:"), HasSubstr("outside of the project"),
                             testing::Not(HasSubstr("hunter2"))));
  EXPECT_THAT(result.dependencies, testing::ElementsAre(files.path("main.hlsl")));
}

// Text of the program's own has a name, not a place.
class WrittenText : public testing::Test {
 protected:
  WrittenText() {
    std::filesystem::create_directories(files.path("here"));
    std::filesystem::current_path(files.path("here"));
  }
  ~WrittenText() override { std::filesystem::current_path(before_); }

  CompileResult compiled(const std::string& include) const {
    CompileRequest request = files.request("unused");
    request.file = "mine.hlsl";
    request.text = compute_shader("1", "#include \"" + include + "\"\n");
    request.written_for = files.path("theirs/shaders/theirs.hlsl");
    request.include_directories = {files.path("library")};
    return compile(request);
  }

  ShaderFiles files;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(WrittenText, TheCurrentFolderIsNotRead) {
  files.write("here/secret.hlsl", "password=hunter2\n");
  files.write("theirs/shaders/theirs.hlsl", "#include \"../../here/secret.hlsl\"\n");
  for (const std::string& include : {std::string("secret.hlsl"), files.path("here/secret.hlsl").string(),
                                     files.path("theirs/shaders/theirs.hlsl").string()})
    EXPECT_THAT(only_message(compiled(include)),
                testing::AllOf(testing::AnyOf(HasSubstr("outside of the project"), HasSubstr("cannot find")),
                               testing::Not(HasSubstr("hunter2"))))
        << include;
}

TEST_F(WrittenText, NothingIsBesideIt) {
  files.write("here/a.hlsl", "#error the wrong one\n");
  files.write("library/a.hlsl", "");
  EXPECT_FALSE(hlsl::has_errors(compiled("a.hlsl").diagnostics));
}

TEST_F(WrittenText, TheTreeOfTheFileThatItIsForIsRead) {
  files.write("theirs/package.json", "{}");
  files.write("theirs/common.hlsl", "");
  files.write("theirs/shaders/theirs.hlsl", "#include \"../common.hlsl\"\n");
  const CompileResult result = compiled(files.path("theirs/shaders/theirs.hlsl").string());
  EXPECT_FALSE(hlsl::has_errors(result.diagnostics));
  EXPECT_THAT(result.dependencies, Contains(files.path("theirs/common.hlsl")));
}

TEST(Include, DependenciesAreTheFilesRead) {
  const ShaderFiles files;
  files.write("a.hlsl", "#define A 1\n");
  files.write("unused.hlsl", "#define B 1\n");
  files.write("main.hlsl", compute_shader("A", "#include \"a.hlsl\"\n#include \"a.hlsl\"\n"));
  const CompileResult result = compile(files.request("main.hlsl"));
  EXPECT_THAT(result.dependencies, testing::ElementsAre(files.path("main.hlsl"), files.path("a.hlsl")));
}

TEST(Include, MissingFileNamesPlacesAndTheNearestName) {
  const ShaderFiles files;
  files.write("ShadowBias.hlsl", "");
  files.write("main.hlsl", compute_shader("1", "\n#include \"ShadowBais.hlsl\"\n"));
  const CompileResult result = compile(files.request("main.hlsl"));
  EXPECT_EQ(only_message(result),
            files.path("main.hlsl").string() + ":2:1: error: cannot find 'ShadowBais.hlsl'; tried " +
                files.path("ShadowBais.hlsl").string() + "; did you mean " +
                files.path("ShadowBias.hlsl").string() + "?\n    #include \"ShadowBais.hlsl\"\n    ^");
}

TEST(Include, MissingFileOfAnIncludeIsReportedThere) {
  const ShaderFiles files;
  files.write("a.hlsl", "// first\n#include \"gone.hlsl\"\n");
  files.write("main.hlsl", compute_shader("1", "#include \"a.hlsl\"\n"));
  const CompileResult result = compile(files.request("main.hlsl"));
  EXPECT_THAT(only_message(result), HasSubstr("a.hlsl:2:1: error: cannot find 'gone.hlsl'"));
}

TEST(Include, UnknownPackageNamesTheNearestRoot) {
  const ShaderFiles files;
  files.write("main.hlsl", compute_shader("1", "#include \"Packages/com.x.cor/A.hlsl\"\n"));
  CompileRequest request = files.request("main.hlsl");
  request.package_roots = {{"com.x.core", files.path("")}};
  EXPECT_THAT(only_message(compile(request)),
              HasSubstr("no package root is given for 'com.x.cor'; did you mean 'com.x.core'?"));
}

TEST(Include, CycleWithoutGuardsIsNamedOnce) {
  const ShaderFiles files;
  files.write("a.hlsl", "#include \"b.hlsl\"\n");
  files.write("b.hlsl", "\n#include \"a.hlsl\"\n");
  files.write("main.hlsl", compute_shader("1", "#include \"a.hlsl\"\n"));
  const std::string a = files.path("a.hlsl").string();
  const std::string b = files.path("b.hlsl").string();
  const std::string message = only_message(compile(files.request("main.hlsl")));
  EXPECT_THAT(message, HasSubstr("includes nest too deeply: "));
  EXPECT_THAT(message, testing::AnyOf(HasSubstr(": " + a + " -> " + b + " -> " + a + "\n"),
                                      HasSubstr(": " + b + " -> " + a + " -> " + b + "\n")));
}

TEST(Include, FileThatIncludesItselfIsACycle) {
  const ShaderFiles files;
  files.write("main.hlsl", compute_shader("1", "#include \"main.hlsl\"\n"));
  const std::string main = files.path("main.hlsl").string();
  EXPECT_THAT(only_message(compile(files.request("main.hlsl"))), HasSubstr(main + " -> " + main + "\n"));
}

// There are as many ways down as 2 to the power of the greatest depth; the first is enough.
TEST(Include, FileThatIncludesItselfTwiceEndsAsSoon) {
  const ShaderFiles files;
  files.write("main.hlsl", compute_shader("1", "#include \"main.hlsl\"\n#include \"main.hlsl\"\n"));
  EXPECT_THAT(only_message(compile(files.request("main.hlsl"))), HasSubstr("includes nest too deeply: "));
}

TEST(Include, CycleWithGuardsIsNone) {
  const ShaderFiles files;
  files.write("a.hlsl", "#ifndef A\n#define A 1\n#include \"b.hlsl\"\n#endif\n");
  files.write("b.hlsl", "#ifndef B\n#define B 2\n#include \"a.hlsl\"\n#endif\n");
  files.write("main.hlsl", compute_shader("A + B", "#include \"a.hlsl\"\n"));
  EXPECT_TRUE(compile(files.request("main.hlsl")).diagnostics.empty());
}

// URP has a file once for every value of a macro in this way. The second time brings a function of its own.
TEST(Include, AFileWhoseGuardIsUndefinedIsReadAgain) {
  const std::string again = "#undef A_INCLUDED\n#define NAME Second\n#include \"a.hlsl\"\n";
  for (const bool by_the_main_file : {true, false}) {
    const ShaderFiles files;
    files.write("a.hlsl",
                "#ifndef A_INCLUDED\n#define A_INCLUDED\nfloat NAME() { return 1; }\n#undef NAME\n#endif\n");
    files.write("again.hlsl", again);
    files.write("main.hlsl", compute_shader("First() + Second()",
                                            "#define NAME First\n#include \"a.hlsl\"\n#include \"a.hlsl\"\n" +
                                                (by_the_main_file ? again : "#include \"again.hlsl\"\n")));
    CompileRequest request = files.request("main.hlsl");
    request.prepare = true;
    const CompileResult result = compile(request);
    EXPECT_TRUE(result.diagnostics.empty()) << format(result.diagnostics.at(0));
  }
}

TEST(Include, FolderAndDanglingLinkCannotBeRead) {
  const ShaderFiles files;
  std::filesystem::create_directories(files.path("folder.hlsl"));
  std::filesystem::create_symlink(files.path("nowhere"), files.path("link.hlsl"));
  files.write("one.hlsl", compute_shader("1", "#include \"folder.hlsl\"\n"));
  files.write("two.hlsl", compute_shader("1", "#include \"link.hlsl\"\n"));
  EXPECT_THAT(only_message(compile(files.request("one.hlsl"))),
              HasSubstr("one.hlsl:1:1: error: cannot read '" + files.path("folder.hlsl").string() +
                        "': it is a folder, not a file"));
  EXPECT_THAT(only_message(compile(files.request("two.hlsl"))),
              HasSubstr("cannot read '" + files.path("link.hlsl").string() + "': no such file"));
}

TEST(Include, MainFileThatCannotBeReadIsBadInput) {
  const ShaderFiles files;
  EXPECT_THROW(compile(files.request("gone.hlsl")), InputError);
  EXPECT_THROW(compile(files.request("")), InputError);
}

TEST(Include, ProjectEditorFolderAndVersionedPackageResolve) {
  const ShaderFiles files;
  files.write("Assets/Lib/A.hlsl", "\xEF\xBB\xBF#define A 1\r\n");
  files.write("CGIncludes/UnityCG.cginc", "#define B 2\n");
  files.write("core/C.hlsl", "#define C 3\n");
  files.write("main.hlsl", compute_shader("A + B + C",
                                          "#include \"Assets\\Lib\\A.hlsl\"\r\n#include <UnityCG.cginc>\r\n"
                                          "#include \"Packages/com.x.core@14.0.9/C.hlsl\"\r\n"));
  CompileRequest request = files.request("main.hlsl");
  request.project = files.path("");
  request.cginc_root = files.path("CGIncludes");
  request.package_roots = {{"com.x.core", files.path("core")}};
  const CompileResult result = compile(request);
  EXPECT_TRUE(result.diagnostics.empty()) << only_message(result);
  EXPECT_THAT(result.dependencies, Contains(files.path("Assets/Lib/A.hlsl")));
  EXPECT_EQ(result.missing_editor_include, "");
}

TEST(Include, OtherCaseIsOneWarningAtTheIncludeThatHasIt) {
  const ShaderFiles files;
  files.write("Lib/Math.hlsl", "#define A 1\n");
  files.write("a.hlsl", "// lib/math.hlsl\n  # include \"lib/math.hlsl\"\n");
  files.write("main.hlsl", compute_shader("A", "#include \"a.hlsl\"\n#include \"a.hlsl\"\n"));
  CompileRequest request = files.request("main.hlsl");
  const std::string expected = files.path("a.hlsl").string() + ":2:14: warning: 'lib/math.hlsl' names " +
                               files.path("Lib/Math.hlsl").string() +
                               " in another case; only disks that ignore case find it\n"
                               "      # include \"lib/math.hlsl\"\n                 ^";
  EXPECT_EQ(only_message(compile(request)), expected);
  request.prepare = true;
  const CompileResult prepared = compile(request);
  EXPECT_EQ(only_message(prepared), expected);
  EXPECT_FALSE(prepared.spirv.empty());
}

TEST(Include, MissingEditorIncludeIsToldApartFromAMistake) {
  const ShaderFiles files;
  files.write("lib.hlsl", "\n#include \"UnityCG.cginc\"\n");
  files.write("main.hlsl", compute_shader("1", "#include \"lib.hlsl\"\n#include \"Lighting.cginc\"\n"));
  files.write("wrong.hlsl", compute_shader("1", "#include \"gone.hlsl\"\n#include \"UnityCG.cginc\"\n"));
  for (const bool prepared : {false, true}) {
    CompileRequest request = files.request("main.hlsl");
    request.prepare = prepared;
    const CompileResult result = compile(request);
    EXPECT_EQ(result.missing_editor_include, "UnityCG.cginc");
    EXPECT_THAT(only_message(result),
                HasSubstr(files.path("lib.hlsl").string() +
                          ":2:1: error: cannot find 'UnityCG.cginc': it ships only with the Unity editor "
                          "(Editor/Data/CGIncludes); name that folder with --cginc-root DIR\n"));
    request.file = files.path("wrong.hlsl");
    EXPECT_EQ(compile(request).missing_editor_include, "");
  }
}

TEST(Include, EditorIncludeInADeadBranchIsNotMissed) {
  const ShaderFiles files;
  files.write("main.hlsl", compute_shader("1", "#if 0\n#include \"UnityCG.cginc\"\n#endif\n"));
  const CompileResult result = compile(files.request("main.hlsl"));
  EXPECT_TRUE(result.diagnostics.empty());
  EXPECT_EQ(result.missing_editor_include, "");
}

}  // namespace
}  // namespace penumbra::shaders
