// penumbra render refuses bad options before anything is drawn, and makes one small sheet from end to end.
#include <set>

#include "cli/program.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Render : public ProgramTest {
 protected:
  // Runs a small render with these options and a sheet; expects refusal with every one of the words, and no
  // file.
  void expect_refused(const Words& options, const Words& says) {
    const auto result = run(joined(small(options), {"--sheet", path("sheet.png").string()}));
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    for (const std::string& part : says) EXPECT_THAT(result.errors, HasSubstr(part));
    EXPECT_THAT(listing(), IsEmpty());
  }

  Words small(const Words& options) const {
    return joined(words("render --map-size 512 --reference-samples 32 --scene slabs",
                        {"--size", size_, "--cache", path("cache").string()}),
                  options);
  }

  std::string drawn(const std::string& folder, const Words& options, const std::string& file) {
    const auto result = expect_success(joined(small(options), {"-o", path(folder).string()}));
    EXPECT_THAT(result.output, HasSubstr(folder));
    return read(folder + "/" + file);
  }

  // The sheet that the options draw.
  std::string sheet(const Words& options, const std::string& name = "sheet.png") {
    expect_success(joined(small(options), {"--sheet", path(name).string()}));
    return read(name);
  }

  std::string size_ = "64x36";
};

// Width and height from a PNG's header.
std::pair<int, int> png_size(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(png.at(i));
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(Render, TheScaleOfABuiltInSceneIsItsOwn) {
  for (const char* option : {"--metres-per-unit=0.01", "--height=3", "--z-up", "--no-ground"})
    expect_refused({option}, {std::string(option).substr(0, std::string(option).find('=')),
                              "every scene is a built-in one"});
}

TEST_F(Render, ABakesOptionIsRefusedWhereNoTechniqueReadsIt) {
  const auto refused = [&](const std::string& technique, const std::string& option) {
    expect_refused({"--technique", technique, option, "64"},
                   {option + " has no effect on techniques that read no"});
  };
  for (const char* option : {"--ground-samples", "--horizon-texels", "--field-voxels"})
    refused("hard", option);
  refused("pcss-angular-24-16-far-heights", "--horizon-texels");
  refused("pcss-angular-24-16-far-horizon", "--field-voxels");
  // Both runs end at a device that is not there.
  const auto taken = [&](const std::string& technique, const std::string& option) {
    const auto result =
        run(small({"--technique", technique, option, "64", "--device", "no device has this name"}));
    EXPECT_THAT(result.errors, AllOf(HasSubstr("no device has this name"), Not(HasSubstr("has no effect"))));
  };
  taken("hard,pcss-angular-24-16-far-horizon", "--ground-samples");
  taken("pcss-angular-24-16-far-horizon", "--horizon-texels");
  taken("distance-field-soft", "--field-voxels");
}

TEST_F(Render, AnUnknownParameterNamesTheTechniqueTheNearestAndAll) {
  expect_refused({"--technique", "screen-pcss-angular-24-16-masked", "--set", "blockerSample=4"},
                 {"technique 'screen-pcss-angular-24-16-masked' has no parameter 'blockerSample'",
                  "did you mean 'blockerSamples'?", "maskPenumbraMetres"});
  expect_refused({"--technique", "pcss-angular-24-16", "--technique", "tent-5", "--set", "blockerSamples=4"},
                 {"technique 'tent-5'", "it has no parameters"});
}

TEST_F(Render, ValuesThatAreNoneAreRefused) {
  expect_refused({"--set", "blockerSamples=129"},
                 {"'blockerSamples' is a whole number from 1 to 128, not 129"});
  expect_refused({"--set", "blockerSamples=4,2.5"}, {"not 2.5"});
  expect_refused({"--set", "minFilterTexels=wide"}, {"--set minFilterTexels", "'wide' is not a number"});
  expect_refused({"--set", "minFilterTexels=1,,2"}, {"'' is not a number"});
  expect_refused({"--set", "minFilterTexels=1,"}, {"no value after the last comma"});
  expect_refused({"--set", "minFilterTexels"}, {"--set 'minFilterTexels' is not of the form NAME=VALUE"});
  expect_refused({"--frames", "0"}, {"--frames", "1 .. 64"});
}

TEST_F(Render, AFontWithoutAnEndIsRefused) {
  const auto result =
      shell("ulimit -v 16000000; PENUMBRA_FONT=/dev/zero timeout 120 " PENUMBRA_PROGRAM
            " render --quiet --size 64x36 --map-size 512 --reference-samples 32 --technique hard --sheet " +
            path("sheet.png").string());
  EXPECT_EQ(result.exit_code, 3) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("PENUMBRA_FONT: '/dev/zero' is not a TrueType font"));
}

TEST_F(Render, WhatContradictsItselfIsRefused) {
  expect_refused({"--set", "blockerSamples=4", "--set", "blockerSamples=5"}, {"--set blockerSamples"});
  const std::string adapter = "mine=" + write("mine.hlsl", "").string();
  expect_bad_input(small({"--adapter", adapter, "--adapter", adapter}), HasSubstr("'mine' is given twice"));
}

