// The program bakes heights and horizons, keeps what is finished, and refuses what it cannot bake.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class BakeProgram : public ProgramTest {
 protected:
  std::string file(const std::string& name) const { return path(name).string(); }

  platform::ChildResult bake(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "bake");
    arguments.insert(arguments.end(), {"--cache", file("cache")});
    return run(std::move(arguments));
  }

  void expect_refused(const std::vector<std::string>& arguments,
                      const testing::Matcher<std::string>& says) const {
    const auto before = listing();
    const auto result = bake(arguments);
    EXPECT_EQ(result.exit_code, 2) << testing::PrintToString(arguments) << result.errors;
    EXPECT_THAT(result.errors, says) << testing::PrintToString(arguments);
    EXPECT_EQ(listing(), before);
  }

  std::string heights_of_street() const {
    const auto result =
        bake({"heightfield", "--scene", "street", "--samples", "65x33", "-o", file("street.json")});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return file("street.json");
  }
};

TEST_F(BakeProgram, AHorizonFromAHeightFieldIsThatFromItsScene) {
  const std::string field = heights_of_street();
  const auto from_field = bake({"horizon", "--field", field, "--texels", "16x8", "-o", file("a.json")});
  EXPECT_EQ(from_field.exit_code, 0) << from_field.errors;
  EXPECT_EQ(from_field.output, file("a.json") + "\n" + file("a-0.png") + "\n" + file("a-1.png") + "\n");
  const auto again = bake({"horizon", "--field", field, "--texels", "16x8", "-j", "1", "-o", file("b.json")});
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_EQ(read("a-0.png"), read("b-0.png"));
  EXPECT_EQ(read("a-1.png"), read("b-1.png"));
  const auto other = bake({"horizon", "--scene", "street", "--samples", "65x33", "--texels", "16x8",
                           "--nearest", "20", "-o", file("c.json")});
  EXPECT_EQ(other.exit_code, 0) << other.errors;
  EXPECT_NE(read("a-0.png"), read("c-0.png")) << "nothing nearer than 20 m";
}

// A RAW file with its rows in the other order gives the same bytes.
TEST_F(BakeProgram, ARawImageNeedsItsUnits) {
  const std::string raw = write("hill.raw", std::string("\x00\x00\xff\xff\x00\x80\x00\x40", 8)).string();
  EXPECT_EQ(
      bake({"heightfield", "--image", raw, "--heights", "0,100", "--area", "0,0,10,20", "-o", file("a.json")})
          .exit_code,
      0);
  EXPECT_THAT(read("a.json"), HasSubstrs("100.0", "20.0"));
  EXPECT_EQ(bake({"heightfield", "--image", raw, "--heights", "0,100", "--area", "0,0,10,20", "--flip-z",
                  "-o", file("b.json")})
                .exit_code,
            0);
  EXPECT_NE(read("a.png"), read("b.png"));
  expect_refused({"heightfield", "--image", raw, "-o", file("c.json")}, HasSubstrs("hill.raw", "--heights"));
  expect_refused({"heightfield", "--image", raw, "--heights", "0,9", "-o", file("c.json")},
                 HasSubstr("--area"));
}

