// Packages that do not fit each other are said before a compiler trips over them.
#include "project/package_version.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "project_folder.h"

namespace penumbra::project {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* core = "com.unity.render-pipelines.core";
constexpr const char* universal = "com.unity.render-pipelines.universal";
constexpr const char* config = "com.unity.render-pipelines.universal-config";

TEST(PackageVersions, PipelinePackagesOfOneReleaseFit) {
  const ProjectFolder files;
  files.package("core", core, "14.0.9", R"("com.unity.ugui": "1.0.0", "com.unity.modules.physics": "1.0.0")");
  files.package("urp", universal, "14.0.9",
                R"("com.unity.burst": "1.8.9", "com.unity.render-pipelines.core": "14.0.9")");
  EXPECT_THAT(version_problems({{core, files.path("core")}, {universal, files.path("urp")}}), IsEmpty());
}

TEST(PackageVersions, AnotherPatchIsAWarningAtTheDependency) {
  const ProjectFolder files;
  files.package("core", core, "14.0.11");
  files.package("urp", universal, "14.0.9", R"("com.unity.render-pipelines.core": "14.0.9")");
  EXPECT_THAT(formatted(version_problems({{core, files.path("core")}, {universal, files.path("urp")}})),
              ElementsAre(files.text("urp/package.json") +
                          ":4:20: warning: com.unity.render-pipelines.universal 14.0.9 needs "
                          "com.unity.render-pipelines.core 14.0.9, but " +
                          files.text("core") +
                          " is 14.0.11; packages of Unity's render pipelines fit only at the same release, "
                          "and errors such as "
                          "\"redefinition\" or an unknown 'Pow2' may follow from this; give --package-root "
                          "com.unity.render-pipelines.core=DIR with version 14.0.9"));
}

TEST(PackageVersions, PreviewsOfOneReleaseFit) {
  const ProjectFolder files;
  files.package("core", core, "9.0.0-preview.13");
  files.package("urp", universal, "9.0.0-preview.14",
                R"("com.unity.render-pipelines.core": "9.0.0-preview.12")");
  EXPECT_THAT(version_problems({{core, files.path("core")}, {universal, files.path("urp")}}), IsEmpty());
}

TEST(PackageVersions, ConfigMayDifferInItsPatch) {
  const ProjectFolder files;
  const std::vector<PackageRoot> roots{{config, files.path("config")}, {universal, files.path("urp")}};
  files.package("urp", universal, "14.0.12", R"("com.unity.render-pipelines.universal-config": "14.0.9")");
  files.package("config", config, "14.0.10");
  EXPECT_THAT(version_problems(roots), IsEmpty());
  files.package("config", config, "15.0.9");
  EXPECT_THAT(formatted(version_problems(roots)),
              ElementsAre(HasSubstr(files.text("config") + " is 15.0.9; ")));
}

TEST(PackageVersions, MissingPipelinePackageIsAWarning) {
  const ProjectFolder files;
  files.package("urp", universal, "14.0.9",
                R"("com.unity.burst": "1.8.9", "com.unity.render-pipelines.core": "14.0.9")");
  EXPECT_THAT(formatted(version_problems({{universal, files.path("urp")}})),
              ElementsAre(files.text("urp/package.json") +
                          ":4:48: warning: com.unity.render-pipelines.universal 14.0.9 needs "
                          "com.unity.render-pipelines.core 14.0.9, but no package root is given for it; give "
                          "--package-root com.unity.render-pipelines.core=DIR with version 14.0.9"));
}

TEST(PackageVersions, OtherDependenciesAreLowestVersions) {
  const ProjectFolder files;
  const std::vector<PackageRoot> roots{{"com.x.a", files.path("a")}, {universal, files.path("urp")}};
  files.package("a", "com.x.a", "1.0.0", R"("com.unity.render-pipelines.universal": "12.0.0")");
  files.package("urp", universal, "14.0.9");
  EXPECT_THAT(version_problems(roots), IsEmpty());
  files.package("urp", universal, "10.10.1");
  EXPECT_THAT(
      formatted(version_problems(roots)),
      ElementsAre(files.text("a/package.json") +
                  ":4:20: warning: com.x.a 1.0.0 needs com.unity.render-pipelines.universal 12.0.0, but " +
                  files.text("urp") +
                  " is 10.10.1; give --package-root com.unity.render-pipelines.universal=DIR with version "
                  "12.0.0 or newer"));
}

TEST(PackageVersions, RootOfAnotherPackageIsSaid) {
  const ProjectFolder files;
  files.package("urp", universal, "14.0.9");
  EXPECT_THAT(
      formatted(version_problems({{core, files.path("urp")}})),
      ElementsAre(files.text("urp/package.json") +
                  ": warning: the package is 'com.unity.render-pipelines.universal', but its folder is given "
                  "as 'com.unity.render-pipelines.core'"));
}

TEST(PackageVersions, RootWithoutPackageFileIsNotJudged) {
  const ProjectFolder files;
  std::filesystem::create_directories(files.path("core"));
  files.package("urp", universal, "14.0.9", R"("com.unity.render-pipelines.core": "14.0.9")");
  EXPECT_THAT(version_problems({{core, files.path("core")}, {universal, files.path("urp")}}), IsEmpty());
}

TEST(PackageVersions, BrokenPackageFileOfAGivenRootIsSaid) {
  const ProjectFolder files;
  files.write("core/package.json", "");
  EXPECT_THAT(
      formatted(version_problems({{core, files.path("core")}})),
      ElementsAre(files.text("core/package.json") + ": warning: is empty; the smallest valid content is {}"));
}

}  // namespace
}  // namespace penumbra::project
