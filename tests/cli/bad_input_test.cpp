// Every kind of bad input is answered: exit code 2, the file and the line, the way out, and nothing left
// behind.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

class BadInput : public ProgramTest {
 protected:
  // Runs `penumbra constants --config` on the text and expects refusal with every one of the words.
  void expect_config_refused(const std::string& text, const std::vector<std::string>& words) {
    const auto file = write("config.json", text);
    const auto result = run({"constants", "--config", file.string(), "-o", path("out.json").string()});
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    for (const std::string& word : words) EXPECT_THAT(result.errors, HasSubstr(word));
    EXPECT_THAT(listing(), ElementsAre("config.json"));
  }

  void expect_matrices_refused(const std::string& matrix, const std::string& word) {
    const std::string identity = "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]";
    const auto file = write("matrices.json",
                            "{\"matrix_order\": \"row-major\", \"clip_depth\": \"zero_to_one\", "
                            "\"reversed_z\": false, \"resolution\": 1024,\n\"cascades\": [{\"view\": " +
                                identity + ",\n\"projection\": " + matrix + "}]}");
    expect_bad_input({"constants", "--matrices", file.string()}, HasSubstrs("matrices.json:3:", word));
  }
};

TEST_F(BadInput, EmptyFile) {
  expect_config_refused("", {"config.json", "empty"});
}

TEST_F(BadInput, NotJson) {
  expect_config_refused("{\n\"camera\": }", {"config.json:2:", "not valid JSON"});
}

TEST_F(BadInput, ANumberThatIsTooLarge) {
  const auto file = write("config.json", "{\"shadows\": {\n\"distance_metres\": 1e999}}");
  expect_bad_input({"constants", "--config", file.string()},
                   AllOf(HasSubstr("config.json:2:"), HasSubstr("number overflow"),
                         testing::Not(HasSubstr("json.exception"))));
}

TEST_F(BadInput, ACameraThatLooksStraightUp) {
  expect_config_refused("{\"camera\": {\n\"forward\": [0, 1, 0]}}",
                        {"camera/up is parallel to camera/forward"});
}

// The answer comes before anything is compiled or traced, because a run may take an hour.
TEST_F(BadInput, WhatAMeasurementWouldEndWithIsRefusedAtItsBeginning) {
  const auto samples = run({"measure", "--reference-samples", "100"});
  EXPECT_EQ(samples.exit_code, 2);
  EXPECT_THAT(samples.errors, HasSubstr("must be a power of two"));
  EXPECT_THAT(samples.errors, testing::Not(HasSubstr("compiling")));
}

TEST_F(BadInput, WrongType) {
  expect_config_refused("{\"shadows\": {\n\"cascades\": \"four\"}}", {"config.json:2:1", "number", "string"});
}

TEST_F(BadInput, UnknownKeyNamesTheNearest) {
  expect_config_refused("{\"shadows\": {\n  \"resoluton\": 1024}}", {"config.json:2:3", "'resolution'"});
}

TEST_F(BadInput, ZeroCascades) {
  expect_config_refused("{\"shadows\": {\n\"cascades\": 0}}", {"config.json:2:1", "cascades"});
}

TEST_F(BadInput, NegativeSizes) {
  expect_config_refused("{\"shadows\": {\n\"resolution\": -1024}}", {"config.json:2:1", "resolution"});
  expect_config_refused("{\"shadows\": {\n\"distance_metres\": -5}}", {"config.json:2:1", "distance"});
  expect_config_refused("{\"camera\": {\n\"near\": -1}}", {"config.json:2:1", "near"});
}

TEST_F(BadInput, SingularMatrix) {
  expect_matrices_refused("[1,0,0,0, 0,0,0,0, 0,0,1,0, 0,0,0,1]", "singular");
}

TEST_F(BadInput, PerspectiveMatrix) {
  expect_matrices_refused("[1,0,0,0, 0,1,0,0, 0,0,-1,-0.1, 0,0,-1,0]", "perspective");
}

