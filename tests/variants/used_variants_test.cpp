// Materials, collections and logs narrow the variants of the shader that they name.
#include "variants/used_variants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "input/input_error_matcher.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const std::string kProgram =
    "#pragma multi_compile _ FOG\n#pragma shader_feature _ A B\n#pragma shader_feature_local _ C\n";

std::string material(const std::string& guid, const std::string& keywords) {
  return "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!21 &2100000\nMaterial:\n  m_Name: M\n  m_Shader: "
         "{fileID: 4800000, guid: " +
         guid + ", type: 3}\n" + keywords + "  m_InvalidKeywords:\n  - B\n  m_LightmapFlags: 4\n";
}

std::vector<std::string> used(const UsedVariants& used, const std::string& guid, const std::string& shader,
                              const std::string& pass, const std::string& program = kProgram) {
  const std::optional<Narrowing> narrowing = used.narrow({}, shader, guid, pass);
  if (!narrowing) return {};
  return texts_of(KeywordSpace(pragmas_of(program), *narrowing).whole_program());
}

TEST(UsedVariants, MaterialsAndCollectionsDecideShaderFeatures) {
  UsedVariants all;
  all.add(material("11", "  m_ValidKeywords:\n  - A\n  - C\n"), "a.mat");
  all.add(material("11", "  m_ValidKeywords: []\n"), "b.mat");
  all.add(material("22", "  m_ShaderKeywords: B C\n"), "old.mat");
  all.add(
      "--- !u!200 &20000000\nShaderVariantCollection:\n  m_Shaders:\n  - first: {fileID: 4800000, guid: 11, "
      "type: 3}\r\n    second:\n      variants:\n      - keywords: B FOG\n        passType: 13\n      - "
      "keywords: \n        passType: 13\n",
      "warm.shadervariants");
  EXPECT_THAT(used(all, "11", "", "P"), UnorderedElementsAre("-", "A C", "B", "FOG", "FOG A C", "FOG B"));
  EXPECT_THAT(used(all, "22", "", "P"), UnorderedElementsAre("B C", "FOG B C"));
  EXPECT_THAT(used(all, "33", "", "P"), UnorderedElementsAre("-", "FOG")) << "no material has this shader";
}

// The forms are those of Unity 2019, of 2022 and of an Android device.
TEST(UsedVariants, OfALogAreThoseOfThePassAlone) {
  UsedVariants log;
  log.add(
      "Mono path[0] = 'x'\n"
      "Compiled shader: My/Water, pass: Forward, stage: vertex, keywords <no keywords>\n"
      "Uploaded shader variant to the GPU driver: My/Water (instance 0x19C), pass: FORWARD, stage: fragment, "
      "keywords FOG B, time: 1.4 ms\r\n"
      "02-10 17:36 D Unity   : Uploaded shader variant to the GPU driver: My/Water, pass: <Unnamed Pass 2>, "
      "stage: all, keywords A\n",
      "Player.log");
  EXPECT_THAT(used(log, "", "My/Water", "Forward"), UnorderedElementsAre("-", "FOG B"));
  EXPECT_THAT(used(log, "", "My/Water", "0.2"), ElementsAre("A"));
  EXPECT_THAT(used(log, "", "My/Water", "0.1"), IsEmpty());
  EXPECT_THAT(used(log, "", "My/Grass", "Forward"), IsEmpty());
}

TEST(UsedVariants, WhatIsNoneOfThemIsRefused) {
  UsedVariants all;
  expect_input_error([&] { all.add("a\nb\n", "notes.txt"); }, HasSubstr("names no shader variant"));
  expect_input_error([&] { all.add(std::string("m_Shader\0x", 10), "a.mat"); }, HasSubstr("binary"));
  expect_input_error([] { read_used_variants({"/nowhere/Assets"}); }, HasSubstr("cannot be read"));
}

TEST(UsedVariants, OfAFolderAreThoseOfItsFiles) {
  const fs::path folder = fs::path(testing::TempDir()) / "used-variants";
  fs::remove_all(folder);
  fs::create_directories(folder / "below");
  expect_input_error([&] { read_used_variants({folder.string()}); }, HasSubstr("has no material"));
  std::ofstream(folder / "below" / "a.mat") << material("11", "  m_ValidKeywords:\n  - C\n");
  std::ofstream(folder / "notes.txt") << "no log";
  EXPECT_THAT(used(read_used_variants({folder.string()}), "11", "", "P"), UnorderedElementsAre("C", "FOG C"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace penumbra::variants
