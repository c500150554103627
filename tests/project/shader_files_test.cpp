// Tests which files of a project are shaders to compile.
#include "project/shader_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/input_error_matcher.h"
#include "project_folder.h"

namespace penumbra::project {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> shown(const ShaderFiles& found) {
  std::vector<std::string> names;
  for (const ShaderFile& file : found.files) names.push_back(file.shown);
  return names;
}

TEST(ShaderFiles, AreTheShadersOfAssetsAndPackagesInOrder) {
  const ProjectFolder files;
  for (const char* name : {"Assets/b.shader", "Assets/A/z.compute", "Assets/a.SHADER", "Assets/lib.hlsl",
                           "Assets/a.cginc", "Packages/x/Shaders/p.shader", "Packages/x/package.json",
                           "Packages/loose/q.shader", "Library/PackageCache/y/r.shader", "Other/s.shader"})
    files.write(name, "");
  const ShaderFiles found = find_shader_files(files.path(), {});
  EXPECT_THAT(shown(found), ElementsAre("Assets/A/z.compute", "Assets/a.SHADER", "Assets/b.shader",
                                        "Packages/x/Shaders/p.shader"));
  EXPECT_EQ(found.files.front().path, files.path("Assets/A/z.compute"));
  EXPECT_THAT(found.problems, IsEmpty());
}

// Messages quote lines of what is validated.
TEST(ShaderFiles, ALinkThatLeadsOutIsNotFollowedByItsNameEither) {
  const ProjectFolder files;
  files.write("outside/secret.txt", "secret");
  files.write("Game/Assets/real.shader", "");
  files.write("Game/ProjectSettings/a.asset", "");
  fs::create_symlink(files.path("outside/secret.txt"), files.path("Game/Assets/out.shader"));
  fs::create_symlink(files.path("Game/Assets/real.shader"), files.path("Game/Assets/in.shader"));
  expect_input_error([&] { require_shader_file(files.path("Game/Assets/out.shader")); },
                     HasSubstr("out.shader: is a symbolic link to outside of the folder that it belongs to"));
  EXPECT_NO_THROW(require_shader_file(files.path("Game/Assets/in.shader")));
}

TEST(ShaderFiles, WhatUnityPassesOverIsPassedOver) {
  const ProjectFolder files;
  for (const char* name :
       {"Assets/Samples~/a.shader", "Assets/.git/a.shader", "Assets/.a.shader", "Assets/CVS/a.shader",
        "Assets/x.tmp/a.shader", "Assets/a.shader~", "Assets/Tilde~x/a.shader",
        "Packages/x/Samples~/a.shader", "Packages/x/package.json"})
    files.write(name, "");
  fs::create_directories(files.path("Assets/folder.shader"));
  EXPECT_THAT(shown(find_shader_files(files.path(), {})), ElementsAre("Assets/Tilde~x/a.shader"));
}

TEST(ShaderFiles, ShaderGraphsAreNamedWithWhatToDo) {
  const ProjectFolder files;
  files.write("Assets/b.shadergraph", "{}");
  files.write("Assets/a.ShaderSubGraph", "{}");
  expect_input_error([&] { find_shader_files(files.path(), {}); },
                     HasSubstr("there are Shader Graphs: in Unity select the graph, press View Generated "
                               "Shader"));
  files.write("Assets/c.shader", "");
  const ShaderFiles found = find_shader_files(files.path(), {});
  EXPECT_THAT(shown(found), ElementsAre("Assets/c.shader"));
  EXPECT_THAT(
      formatted(found.problems),
      ElementsAre(HasSubstr("a.ShaderSubGraph: warning: is a Shader Graph and is not validated and 1 more; "
                            "in Unity select the graph")));
  EXPECT_THAT(find_shader_files(files.path(), {{}, {"Assets/c.*"}, {}}).problems, IsEmpty());
  expect_input_error(
      [&] {
        find_shader_files({}, {{files.path("Assets/b.shadergraph")}, {}, {}});
      },
      HasSubstr("b.shadergraph: is a Shader Graph, from which the Unity editor writes the "
                "shader\n  in Unity select the graph"));
}

TEST(ShaderFiles, LinksAreFollowedAndCyclesEnd) {
  const ProjectFolder files;
  files.write("Assets/A/a.shader", "");
  files.write("Outside/b.shader", "");
  fs::create_directory_symlink(files.path("Assets"), files.path("Assets/A/again"));
  fs::create_directory_symlink(files.path("Assets/A"), files.path("Assets/0"));
  fs::create_directory_symlink(files.path("Outside"), files.path("Assets/linked"));
  fs::create_symlink(files.path("nowhere"), files.path("Assets/dangling.shader"));
  const ShaderFiles found = find_shader_files(files.path(), {});
  EXPECT_THAT(shown(found), ElementsAre("Assets/A/a.shader", "Assets/linked/b.shader"));
  EXPECT_THAT(formatted(found.problems),
              ElementsAre(HasSubstr(
                  "Assets/dangling.shader: warning: is a symbolic link to a file that does not exist")));
}

TEST(ShaderFiles, LinksOutOfTheProjectAreLeftOutAndNamed) {
  const ProjectFolder files;
  const ProjectFolder elsewhere;
  files.write("Assets/a.shader", "");
  elsewhere.write("b.shader", "");
  fs::create_directory_symlink(elsewhere.path(), files.path("Assets/linked"));
  fs::create_symlink(elsewhere.path("b.shader"), files.path("Assets/b.shader"));
  fs::create_symlink(elsewhere.path("b.shader"), files.path("Assets/b.txt"));
  const ShaderFiles found = find_shader_files(files.path(), {});
  EXPECT_THAT(shown(found), ElementsAre("Assets/a.shader"));
  EXPECT_THAT(formatted(found.problems),
              testing::UnorderedElementsAre(
                  HasSubstr("Assets/linked: warning: is a symbolic link to outside of the project"),
                  HasSubstr("Assets/b.shader: warning: is a symbolic link to outside of the project")));
  ShaderSelection selection;
  selection.places = {elsewhere.path()};
  EXPECT_EQ(find_shader_files(files.path(), selection).files.size(), 1u) << "named on the command line";
}

TEST(ShaderFiles, PatternsChooseAndDrop) {
  const ProjectFolder files;
  for (const char* name : {"Assets/Water/a.shader", "Assets/Water/Old/b.shader", "Assets/Fire/c.shader"})
    files.write(name, "");
  ShaderSelection selection;
  selection.include = {"Assets/Water/**"};
  EXPECT_THAT(shown(find_shader_files(files.path(), selection)),
              ElementsAre("Assets/Water/Old/b.shader", "Assets/Water/a.shader"));
  selection.exclude = {"**/Old/**"};
  EXPECT_THAT(shown(find_shader_files(files.path(), selection)), ElementsAre("Assets/Water/a.shader"));
  selection.include = {"Assets/Wtaer/**", "c.shader"};
  const ShaderFiles found = find_shader_files(files.path(), selection);
  EXPECT_THAT(shown(found), ElementsAre("Assets/Fire/c.shader"));
  EXPECT_THAT(formatted(found.problems),
              ElementsAre("warning: --only 'Assets/Wtaer/**' matches no shader file"));
  EXPECT_THAT(formatted(find_shader_files(files.path(), {{}, {}, {"**/Old/**", "Odl/**"}}).problems),
              ElementsAre("warning: --skip 'Odl/**' matches no shader file"));
}

TEST(ShaderFiles, PatternsLeaveOutNamedFilesToo) {
  const ProjectFolder files;
  files.write("Assets/Theirs/a.shader", "");
  files.write("Assets/b.shader", "");
  ShaderSelection selection;
  selection.places = {files.path("Assets/Theirs/a.shader"), files.path("Assets/b.shader")};
  selection.exclude = {"Assets/Theirs/**"};
  const ShaderFiles found = find_shader_files(files.path(), selection);
  EXPECT_THAT(shown(found), ElementsAre("Assets/b.shader"));
  EXPECT_THAT(formatted(found.problems),
              ElementsAre(HasSubstr("Assets/Theirs/a.shader: note: is left out by --only or --skip")));
  selection.places.pop_back();
  EXPECT_THAT(shown(find_shader_files(files.path(), selection)), testing::IsEmpty())
      << "nothing to do, no error";
}

TEST(ShaderFiles, PatternsThatMatchNothingAreRefusedWithTheNearestName) {
  const ProjectFolder files;
  for (const char* name : {"Assets/Water/a.shader", "Assets/Fire/c.shader"}) files.write(name, "");
  const auto with = [&](const std::string& pattern) {
    return [&files, pattern] {
      ShaderSelection selection;
      selection.include = {pattern};
      find_shader_files(files.path(), selection);
    };
  };
  expect_input_error(with("Assets/Wtaer/**"),
                     AllOf(HasSubstr("--only 'Assets/Wtaer/**' matches no shader file"),
                           HasSubstr("did you mean 'Assets/Water/**'?")));
  expect_input_error(with("Assets/Water/b.shader"), HasSubstr("did you mean 'Assets/Water/a.shader'?"));
  expect_input_error(with("cc.shader"), HasSubstr("did you mean 'c.shader'?"));
  expect_input_error(with("zzzzzzzzzz/**"),
                     HasSubstr("there are: Assets/**, Assets/Fire/**, Assets/Water/**"));
}

TEST(ShaderFiles, AProjectWithoutShadersIsRefused) {
  const ProjectFolder files;
  files.write("Assets/a.cs", "");
  expect_input_error([&] { find_shader_files(files.path(), {}); },
                     HasSubstr("has no shader file to validate"));
  ShaderSelection selection;
  selection.places = {files.path() / "Assets"};
  expect_input_error([&] { find_shader_files({}, selection); },
                     HasSubstr((files.path() / "Assets").string() + ": has no shader file to validate"));
}

TEST(ShaderFiles, NamedPlacesStandForThemselves) {
  const ProjectFolder files;
  for (const char* name :
       {"Assets/a.shader", "Assets/Samples~/b.shader", "Assets/Samples~/lib.hlsl", "x/c.compute"})
    files.write(name, "");
  ShaderSelection selection;
  selection.places = {files.path("Assets/Samples~"), files.path("Assets/Samples~/lib.hlsl"), files.path("x"),
                      files.path("Assets/Samples~/b.shader")};
  EXPECT_THAT(shown(find_shader_files(files.path(), selection)),
              ElementsAre("Assets/Samples~/b.shader", "Assets/Samples~/lib.hlsl", "x/c.compute"));
  EXPECT_THAT(shown(find_shader_files({}, selection)),
              ElementsAre(files.text("Assets/Samples~/b.shader"), files.text("Assets/Samples~/lib.hlsl"),
                          files.text("x/c.compute")));
}

TEST(ShaderFiles, PlaceThatIsNoneIsBadInput) {
  const ProjectFolder files;
  files.write("readme.txt", "");
  ShaderSelection selection;
  selection.places = {files.path("gone")};
  expect_input_error([&] { find_shader_files(files.path(), selection); },
                     files.text("gone") + ": no such file or folder");
  selection.places = {files.path("readme.txt")};
  expect_input_error([&] { find_shader_files(files.path(), selection); },
                     files.text("readme.txt") +
                         ": is not a shader file\n  name a folder, or a .shader, .compute or .hlsl file");
}

}  // namespace
}  // namespace penumbra::project