TEST_F(BakeProgram, SaysWhatItCannotBake) {
  const std::string field = heights_of_street();
  const std::string raw = write("odd.raw", "12345").string();
  const std::vector<std::string> of_image{"--heights", "0,9", "--area", "0,0,9,9", "-o", file("x.json")};
  const auto with = [&](std::vector<std::string> first) {
    first.insert(first.end(), of_image.begin(), of_image.end());
    return first;
  };
  expect_refused({"horizon", "-o", file("x.json")}, HasSubstr("--field"));
  expect_refused({"heightfield", "-o", file("x.json")},
                 AllOf(HasSubstr("nothing to bake from"), testing::Not(HasSubstr("--field"))));
  expect_refused({"horizon", "--field", field, "--scene", "street", "-o", file("x.json")},
                 HasSubstr("several"));
  expect_refused({"heightfield", "--scene", "street", "--texels", "64", "-o", file("x.json")},
                 HasSubstr("--texels has no effect"));
  expect_refused({"horison", "--scene", "street", "-o", file("x.json")}, HasSubstr("horizon"));
  expect_refused({"horizon", "--field", field, "--area", "0,0,1,1", "-o", file("x.json")},
                 HasSubstr("--area has no effect"));
  expect_refused({"horizon", "--field", field, "--texels", "0", "-o", file("x.json")}, HasSubstr("not 0"));
  expect_refused({"horizon", "--field", field, "--texels", "16384", "-o", file("x.json")}, HasSubstr("8192"));
  expect_refused({"horizon", "--field", field, "--texels", "4by4", "-o", file("x.json")},
                 HasSubstr("'4by4'"));
  expect_refused({"horizon", "--field", raw, "-o", file("x.json")}, HasSubstr("odd.raw"));
  expect_refused({"heightfield", "--scene", "stret", "-o", file("x.json")}, HasSubstr("street"));
  expect_refused(with({"heightfield", "--image", raw}), HasSubstrs("odd.raw", "5 bytes"));
  expect_refused(with({"heightfield", "--image", file("absent.png")}), HasSubstr("absent.png"));
  expect_refused({"horizon", "--field", field, "-o", field}, HasSubstr("is a file that this run reads"));
  expect_refused({"heightfield", "--scene", "street", "-o", file("no/such/x.json")}, HasSubstr("x.json"));
  const std::string picture = file("street.png");
  expect_refused({"heightfield", "--image", picture, "--heights", "0,9", "--area", "0,0,9,9", "-o", field},
                 HasSubstr("is a file that this run reads"));
}

TEST_F(BakeProgram, RefusesNamesThatItsPicturesCouldTake) {
  for (const char* name : {"x.png", "x.js", "x", ".json"})
    expect_refused({"heightfield", "--scene", "street", "-o", file(name)}, HasSubstr(".json"));
  expect_refused({"heightfield", "--scene", "street", "-o", "-"}, HasSubstr("standard output"));
  expect_refused({"heightfield", "--scene", "street", "-o", "/dev/null"}, HasSubstr(".json"));
  expect_refused({"heightfield", "--scene", "street", "-o", file("\xff.json")}, HasSubstr("UTF-8"));
}

TEST_F(BakeProgram, SaysWhyABakeWouldBeUseless) {
  const std::string to = file("x.json");
  const std::string field = heights_of_street();
  for (const char* area : {"0,0,1e19,1e19", "1e300,0,1,1", "0,0,nan,1", "0,inf,1,1"})
    expect_refused({"horizon", "--scene", "valley-20", "--area", area, "-o", to}, HasSubstr("--area"));
  expect_refused(
      {"heightfield", "--image", file("street.png"), "--heights", "0,1e308", "--area", "0,0,9,9", "-o", to},
      HasSubstr("--heights"));
  expect_refused({"horizon", "--field", field, "--nearest", "1e5", "-o", to}, HasSubstr("--nearest"));
  expect_refused({"distance-field", "--scene", "street", "--voxels", "1", "-o", to},
                 HasSubstrs("--voxels", "2 .. 512"));
  expect_refused({"horizon", "--field", field, "--texels", "1x", "-o", to}, HasSubstr("--texels 512x256"));
  const std::string raw = write("hill.raw", std::string("\x00\x00\xff\xff\x00\x80\x00\x40", 8)).string();
  expect_refused(
      {"heightfield", "--image", raw, "--raw-size", "0x0", "--heights", "0,9", "--area", "0,0,9,9", "-o", to},
      HasSubstrs("0 x 0", "--raw-size"));
  const std::string wall = write("wall.obj", "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n").string();
  expect_refused({"heightfield", "--scene", wall, "-o", to}, HasSubstr("vertical wall"));
  const std::string large = write("large.obj", "v 0 0 0\nv 1e9 0 0\nv 0 0 1e9\nf 1 2 3\n").string();
  expect_refused({"heightfield", "--scene", large, "-o", to},
                 AllOf(HasSubstr("--metres-per-unit"), testing::Not(HasSubstr("height in metres"))));
}