TEST_F(Render, PicturesOfTwoAdaptersAreTwoFiles) {
  const std::string file = write("mine.hlsl", "").string();
  expect_bad_input(small({"--adapter", "a/b=" + file, "--adapter", "a-b=" + file}),
                   HasSubstr("the pictures of 'a/b' and 'a-b' would share a file"));
}

TEST_F(Render, PicturesDoNotGoToStandardOutput) {
  expect_bad_input(small({"--technique", "hard", "-o", "-"}),
                   HasSubstr("--output: pictures go into a folder"));
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST_F(Render, WhatIsAskedForTwiceIsThereOnce) {
  const std::string once = sheet({"--light", "2", "--technique", "tent-5"});
  EXPECT_FALSE(once.empty());
  EXPECT_EQ(sheet({"--light", "2,2", "--technique", "tent-5"}), once);
  EXPECT_EQ(sheet({"--light", "2", "--technique", "tent-5,tent-5"}), once);
}

TEST_F(Render, AWideSheetIsScaledDown) {
  const auto size = [&](const std::string& limit) {
    return png_size(sheet({"--technique", "tent-5", "--max-width", limit}));
  };
  const auto [width, height] = size("16384");
  ASSERT_GT(width, 100);
  EXPECT_EQ(size("100"), std::pair(100, (height * 100 + width / 2) / width));
}

TEST_F(Render, AnAdapterAloneHasNothingToSet) {
  const auto file = write("mine.hlsl", "");
  expect_bad_input(small({"--adapter", "mine=" + file.string(), "--set", "blockerSamples=4"}),
                   HasSubstrs("only adapters", "UNIFORM="));
}

TEST_F(Render, ACropLiesInThePicture) {
  expect_refused({"--crop", "32,0,33,8"}, {"--crop 32,0,33,8 extends beyond the picture of 64x36 pixels"});
  expect_refused({"--crop", "0,-1,8,8"}, {"extends beyond"});
  expect_refused({"--crop", "2147483647,0,8,8"}, {"extends beyond"});
  for (const char* crop : {"0,0,8", "0,0,0,8", "0,0,8,8,8", "wide"}) {
    expect_refused({"--crop", crop}, {"X,Y,WIDTH,HEIGHT"});
  }
}

TEST_F(Render, ASheetThatNobodyCouldOpenIsRefused) {
  size_ = "8192x8192";
  expect_refused({"--zoom", "16"}, {"million pixels", "zoom less"});
  size_ = "64x36";
  expect_refused({"--zoom", "17"}, {"--zoom", "1 .. 16"});
  expect_refused({"--show", "mask"}, {"--show mask", "named ...-masked"});
  expect_refused({"--show", "colour"}, {"--show", "fetches"});
  expect_refused({"--max-width", "63"}, {"--max-width", "64 .. 16384"});
}

TEST_F(Render, ASheetNeedsAPlaceBeforeAnythingIsDrawn) {
  expect_bad_input(small({"--sheet", path("no/sheet.png").string()}),
                   HasSubstrs("no/sheet.png", "does not exist"));
  expect_bad_input(small({"--sheet", path("").string()}), HasSubstr("is a folder"));
  EXPECT_THAT(listing(), IsEmpty());
}

TEST_F(Render, OptionsOfASheetNeedOne) {
  for (const char* option : {"--crop", "--zoom", "--columns"}) {
    expect_bad_input(small({option, "1"}), HasSubstr("--sheet"));
  }
  const auto both = run(small({"--sheet", path("sheet.png").string(), "-o", path("out").string()}));
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(listing(), IsEmpty());
}

// The sheet has the reference and two values with a mask each: five cells in three rows of two.
TEST_F(Render, OneCommandMakesASheet) {
  const auto result =
      expect_success(small({"--technique", "screen-pcss-angular-24-16-masked", "--set", "blockerSamples=1,64",
                            "--show", "result,mask", "--crop", "8,4,48,24", "--zoom", "8", "--columns", "2",
                            "--sheet", path("sheet.png").string()}));
  EXPECT_EQ(result.output, path("sheet.png").string() + "\n");
  EXPECT_THAT(listing(), testing::UnorderedElementsAre("cache", "sheet.png"));
  const auto [width, height] = png_size(read("sheet.png"));
  EXPECT_EQ(width, 2 * (48 * 8 + 8) + 8);
  EXPECT_GT(height, 3 * 24 * 8);
  EXPECT_LT(height, 4 * 24 * 8);
}

TEST_F(Render, ATitleIsOfWhatIsThere) {
  expect_refused(
      {"--technique", "tent-5", "--title", "tent-7=Wide"},
      {"--title tent-7=Wide: no technique or adapter is named 'tent-7'", "the names are 'tent-5'"});
  expect_refused({"--title", "Wide"}, {"--title 'Wide' is not of the form NAME=VALUE"});
  expect_refused({"--adapters", "middle"}, {"--adapters", "last"});
}

// Each caption is the one that the title asks for.
TEST_F(Render, CaptionsAreTitlesNotNames) {
  EXPECT_EQ(sheet({"--technique", "tent-3-plane,preset-high"}),
            sheet({"--technique", "tent-3-plane,preset-high", "--title",
                   "tent-3-plane=Tent 3x3, receiver plane", "--title", "preset-high=Penumbra High"}));
  const Words set{"--technique", "preset-low", "--set", "maxPenumbraMetres=2"};
  EXPECT_EQ(sheet(set), sheet(joined(set, {"--title",
                                           "preset-low maxPenumbraMetres=2=Penumbra Low "
                                           "maxPenumbraMetres=2"})))
      << "one value alone leaves the technique its title";
}

TEST_F(Render, AdaptersStandWhereTheyAreAskedToUnderTheirTitles) {
  const auto file =
      write("mine.hlsl", "float ShadowVisibility(float3 p, float3 n, float2 xy) { return 0.25; }\n");
  const Words both{"--technique", "hard", "--adapter", "mine=" + file.string()};
  const std::string last = sheet(both);
  EXPECT_EQ(sheet(joined(both, {"--adapters", "last", "--title", "mine=mine"})), last);
  EXPECT_NE(sheet(joined(both, {"--adapters", "first"})), last);
  EXPECT_NE(sheet(joined(both, {"--title", "mine=My own"})), last);
}

TEST_F(Render, AnInsetLiesInWhatIsShownAndFitsBeneathIt) {
  expect_refused({"--inset", "60,0,8,8"}, {"--inset 60,0,8,8 extends beyond what is shown, 64x36 pixels"});
  expect_refused({"--crop", "8,8,32,16", "--inset", "0,0,8,8"}, {"extends beyond", "32x16 pixels from 8,8"});
  expect_refused({"--inset", "wide"}, {"--inset 'wide'", "X,Y,WIDTH,HEIGHT"});
  expect_refused({"--inset", "0,0,32,8", "--inset", "0,8,32,8"}, {"too wide", "fewer or smaller"});
  expect_refused({"--reference", "middle"}, {"--reference", "last"});
}

TEST_F(Render, ASheetIsAPngOrAJpegByItsName) {
  for (const char* name : {"sheet.gif", "sheet", "sheet.png.txt"}) {
    expect_bad_input(small({"--sheet", path(name).string()}), HasSubstr("neither .png nor .jpg"));
  }
  EXPECT_THAT(listing(), IsEmpty());
  expect_success(small({"--technique", "hard", "--sheet", path("sheet.JPG").string()}));
  EXPECT_TRUE(read("sheet.JPG").starts_with("\xFF\xD8\xFF"));
}

TEST_F(Render, OptionsOfTheLitViewNeedIt) {
  for (const char* option : {"--supersampling", "--exposure"}) {
    expect_refused({option, "1"}, {"--lit"});
  }
  expect_refused({"--lit", "--supersampling", "5"}, {"--supersampling", "1 .. 4"});
  size_ = "4100x2000";
  expect_refused({"--lit"}, {"4100x2000", "8192", "--supersampling 1"});
}

TEST_F(Render, ALitSheetHasTheSizeOfOneWithoutLightAndTwiceTheSameBytes) {
  const std::string options = "--technique hard --columns 2 --inset 30,18,12,8";
  const std::string plain = sheet(words(options));
  const std::string lit = sheet(words(options + " --lit"));
  EXPECT_EQ(png_size(lit), png_size(plain));
  EXPECT_NE(lit, plain);
  EXPECT_EQ(sheet(words(options + " --lit")), lit);
  EXPECT_NE(sheet(words(options + " --lit --exposure 1")), lit);
}

TEST_F(Render, DebugViewsAreOfTechniquesOverTheScreen) {
  expect_refused({"--technique", "tent-5", "--show", "cascades"},
                 {"--show cascades: no technique of this sheet runs as a screen pass",
                  "the presets and the techniques named screen-... do"});
  expect_refused({"--technique", "preset-low", "--show", "cascade"}, {"--show", "cascades"});
}

TEST_F(Render, EveryDebugViewIsAnotherPicture) {
  std::set<std::string> sheets;
  for (const char* view : {"visibility", "cascades", "shadow-texels", "penumbra-width", "penumbra-mask"}) {
    sheets.insert(sheet({"--technique", "preset-low", "--show", view}));
  }
  EXPECT_EQ(sheets.size(), 5);
}

TEST_F(Render, AValueReachesTheShaderAndItsOwnChangesNothing) {
  const std::string own = drawn("own", {}, "slabs_pcss-angular-24-16_2_result.png");
  const std::string same = drawn("same", {"--set", "blockerSamples=24"},
                                 "slabs_pcss-angular-24-16-blockerSamples-24_2_result.png");
  const std::string other =
      drawn("other", {"--set", "blockerSamples=1"}, "slabs_pcss-angular-24-16-blockerSamples-1_2_result.png");
  EXPECT_THAT(own, Not(IsEmpty()));
  EXPECT_EQ(own, same);
  EXPECT_NE(own, other);
}

}  // namespace
}  // namespace penumbra
