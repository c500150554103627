// Tests projects of many shapes: where each package is found, and what is said when one is not.
#include "project/unity_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/input_error_matcher.h"
#include "project_folder.h"

namespace penumbra::project {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

// The text "NAME VERSION FOLDER" of every root, with the folder relative to the test's.
std::vector<std::string> roots(const UnityProject& project, const ProjectFolder& files) {
  std::vector<std::string> texts;
  for (const PackageRoot& root : project.packages)
    texts.push_back(root.name + " " + root.version + " " +
                    root.directory.lexically_relative(files.path()).generic_string());
  return texts;
}

std::string cached(const std::string& folder) {
  return "Library/PackageCache/" + folder;
}

TEST(UnityProject, CachedPackagesAreFoundByManifest) {
  const ProjectFolder files;
  files.write("ProjectSettings/ProjectVersion.txt",
              "m_EditorVersion: 2022.3.20f1\r\nm_EditorVersionWithRevision: 2022.3.20f1 (61c2feb0970d)\r\n");
  files.manifest({R"("com.x.pipeline": "14.0.9")", R"("com.unity.modules.physics": "1.0.0")"});
  files.package(cached("com.x.core@14.0.9"), "com.x.core", "14.0.9");
  files.package(cached("com.x.pipeline@14.0.9"), "com.x.pipeline", "14.0.9", R"("com.x.core": "14.0.9")");
  files.package(cached("com.x.stale@1.0.0"), "com.x.stale", "1.0.0");
  const UnityProject project = read_project(files.path());
  ASSERT_TRUE(project.editor.has_value());
  EXPECT_EQ(project.editor->text, "2022.3.20f1");
  EXPECT_THAT(roots(project, files), ElementsAre("com.x.core 14.0.9 " + cached("com.x.core@14.0.9"),
                                                 "com.x.pipeline 14.0.9 " + cached("com.x.pipeline@14.0.9")));
  EXPECT_THAT(project.problems, IsEmpty());
}

// Messages quote files of the project, and a checkout may hold links to anywhere.
TEST(UnityProject, FilesOfTheProjectAreNoLinksToOutside) {
  for (const char* name :
       {"ProjectSettings/ProjectVersion.txt", "Packages/manifest.json", "Packages/packages-lock.json"}) {
    const ProjectFolder files;
    const ProjectFolder elsewhere;
    elsewhere.write("secret", "m_EditorVersion: \"s3cr3t\"");
    files.manifest({});
    files.write("Assets/a.shader", "");
    files.write("ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2022.3.20f1\n");
    std::filesystem::remove(files.path(name));
    std::filesystem::create_symlink(elsewhere.path("secret"), files.path(name));
    expect_input_error(
        [&] { read_project(files.path()); },
        testing::AllOf(HasSubstr(std::string(name) + ": is a symbolic link to outside of the project"),
                       testing::Not(HasSubstr("s3cr3t"))));
  }
}

TEST(UnityProject, AGivenFolderOfAnotherVersionIsAWarningAtTheManifest) {
  const ProjectFolder files;
  files.manifest({R"("com.x.core": "14.0.9")", R"("com.x.other": "1.0.0")"});
  files.package("given", "com.x.core", "17.0.3");
  files.package("other", "com.x.other", "1.0.0");
  const std::vector<PackageRoot> given{{"com.x.core", files.path("given")},
                                       {"com.x.other", files.path("other")}};
  EXPECT_THAT(
      formatted(read_project(files.path(), given).problems),
      testing::Contains(files.text("Packages/manifest.json") +
                        ":3:5: warning: the project uses com.x.core 14.0.9, but --package-root gives " +
                        files.text("given") +
                        " with version 17.0.3: a shader that compiles with one may fail with the other; "
                        "give the folder of 14.0.9"));
  files.lock({R"("com.x.core": {"version": "17.0.3", "source": "builtin"})"});
  EXPECT_THAT(formatted(read_project(files.path(), given).problems),
              testing::Each(testing::Not(HasSubstr("the project uses"))))
      << "the lock file has settled on it";
}

TEST(UnityProject, HashNamedFoldersTellNameAndVersionInside) {
  const ProjectFolder files;
  files.manifest({R"("com.x.core": "17.0.3")"});
  files.package(cached("com.x.core@7c85b9b7bb65"), "com.x.core", "17.0.3");
  EXPECT_THAT(roots(read_project(files.path()), files),
              ElementsAre("com.x.core 17.0.3 " + cached("com.x.core@7c85b9b7bb65")));
}

TEST(UnityProject, EmbeddedIsFoundByTheNameInsideAndComesFirst) {
  const ProjectFolder files;
  files.manifest({R"("com.x.core": "file:../elsewhere")"});
  files.package("elsewhere", "com.x.core", "2.0.0");
  files.package(cached("com.x.core@3.0.0"), "com.x.core", "3.0.0");
  EXPECT_THAT(roots(read_project(files.path()), files), ElementsAre("com.x.core 2.0.0 elsewhere"));
  files.package("Packages/My Core", "com.x.core", "1.0.0");
  const UnityProject project = read_project(files.path());
  EXPECT_THAT(roots(project, files), ElementsAre("com.x.core 1.0.0 Packages/My Core"));
  EXPECT_EQ(project.packages.front().origin, PackageOrigin::embedded);
}

TEST(UnityProject, RootGivenByHandComesBeforeAll) {
  const ProjectFolder files;
  files.manifest({R"("com.x.gone": "1.0.0")", R"("com.x.core": "1.0.0")"});
  files.package("Packages/core", "com.x.core", "1.0.0");
  files.package("mine", "com.x.core", "9.0.0", R"("com.x.deep": "1.0.0")");
  files.package(cached("com.x.deep@1.0.0"), "com.x.deep", "1.0.0");
  const UnityProject project =
      read_project(files.path(), {{"com.x.core", files.path("mine")}, {"com.x.gone", files.path()}});
  EXPECT_THAT(roots(project, files),
              ElementsAre("com.x.core 9.0.0 mine", "com.x.deep 1.0.0 " + cached("com.x.deep@1.0.0"),
                          "com.x.gone  ."));
  EXPECT_THAT(warnings_of(project.problems),
              ElementsAre(HasSubstr("the project uses com.x.core 1.0.0, but")));
}

TEST(UnityProject, LocalPathsMayBeAbsoluteOrHaveBackslashes) {
  const ProjectFolder files;
  files.package("a", "com.x.a", "1.0.0");
  files.package("b/c", "com.x.b", "1.0.0");
  files.package("d", "com.x.d", "1.0.0");
  files.manifest({R"("com.x.a": "file:)" + files.text("a") + "\"", R"("com.x.b": "file:..\\b\\c")",
                  R"("com.x.d": "file://)" + files.text("d") + "\""});
  const UnityProject project = read_project(files.path());
  EXPECT_THAT(roots(project, files), ElementsAre("com.x.a 1.0.0 a", "com.x.b 1.0.0 b/c", "com.x.d 1.0.0 d"));
  EXPECT_EQ(project.packages.front().origin, PackageOrigin::local);
  EXPECT_THAT(warnings_of(project.problems), IsEmpty());
}

TEST(UnityProject, GitPackageAndTarballAreInTheCache) {
  const ProjectFolder files;
  files.manifest({R"("com.x.git": "https://example.com/x.git#v1")", R"("com.x.tar": "file:../x.tgz")"});
  files.lock({R"("com.x.git": {"version": "https://example.com/x.git#v1", "depth": 0, "source": "git",)"
              R"( "dependencies": {}, "hash": "24c1c38f35bd3111c1b7962ef92870bf5748f875"})"});
  files.package(cached("com.x.git@24c1c38f35"), "com.x.git", "1.0.0");
  files.package(cached("com.x.git@ffffffffff"), "com.x.git", "2.0.0");
  files.package(cached("com.x.tar@123456789abc"), "com.x.tar", "1.0.0");
  const UnityProject project = read_project(files.path());
  EXPECT_THAT(roots(project, files), ElementsAre("com.x.git 1.0.0 " + cached("com.x.git@24c1c38f35"),
                                                 "com.x.tar 1.0.0 " + cached("com.x.tar@123456789abc")));
  EXPECT_THAT(warnings_of(project.problems), IsEmpty());
}

TEST(UnityProject, OfSeveralVersionsTheLockedOneIsTakenThenTheRequested) {
  const ProjectFolder files;
  files.package(cached("com.x.core@1.0.0"), "com.x.core", "1.0.0");
  files.package(cached("com.x.core@1.10.0"), "com.x.core", "1.10.0");
  files.package(cached("com.x.core@1.9.0"), "com.x.core", "1.9.0");
  files.manifest({R"("com.x.core": "1.0.0")"});
  EXPECT_THAT(roots(read_project(files.path()), files),
              ElementsAre("com.x.core 1.0.0 " + cached("com.x.core@1.0.0")));
  files.lock({R"("com.x.core": {"version": "1.9.0", "source": "registry"})"});
  const UnityProject project = read_project(files.path());
  EXPECT_THAT(roots(project, files), ElementsAre("com.x.core 1.9.0 " + cached("com.x.core@1.9.0")));
  EXPECT_THAT(warnings_of(project.problems), IsEmpty());
}

TEST(UnityProject, OfSeveralUnnamedVersionsTheHighestIsTakenWithANote) {
  const ProjectFolder files;
  files.package(cached("com.x.core@1.10.0"), "com.x.core", "1.10.0");
  files.package(cached("com.x.core@1.9.0"), "com.x.core", "1.9.0");
  files.manifest({R"("com.x.core": "1.8.0")"});
  files.write("ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2022.3.1f1\n");
  const UnityProject project = read_project(files.path());
  EXPECT_THAT(roots(project, files), ElementsAre("com.x.core 1.10.0 " + cached("com.x.core@1.10.0")));
  EXPECT_THAT(formatted(project.problems),
              ElementsAre(files.text("Packages/manifest.json") +
                          ":3:5: note: Library/PackageCache holds 'com.x.core' 2 times (com.x.core@1.10.0, "
                          "com.x.core@1.9.0) and nothing says which is meant; the highest version is used, "
                          "com.x.core@1.10.0"));
}

TEST(UnityProject, LockedVersionThatTheCacheLacksIsAWarning) {
  const ProjectFolder files;
  files.package(cached("com.x.core@14.0.12"), "com.x.core", "14.0.12");
  files.manifest({R"("com.x.core": "14.0.8")"});
  files.lock({R"("com.x.core": {"version": "14.0.8", "source": "builtin"})"});
  EXPECT_THAT(warnings_of(read_project(files.path()).problems),
              ElementsAre(files.text("Packages/manifest.json") +
                          ":3:5: warning: packages-lock.json says 'com.x.core' 14.0.8, which "
                          "Library/PackageCache does not hold; com.x.core@14.0.12 is used; open the project "
                          "once in the Unity editor that it is for"));
}

TEST(UnityProject, DependencyThatIsNowhereNamesItsLineAndTheRemedy) {
  const ProjectFolder files;
  files.manifest({R"("com.x.core": "1.0.0")", R"("com.x.gone": "2.0.0")", R"("com.x.here": "file:../here")"});
  files.package(cached("com.x.core@1.0.0"), "com.x.core", "1.0.0");
  files.package(cached("com.x.here@1.0.0"), "com.x.here", "1.0.0");  // "file:" does not ask for this one
  EXPECT_THAT(
      warnings_of(read_project(files.path()).problems),
      ElementsAre(
          files.text("Packages/manifest.json") +
              ":4:5: warning: 'com.x.gone' (2.0.0) was not found: it is neither embedded in Packages/ nor in "
              "Library/PackageCache; open the project once in the Unity editor, or give --package-root "
              "com.x.gone=DIR",
          files.text("Packages/manifest.json") +
              ":5:5: warning: 'com.x.here' (file:../here) was not found: there is no folder " +
              files.text("here") +
              "; open the project once in the Unity editor, or give --package-root com.x.here=DIR"));
}

TEST(UnityProject, WithoutACacheOneWarningNamesWhatIsMissing) {
  const ProjectFolder files;
  std::vector<std::string> dependencies{R"("com.unity.modules.ui": "1.0.0")"};
  for (const char c : std::string("abcdefgh"))
    dependencies.push_back(std::string("\"com.x.") + c + "\": \"1.0.0\"");
  files.manifest(dependencies);
  EXPECT_THAT(
      warnings_of(read_project(files.path()).problems),
      ElementsAre(
          files.text("Packages/manifest.json") +
          ":4:5: warning: 8 packages were not found, because the project has no Library/PackageCache: "
          "com.x.a, com.x.b, com.x.c, com.x.d, com.x.e, com.x.f and 2 more; open the project once in "
          "the Unity editor, or give --package-root NAME=FOLDER for each that the shaders include"));
}

TEST(UnityProject, WithoutManifestAllOfTheCacheCounts) {
  const ProjectFolder files;
  std::filesystem::create_directories(files.path("Assets"));
  files.package(cached("com.x.a@1.0.0"), "com.x.a", "1.0.0");
  files.write(cached("no package at all") + "/readme.txt", "");
  EXPECT_THAT(roots(read_project(files.path()), files),
              ElementsAre("com.x.a 1.0.0 " + cached("com.x.a@1.0.0")));
}

TEST(UnityProject, BrokenPackageInTheCacheGoesByItsFolder) {
  const ProjectFolder files;
  files.manifest({R"("com.x.a": "1.2.3")"});
  files.write(cached("com.x.a@1.2.3") + "/package.json", "{\n  \"name\": \"com.x.a\",\n  oops\n}");
  const UnityProject project = read_project(files.path());
  EXPECT_THAT(roots(project, files), ElementsAre("com.x.a 1.2.3 " + cached("com.x.a@1.2.3")));
  EXPECT_THAT(warnings_of(project.problems),
              ElementsAre(HasSubstr(cached("com.x.a@1.2.3") + "/package.json:3:3: warning: not valid JSON")));
}

TEST(UnityProject, BrokenEmbeddedPackagesAreErrorsAsInUnity) {
  const ProjectFolder files;
  files.package("Packages/a", "com.x.a", "1.0.0");
  files.package("Packages/b", "com.x.a", "2.0.0");
  files.write("Packages/c/package.json", "{\"version\": \"1.0.0\"}");
  files.write("Packages/d/package.json", "{\"name\": 3}");
  const UnityProject project = read_project(files.path());
  EXPECT_THAT(roots(project, files), ElementsAre("com.x.a 1.0.0 Packages/a"));
  EXPECT_THAT(warnings_of(project.problems),
              ElementsAre(files.text("Packages/b/package.json") + ": warning: 'com.x.a' is embedded twice; " +
                              files.text("Packages/a") + " is used",
                          files.text("Packages/c/package.json") +
                              ": error: has no 'name', so Unity does not load the package",
                          files.text("Packages/d/package.json") +
                              ":1:2: error: 'name' must be a string, found a number"));
}

TEST(UnityProject, LocalPackageOfAnotherNameIsAWarning) {
  const ProjectFolder files;
  files.manifest({R"("com.x.a": "file:../b")"});
  files.package("b", "com.x.b", "1.0.0");
  EXPECT_THAT(
      warnings_of(read_project(files.path()).problems),
      ElementsAre(files.text("Packages/manifest.json") + ":3:5: warning: 'com.x.a' is required, but " +
                  files.text("b") + " holds the package 'com.x.b'; correct the name or the path"));
}

TEST(UnityProject, EditorVersionThatCannotBeReadIsSaid) {
  const ProjectFolder files;
  std::filesystem::create_directories(files.path("Assets"));
  const std::string file = files.text("ProjectSettings/ProjectVersion.txt");
  EXPECT_THAT(formatted(read_project(files.path()).problems),
              ElementsAre(file + ": note: is missing or empty; the project's UNITY_VERSION is not known"));
  files.write("ProjectSettings/ProjectVersion.txt", "m_Version: 1\n");
  EXPECT_THAT(formatted(read_project(files.path()).problems),
              ElementsAre(file + ": note: has no m_EditorVersion; the project's UNITY_VERSION is not known"));
  files.write("ProjectSettings/ProjectVersion.txt", "\nm_EditorVersion: latest\n");
  EXPECT_THAT(
      formatted(read_project(files.path()).problems),
      ElementsAre(file +
                  ":2: warning: 'latest' is not an editor version like 2022.3.20f1; UNITY_VERSION is not "
                  "known\n    m_EditorVersion: latest"));
}

TEST(UnityProject, WhatIsNoProjectIsBadInput) {
  const ProjectFolder files;
  expect_input_error([&] { read_project(files.path("gone")); }, files.text("gone") + ": no such folder");
  expect_input_error([&] { read_project(files.path()); },
                     files.text("") +
                         ": is not a Unity project: it contains neither Assets/ nor Packages/\n"
                         "  name the folder that contains Assets/");
  files.write("file", "");
  expect_input_error([&] { read_project(files.path("file")); },
                     files.text("file") + ": is a file, not the folder of a project");
}

TEST(UnityProject, BrokenManifestOrLockIsBadInput) {
  const ProjectFolder files;
  const std::string manifest = files.text("Packages/manifest.json");
  files.write("Packages/manifest.json", "{\n  \"dependencies\": {\n    \"com.x\": 3\n  }\n}");
  expect_input_error([&] { read_project(files.path()); },
                     manifest + ":3:5: 'com.x' must be a string, found a number");
  files.write("Packages/manifest.json", "{\n  \"dependencies\": [\n");
  expect_input_error([&] { read_project(files.path()); }, HasSubstr(manifest + ":3:1: not valid JSON"));
  files.write("Packages/manifest.json", "[]");
  expect_input_error([&] { read_project(files.path()); },
                     HasSubstr("expected an object { ... }, found an array"));
  std::filesystem::remove(manifest);
  files.write("Packages/packages-lock.json", "{\"dependencies\": {\"com.x\": \"1.0.0\"}}");
  expect_input_error(
      [&] { read_project(files.path()); },
      files.text("Packages/packages-lock.json") + ":1:19: 'com.x' must be an object { ... }, found a string");
}

TEST(UnityProject, FolderThatCannotBeListedIsBadInput) {
  const ProjectFolder files;
  files.write("Assets/a.txt", "");
  files.write("Library/PackageCache", "a file");
  expect_input_error([&] { read_project(files.path()); },
                     HasSubstr(files.text("Library/PackageCache") + ": cannot be listed: "));
  std::filesystem::remove(files.path("Library/PackageCache"));
  files.write("Packages", "a file");
  expect_input_error([&] { read_project(files.path()); },
                     HasSubstr(files.text("Packages") + ": cannot be listed: "));
  std::filesystem::remove(files.path("Packages"));
  std::filesystem::create_directories(files.path("Packages/manifest.json"));
  expect_input_error([&] { read_project(files.path()); },
                     files.text("Packages/manifest.json") + ": is a folder, not a file");
}

TEST(UnityProject, DependenciesInACircleEnd) {
  const ProjectFolder files;
  files.package("Packages/a", "com.x.a", "1.0.0", R"("com.x.b": "1.0.0", "com.x.a": "1.0.0")");
  files.package(cached("com.x.b@1.0.0"), "com.x.b", "1.0.0", R"("com.x.a": "1.0.0")");
  EXPECT_THAT(roots(read_project(files.path()), files),
              ElementsAre("com.x.a 1.0.0 Packages/a", "com.x.b 1.0.0 " + cached("com.x.b@1.0.0")));
}

// A project from elsewhere names no folder of this machine.
TEST(UnityProject, PackagesOutsideOfProjectAndRepositoryAreLeftOut) {
  const ProjectFolder files;
  namespace fs = std::filesystem;
  files.package("outside/a", "com.x.a", "1.0.0");
  files.package("outside/b", "com.x.b", "1.0.0");
  files.package("outside/cache/com.x.c@1.0.0", "com.x.c", "1.0.0");
  files.write("p/Packages/manifest.json",
              R"({"dependencies": {"com.x.a": "file:../../outside/a", "com.x.c": "1.0.0"}})");
  fs::create_directory_symlink(files.path("outside/b"), files.path("p/Packages/b"));
  fs::create_directories(files.path("p/Library"));
  fs::create_directory_symlink(files.path("outside/cache"), files.path("p/Library/PackageCache"));
  const UnityProject project = read_project(files.path("p"));
  EXPECT_THAT(project.packages, IsEmpty());
  EXPECT_THAT(warnings_of(project.problems),
              UnorderedElementsAre(HasSubstr("'com.x.a' lies outside of the project and its repository"),
                                   HasSubstr("'b' lies outside"), HasSubstr("give --package-root com.x.c="),
                                   HasSubstr("'com.x.c' (1.0.0) was not found")));
  EXPECT_THAT(read_project(files.path("p"), {{"com.x.a", files.path("outside/a")}}).packages, SizeIs(1));
  files.write(".git/HEAD", "ref: refs/heads/main");
  EXPECT_THAT(read_project(files.path("p")).packages, SizeIs(3));
}

}  // namespace
}  // namespace penumbra::project