// A reader that opened a pipe would wait for somebody who writes.
TEST_F(BakeProgram, ReadsOnlyRegularFiles) {
  const std::string to = file("x.json");
  const std::string field = heights_of_street();
  ASSERT_EQ(shell("cd " + file("") + " && mkfifo pipe.png pipe.raw pipe.json pipe.obj pipe.glb").exit_code,
            0);
  for (const char* name : {"pipe.png", "pipe.raw"})
    expect_refused({"heightfield", "--image", file(name), "--heights", "0,9", "--area", "0,0,9,9", "-o", to},
                   HasSubstrs(name, "is a device or a pipe"));
  expect_refused({"horizon", "--field", file("pipe.json"), "-o", to},
                 HasSubstr("pipe.json: is a device or a pipe"));
  for (const char* name : {"pipe.obj", "pipe.glb"}) {
    expect_refused({"heightfield", "--scene", file(name), "-o", to},
                   HasSubstrs(name, "is a device or a pipe"));
    expect_refused({"distance-field", "--scene", file(name), "-o", to},
                   HasSubstrs(name, "is a device or a pipe"));
  }
  // The shell's <(...) names no folder in which the pictures lie.
  const auto through = shell(std::string(PENUMBRA_PROGRAM) + " bake horizon --field <(cat " + field +
                             ") --cache " + file("cache") + " -o " + to);
  EXPECT_EQ(through.exit_code, 2) << through.errors;
  EXPECT_THAT(through.errors, HasSubstr("is a device or a pipe"));
  std::string json = read("street.json");
  for (std::size_t at = json.find("street.png"); at != std::string::npos; at = json.find("street.png"))
    json.replace(at, 10, "pipe.png");
  expect_refused({"horizon", "--field", write("named.json", json).string(), "-o", to},
                 HasSubstr("pipe.png: is a device or a pipe"));
}

TEST_F(BakeProgram, CountsSamplesWithoutASurface) {
  const std::string half = write("half.obj", "v 0 0 0\nv 4 0 0\nv 0 1 4\nf 1 3 2\n").string();
  const auto baked = bake({"heightfield", "--scene", half, "--samples", "9", "-o", file("half.json")});
  EXPECT_EQ(baked.exit_code, 0) << baked.errors;
  EXPECT_THAT(baked.errors, HasSubstrs("samples without a surface", "of 81"));
  const std::string json = read("half.json"), key = "\"samples_without_surface\": ";
  ASSERT_NE(json.find(key), std::string::npos) << json;
  const int count = std::stoi(json.substr(json.find(key) + key.size()));
  EXPECT_GT(count, 0);
  EXPECT_THAT(baked.errors, HasSubstr(": " + std::to_string(count) + " of 81"));
  EXPECT_EQ(bake({"horizon", "--field", file("half.json"), "--texels", "4", "-o", file("hz.json")}).exit_code,
            0);
  const auto all = bake(
      {"heightfield", "--scene", half, "--area", "0.5,-1.5,1,1", "--samples", "3", "-o", file("all.json")});
  EXPECT_EQ(all.exit_code, 0) << all.errors;
  EXPECT_THAT(all.errors, testing::Not(HasSubstr("without a surface")));
  EXPECT_THAT(read("all.json"), HasSubstr(key + "0"));
}

TEST_F(BakeProgram, ADistanceFieldWithoutAMarginIsNoted) {
  const std::string model =
      write("solid.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n").string();
  const auto notes = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"distance-field", "--scene", model, "--voxels", "8"});
    options.insert(options.end(), {"-o", file("solid.json")});
    const auto baked = bake(options);
    EXPECT_EQ(baked.exit_code, 0) << baked.errors;
    return baked.errors;
  };
  EXPECT_THAT(notes({"--margin", "0"}), HasSubstr("with --margin 0 the field ends at the mesh"));
  EXPECT_THAT(notes({"--margin", "0", "--quiet"}), IsEmpty());
  for (const std::vector<std::string>& other :
       {std::vector<std::string>{}, {"--margin", "0.01"}, {"--margin", "0", "--objects", "1"}})
    EXPECT_THAT(notes(other), testing::Not(HasSubstr("--margin 0"))) << testing::PrintToString(other);
}

