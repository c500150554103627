// Tests what an #include names: spellings that Unity accepts, and what is said of the others.
#include "project/include_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "project_folder.h"

namespace penumbra::project {
namespace {

class IncludeSearchTest : public testing::Test {
 protected:
  IncludeSearchTest() {
    files.write("core/Lib/Math.hlsl", "");
    files.write("Assets/Shaders/Noise.hlsl", "");
    files.write("Assets/Shaders/Inner/Main.shader", "");
    roots.packages = {{"com.x.core", files.path("core")}};
    roots.project = files.path();
  }

  IncludeSearch find(const std::string& asked) const {
    return find_include(roots, asked, files.path("Assets/Shaders/Inner/Main.shader"));
  }

  // The file that is found without a warning, relative to the test's folder, or else what was said.
  std::string found(const std::string& asked) const {
    const IncludeSearch search = find(asked);
    if (!search.file) return search.problem;
    if (!search.warning.empty()) return search.warning;
    return search.file->lexically_relative(files.path()).generic_string();
  }

  ProjectFolder files;
  IncludeRoots roots;
};

TEST_F(IncludeSearchTest, EverySpellingThatUnityAccepts) {
  for (const char* asked :
       {"Packages/com.x.core/Lib/Math.hlsl", "/Packages/com.x.core/Lib/Math.hlsl",
        "Packages/com.x.core@1.2.3/Lib/Math.hlsl", "Packages/com.x.core@9.0.0-preview.13/Lib/Math.hlsl",
        "Packages\\com.x.core\\Lib\\Math.hlsl", "Packages//com.x.core//Lib/Math.hlsl",
        "./Packages/com.x.core/Lib/Math.hlsl", "Packages/com.x.core/Lib/../Lib/./Math.hlsl",
        "Packages/com.y/../com.x.core/Lib/Math.hlsl"})
    EXPECT_EQ(found(asked), "core/Lib/Math.hlsl") << asked;
  for (const char* asked : {"Assets/Shaders/Noise.hlsl", "/Assets/Shaders/Noise.hlsl", "../Noise.hlsl",
                            "..\\Noise.hlsl", ".././/Noise.hlsl", "..\\..\\Shaders/Noise.hlsl"})
    EXPECT_EQ(found(asked), "Assets/Shaders/Noise.hlsl") << asked;
}

TEST_F(IncludeSearchTest, ANameThatIsEmptyNamesNoFile) {
  EXPECT_EQ(found(""), "the #include names no file");
}

TEST_F(IncludeSearchTest, OtherCaseIsFoundWithAWarningThatNamesTheFile) {
  const auto warning = [this](const std::string& asked, const std::string& file) {
    return "'" + asked + "' names " + files.text(file) +
           " in another case; only disks that ignore case find it";
  };
  for (const char* asked : {"Packages/com.x.core/lib/math.HLSL", "packages/com.x.core/Lib/Math.hlsl",
                            "Packages/com.X.Core/Lib/Math.hlsl"})
    EXPECT_EQ(found(asked), warning(asked, "core/Lib/Math.hlsl")) << asked;
  for (const char* asked : {"../noise.hlsl", "assets/shaders/noise.hlsl"})
    EXPECT_EQ(found(asked), warning(asked, "Assets/Shaders/Noise.hlsl")) << asked;
}

TEST_F(IncludeSearchTest, ExactSpellingAnywhereComesBeforeOtherCase) {
  files.write("Assets/Shaders/Inner/COLOUR.hlsl", "");
  files.write("lib/Colour.hlsl", "");
  roots.directories = {files.path("lib")};
  EXPECT_EQ(found("Colour.hlsl"), "lib/Colour.hlsl");
}

TEST_F(IncludeSearchTest, TwoFilesThatDifferInCaseAreNotGuessedBetween) {
  files.write("core/LIB/Math.hlsl", "");
  EXPECT_EQ(
      found("Packages/com.x.core/lib/Math.hlsl"),
      "cannot find 'Packages/com.x.core/lib/Math.hlsl'; more than one file differs from it only in case: " +
          files.text("core/LIB/Math.hlsl") + ", " + files.text("core/Lib/Math.hlsl"));
  files.write("core/LIB/Only.hlsl", "");
  EXPECT_NE(find("Packages/com.x.core/lib/Only.hlsl").warning, "");
}

TEST_F(IncludeSearchTest, FoldersAboveTheRootKeepTheirCase) {
  files.write("CORE/Lib/Extra.hlsl", "");
  EXPECT_EQ(find("Packages/com.x.core/Lib/Extra.hlsl").file, std::nullopt);
}

TEST_F(IncludeSearchTest, AssetsWithoutAProjectSayWhatIsMissing) {
  roots.project.clear();
  roots.own = {files.path()};
  EXPECT_EQ(found("Assets/Shaders/Noise.hlsl"),
            "cannot find 'Assets/Shaders/Noise.hlsl'; tried " +
                files.text("Assets/Shaders/Inner/Assets/Shaders/Noise.hlsl") +
                "; name the folder that contains Assets/ with --project DIR");
}

TEST_F(IncludeSearchTest, BesideTheCompiledFileComesAfterTheIncluder) {
  files.write("Assets/Main/Own.hlsl", "");
  files.write("Assets/Main/Both.hlsl", "");
  files.write("Assets/Shaders/Inner/Both.hlsl", "");
  files.write("lib/Own.hlsl", "");
  roots.directories = {files.path("lib")};
  EXPECT_EQ(found("Own.hlsl"), "lib/Own.hlsl");
  roots.main_folder = files.path("Assets/Main");
  EXPECT_EQ(found("Own.hlsl"), "Assets/Main/Own.hlsl");
  EXPECT_EQ(found("/Own.hlsl"), "Assets/Main/Own.hlsl");
  EXPECT_EQ(found("Both.hlsl"), "Assets/Shaders/Inner/Both.hlsl");
}

TEST_F(IncludeSearchTest, APlaceIsNamedOnce) {
  roots.directories = {files.path("Assets/Shaders/Inner"), files.path("lib")};
  EXPECT_EQ(found("Gone.hlsl"), "cannot find 'Gone.hlsl'; tried " +
                                    files.text("Assets/Shaders/Inner/Gone.hlsl") + ", " +
                                    files.text("lib/Gone.hlsl"));
}

TEST_F(IncludeSearchTest, PackageWithoutARootNamesTheNearest) {
  EXPECT_EQ(found("Packages/com.x.cor@1.0.0/A.hlsl"),
            "cannot find 'Packages/com.x.cor@1.0.0/A.hlsl'; tried " +
                files.text("Assets/Shaders/Inner/Packages/com.x.cor@1.0.0/A.hlsl") +
                "; no package root is given for 'com.x.cor'; did you mean 'com.x.core'?");
}

TEST_F(IncludeSearchTest, EditorOnlyIncludeSaysWhereItShips) {
  const IncludeSearch search = find("unityCG.cginc");
  EXPECT_EQ(search.missing_editor_include, "UnityCG.cginc");
  EXPECT_EQ(search.problem,
            "cannot find 'UnityCG.cginc': it ships only with the Unity editor (Editor/Data/CGIncludes); name "
            "that folder with --cginc-root DIR");
  EXPECT_EQ(find("Assets/UnityCG.cginc").missing_editor_include, "");
  EXPECT_EQ(find("UnityCG2.cginc").missing_editor_include, "");
}

TEST_F(IncludeSearchTest, EditorOnlyIncludesOfEveryKindAreKnown) {
  for (const char* name :
       {"HLSLSupport.cginc", "UnityCG.cginc", "UnityShaderVariables.cginc", "UnityShaderUtilities.cginc",
        "UnityInstancing.cginc", "Lighting.cginc", "AutoLight.cginc", "SpeedTreeWind.cginc",
        "SpeedTreeCommon.cginc", "TerrainEngine.cginc", "Tessellation.cginc", "UnityPBSLighting.cginc",
        "UnityStandardCore.cginc", "UnityDeferredLibrary.cginc", "UnityUI.cginc", "UnitySprites.cginc",
        "UnityLegacyTextureStack.cginc", "UnityRayTracingMeshUtils.cginc"})
    EXPECT_EQ(find(name).missing_editor_include, name);
}

TEST_F(IncludeSearchTest, CgincRootIsLookedAtLast) {
  files.write("cginc/UnityCG.cginc", "");
  files.write("cginc/NotInTheTable.cginc", "");
  roots.cginc = files.path("cginc");
  EXPECT_EQ(found("UnityCG.cginc"), "cginc/UnityCG.cginc");
  EXPECT_EQ(found("NotInTheTable.cginc"), "cginc/NotInTheTable.cginc");
  EXPECT_NE(find("unitycg.cginc").warning, "");
  EXPECT_EQ(found("UnityUI.cginc"),
            "cannot find 'UnityUI.cginc' in " + files.text("cginc") +
                ", which --cginc-root names: it ships only with the Unity editor (Editor/Data/CGIncludes); "
                "is this the folder of an editor that has it?");
  files.write("Assets/Shaders/Inner/UnityCG.cginc", "");
  EXPECT_EQ(found("UnityCG.cginc"), "Assets/Shaders/Inner/UnityCG.cginc");
}

TEST_F(IncludeSearchTest, NothingOutsideOfTheRootsIsFound) {
  const ProjectFolder elsewhere;
  const std::string secret = elsewhere.write("Secret.hlsl", "").string();
  const std::string climbing =
      elsewhere.path("Secret.hlsl").lexically_relative(files.path("Assets/Shaders/Inner")).string();
  std::filesystem::create_symlink(secret, files.path("Assets/Shaders/Inner/Link.hlsl"));
  for (const std::string& asked : {secret, climbing, std::string("Link.hlsl"), elsewhere.text("secret.hlsl"),
                                   elsewhere.text("Secrets.hlsl")}) {
    const IncludeSearch search = find(asked);
    EXPECT_FALSE(search.file) << asked;
    EXPECT_THAT(search.problem, testing::HasSubstr("outside of the project")) << asked;
    EXPECT_THAT(search.problem, testing::Not(testing::HasSubstr("did you mean")))
        << "what is elsewhere is not told";
  }
  EXPECT_THAT(find("Link.hlsl").problem,
              testing::StartsWith("'Link.hlsl' leads through a symbolic link outside of the project"));
  EXPECT_FALSE(find("link.HLSL").file) << "a name that differs only in case";
  roots.main_folder = elsewhere.path();
  EXPECT_FALSE(find("Secret.hlsl").file) << "the folder of the compiled file is searched, and is no root";
  roots.directories.push_back(elsewhere.path());
  EXPECT_EQ(find(secret).file, secret);
}

TEST_F(IncludeSearchTest, AnOutsidePlaceDoesNotHideALaterOne) {
  files.write("Assets/Shaders/Inner/etc/hostname", "");
  EXPECT_EQ(found("/etc/hostname"), "Assets/Shaders/Inner/etc/hostname");
}

TEST_F(IncludeSearchTest, WhatBelongsToTheCompiledFileIsFound) {
  const ProjectFolder repository;
  const auto shader = repository.write("Shaders/Main.shader", "");
  const auto common = repository.write("Common.hlsl", "");
  IncludeRoots own;
  EXPECT_FALSE(find_include(own, "../Common.hlsl", shader).file);
  own.own.push_back(repository.path());
  EXPECT_EQ(find_include(own, "../Common.hlsl", shader).file, common);
}

}  // namespace
}  // namespace penumbra::project