TEST_F(BadInput, MissingInclude) {
  const auto file = write("shader.hlsl", "float a;\n#include \"Shadws.hlsl\"\nvoid Main() {}\n");
  write("Shadows.hlsl", "float b;\n");
  const auto result = run({"validate", file.string(), "--entry", "Main", "--stage", "compute"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output + result.errors, HasSubstrs("shader.hlsl:2:", "Shadws.hlsl", "Shadows.hlsl"));
}

TEST_F(BadInput, IncludeCycle) {
  const auto file = write("a.hlsl", "#include \"b.hlsl\"\nvoid Main() {}\n");
  write("b.hlsl", "#include \"a.hlsl\"\n");
  const auto result = run({"validate", file.string(), "--entry", "Main", "--stage", "compute"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output + result.errors, HasSubstrs("a.hlsl", "b.hlsl", "includes nest too deeply"));
}

TEST_F(BadInput, UnreadableFolder) {
  // Root may read anything, so the program runs as nobody where the tests run as root.
  const auto locked = path("locked");
  std::filesystem::create_directories(locked);
  write("locked/config.json", "{}");
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  const std::string as_nobody =
      "if [ $(id -u) -eq 0 ]; then as='setpriv --reuid=65534 --clear-groups'; fi; exec $as " PENUMBRA_PROGRAM
      " ";
  const auto input = shell(as_nobody + "constants --config " + (locked / "config.json").string());
  const auto output = shell(as_nobody + "constants -o " + (locked / "out.json").string());
  std::filesystem::permissions(locked, std::filesystem::perms::all);
  EXPECT_EQ(input.exit_code, 2);
  EXPECT_THAT(input.errors, HasSubstrs("locked/config.json", "cannot be opened"));
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_THAT(output.errors, HasSubstrs("locked/out.json", "Permission denied"));
  EXPECT_FALSE(std::filesystem::exists(locked / "out.json"));
}

TEST_F(BadInput, MissingOutputFolder) {
  expect_bad_input({"constants", "-o", path("no/such/out.json").string()},
                   HasSubstr("No such file or directory"));
}

TEST_F(BadInput, UnknownSceneAndTechniqueNameTheNearest) {
  const auto scene = run({"measure", "--scene", "contact-boxs"});
  EXPECT_EQ(scene.exit_code, 2);
  EXPECT_THAT(scene.errors, HasSubstr("contact-boxes"));
  expect_bad_input({"measure", "--scene", "contact-boxes", "--technique", "tent5"}, HasSubstr("tent-5"));
}

TEST_F(BadInput, BrokenModelFile) {
  const auto file = write("model.glb", "glTF\x02");
  expect_bad_input({"measure", "--scene", file.string()}, HasSubstr("model.glb"));
}

TEST_F(BadInput, ModelWithoutItsTextureIsMeasuredWithANote) {
  write("paint.mtl", "newmtl wood\nKd 1 1 1\nmap_Kd missing.png\n");
  const auto file = write("model.obj",
                          "mtllib paint.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n"
                          "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const auto result = expect_success(
      words("measure --size 16x16 --light 2 --technique hard --reference-samples 32 --no-split",
            {"--scene", file.string(), "--output", path("report").string()}));
  EXPECT_THAT(result.errors, HasSubstr("missing.png: no such file"));
}

// A file system of 64 KiB, mounted by root or in a user namespace of its own; the old file must survive.
TEST_F(BadInput, FullDiskKeepsTheOldFile) {
  const std::string folder = path("small").string();
  const auto script = write("full.sh",
                            "cd \"$(dirname \"$0\")\"; mount -t tmpfs -o size=64k tmpfs small && cd small\n"
                            "echo old > out.json; head -c 61440 /dev/zero > filler\n" PENUMBRA_PROGRAM
                            " tables --format json -o " +
                                folder +
                                "/out.json; echo \"exit $?\"\n"
                                "cat out.json; ls -A; cd ..; umount small\n");
  const auto result =
      shell("mkdir " + folder + "; [ $(id -u) -eq 0 ] || in='unshare -rm'; $in bash " + script.string());
  EXPECT_THAT(result.errors, HasSubstrs("out.json", "No space left on device"));
  EXPECT_EQ(result.output, "exit 2\nold\nfiller\nout.json\n");
}

}  // namespace
}  // namespace penumbra