TEST_F(BakeProgram, AFileAboveTheLimitIsAnErrorAndLeavesNothing) {
  const auto stopped = shell("ulimit -f 1; " + std::string(PENUMBRA_PROGRAM) +
                             " bake heightfield --scene street --samples 257 --cache " + file("cache") +
                             " -o " + file("x.json"));
  EXPECT_EQ(stopped.exit_code, 2) << stopped.errors;
  EXPECT_THAT(stopped.errors, HasSubstr("ulimit"));
  EXPECT_THAT(listing(), UnorderedElementsAre("cache"));
}

TEST_F(BakeProgram, FieldsOfSeveralObjectsAreOneFile) {
  const std::string solid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const std::string apart = "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\n";
  const std::string model = write("two.obj", solid + apart).string();
  const std::vector<std::string> arguments{"distance-field", "--scene", model, "--objects",     "16",
                                           "--voxels",       "16",      "-o",  file("two.json")};
  const auto both = bake(arguments);
  EXPECT_EQ(both.exit_code, 0) << both.errors;
  EXPECT_THAT(both.errors, HasSubstrs("objects: 2, of 2 parts", "not closed"));
  EXPECT_THAT(read("two.json"),
              HasSubstrs("distance-field-objects", "two.png", "\"open_edges\": 3", "\"too_thin\": 1.0"));
  EXPECT_NE(read("two.png"), "");
  expect_refused({"distance-field", "--scene", model, "--objects", "17", "-o", file("x.json")},
                 HasSubstr("16"));
  expect_refused(
      {"distance-field", "--scene", model, "--objects", "2", "--voxels", "4", "-o", file("x.json")},
      HasSubstr("8 voxels per side"));
  expect_refused({"horizon", "--scene", "street", "--objects", "2", "-o", file("x.json")},
                 HasSubstr("--objects has no effect"));
  EXPECT_FALSE(std::filesystem::exists(file("x.json")));
  EXPECT_FALSE(std::filesystem::exists(file("x.png")));
}

TEST_F(BakeProgram, DistancesOfAClosedModelAndOfAnOpenOne) {
  const std::string closed =
      write("closed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
          .string();
  const auto solid = bake({"distance-field", "--scene", closed, "--voxels", "8", "-o", file("solid.json")});
  EXPECT_EQ(solid.exit_code, 0) << solid.errors;
  EXPECT_THAT(solid.errors, testing::Not(HasSubstr("not closed")));
  EXPECT_THAT(read("solid.json"), HasSubstr("\"open_edges\": 0"));
  const std::string open =
      write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n").string();
  const auto shell = bake({"distance-field", "--scene", open, "--voxels", "8", "-o", file("shell.json")});
  EXPECT_EQ(shell.exit_code, 0) << shell.errors;
  EXPECT_THAT(shell.errors, HasSubstrs("not closed", "3 edges"));
  EXPECT_THAT(read("shell.json"), HasSubstr("\"open_edges\": 3"));
  expect_refused({"distance-field", "--scene", "street", "--voxels", "513", "-o", file("x.json")},
                 HasSubstr("512"));
  expect_refused({"distance-field", "--scene", "street", "--samples", "9", "-o", file("x.json")},
                 HasSubstr("--samples has no effect"));
  expect_refused({"distance-field", "-o", file("x.json")}, HasSubstr("give --scene"));
  expect_refused({"horizon", "--scene", "street", "--voxels", "9", "-o", file("x.json")},
                 HasSubstr("--voxels has no effect"));
}

TEST_F(BakeProgram, OfAnInterruptedOneNothingIsKept) {
  const std::string field = heights_of_street();
  const std::string command = std::string(PENUMBRA_PROGRAM) + " bake horizon --field " + field +
                              " --texels 4096 -j 1 --cache " + file("cache") + " -o " + file("hz.json");
  const auto stopped = shell("timeout -s INT 1 " + command);
  ASSERT_EQ(stopped.exit_code, 124) << "it is longer than a second: " << stopped.errors;
  EXPECT_THAT(listing(), UnorderedElementsAre("cache", "street.json", "street.png"));
  const auto kept = std::filesystem::recursive_directory_iterator(path("cache"));
  EXPECT_EQ(std::count_if(begin(kept), end(kept), [](const auto& entry) { return entry.is_regular_file(); }),
            1)
      << "the heights, which were finished";
}

}  // namespace
}  // namespace penumbra
