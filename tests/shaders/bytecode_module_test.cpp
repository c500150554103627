// Compares what FXC made of the files in bytecode/ with what glslang makes of them: the same names and kinds.
// Offsets differ, since glslang aligns a float2 to eight bytes: those are from FXC's listing.
#include "shaders/bytecode_module.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>

#include "shaders/compile.h"
#include "shaders/counted_module.h"
#include "shaders/pipeline_interface.h"

namespace penumbra::shaders {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests" / "shaders" / "bytecode";

std::string bytecode(const std::string& name) {
  std::ifstream file(kFolder / (name + ".dxbc"), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

CompileResult by_glslang(const std::string& name, hlsl::Stage stage) {
  CompileRequest request;
  request.file = kFolder / (name + ".hlsl");
  request.stage = stage;
  return compile(request);
}

std::vector<Resource> sorted(std::vector<Resource> resources) {
  std::sort(resources.begin(), resources.end(),
            [](const Resource& a, const Resource& b) { return a.name < b.name; });
  return resources;
}

std::vector<std::string> names(const std::vector<Resource>& resources) {
  std::vector<std::string> names;
  for (const Resource& resource : resources) names.push_back(resource.name);
  return names;
}

void expect_same_leaves(const UniformMember& ours, const UniformMember& theirs) {
  ASSERT_EQ(ours.leaves.size(), theirs.leaves.size()) << ours.name;
  for (std::size_t i = 0; i < ours.leaves.size(); ++i) {
    const UniformLeaf& a = ours.leaves[i];
    const UniformLeaf& b = theirs.leaves[i];
    EXPECT_EQ(a.path, b.path);
    EXPECT_EQ(a.scalar, b.scalar) << a.path;
    EXPECT_EQ(a.rows, b.rows) << a.path;
    EXPECT_EQ(a.columns, b.columns) << a.path;
    EXPECT_EQ(a.matrix_stride, b.matrix_stride) << a.path;
    EXPECT_EQ(a.row_major, b.row_major) << a.path;
  }
}

TEST(Bytecode, ItsUniformsAreThoseOfGlslang) {
  const std::vector<Resource> ours = sorted(bytecode_uniforms(bytecode("resources")));
  std::vector<Resource> theirs =
      sorted(reflect(by_glslang("resources", hlsl::Stage::compute).spirv).resources);
  std::erase_if(theirs,
                [](const Resource& resource) { return resource.kind != ResourceKind::uniform_block; });
  ASSERT_EQ(ours.size(), 2);
  ASSERT_EQ(theirs.size(), 2);
  for (std::size_t block = 0; block < 2; ++block) {
    EXPECT_EQ(ours[block].name, theirs[block].name);
    ASSERT_EQ(ours[block].members.size(), theirs[block].members.size());
    for (std::size_t i = 0; i < ours[block].members.size(); ++i) {
      const UniformMember& a = ours[block].members[i];
      const UniformMember& b = theirs[block].members[i];
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.array_length, b.array_length) << a.name;
      EXPECT_EQ(a.array_stride, b.array_stride) << a.name;
      EXPECT_EQ(a.matrix_stride, b.matrix_stride) << a.name;
      EXPECT_EQ(a.row_major, b.row_major) << a.name;
      EXPECT_EQ(a.read, a.name != "_Unread") << a.name;
      expect_same_leaves(a, b);
    }
  }
}

TEST(Bytecode, ItsUniformsAreWhereFxcListsThem) {
  std::map<std::string, std::pair<std::uint32_t, std::uint32_t>> places;  // offset and size
  for (const Resource& block : bytecode_uniforms(bytecode("resources"))) {
    places[block.name] = {0, block.size};
    for (const UniformMember& member : block.members) {
      places[member.name] = {member.offset, member.size};
      for (const UniformLeaf& leaf : member.leaves)
        if (leaf.path != member.name) places[leaf.path] = {leaf.offset, 0};
    }
  }
  const std::map<std::string, std::pair<std::uint32_t, std::uint32_t>> listed = {
      {"$Global", {0, 288}},
      {"_Matrices", {0, 192}},
      {"_Matrices[0]", {0, 0}},
      {"_Matrices[1]", {64, 0}},
      {"_Matrices[2]", {128, 0}},
      {"_One", {192, 4}},
      {"_Two", {196, 8}},
      {"_Array", {208, 36}},
      {"_Array[0]", {208, 0}},
      {"_Array[1]", {224, 0}},
      {"_Array[2]", {240, 0}},
      {"_Integers", {256, 16}},
      {"_Unsigned", {272, 4}},
      {"Named", {0, 224}},
      {"_First", {0, 16}},
      {"_Rows", {16, 48}},
      {"_Columns", {64, 60}},
      {"_Unread", {124, 4}},
      {"_Discs", {128, 84}},
      {"_Discs[0].centre", {128, 0}},
      {"_Discs[0].radii[0]", {144, 0}},
      {"_Discs[0].radii[1]", {160, 0}},
      {"_Discs[1].centre", {176, 0}},
      {"_Discs[1].radii[0]", {192, 0}},
      {"_Discs[1].radii[1]", {208, 0}}};
  EXPECT_EQ(places, listed);
}

TEST(Bytecode, BytesThatAreNoContainerAreRefused) {
  const std::string whole = bytecode("resources");
  const std::size_t end = whole.find("ISGN");  // end of the chunk that names the resources
  ASSERT_NE(end, std::string::npos);
  EXPECT_THROW(bytecode_uniforms("DXBC"), std::invalid_argument);
  for (std::size_t size = 0; size < end; size += 7)
    EXPECT_THROW(bytecode_uniforms(whole.substr(0, size)), std::invalid_argument) << size;
}

// Whatever a word of the container is replaced by, the answer is a layout or a refusal.
TEST(Bytecode, DamagedContainersAreReadWithinTheirBounds) {
  const std::string whole = bytecode("resources");
  int refused = 0;
  for (std::size_t at = 0; at + 4 <= whole.size(); at += 4) {
    for (const std::uint32_t word :
         {0U, 0x7FFFFFFFU, 0xFFFFFFFFU, static_cast<std::uint32_t>(whole.size() - 1)}) {
      std::string damaged = whole;
      for (unsigned i = 0; i < 4; ++i) damaged[at + i] = static_cast<char>(word >> (8 * i) & 0xFFU);
      try {
        bytecode_uniforms(damaged);
      } catch (const std::invalid_argument&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 100);
}

class TranslatedBytecode : public testing::Test {
 protected:
  void SetUp() override {
    if (!translates_bytecode()) GTEST_SKIP() << "built without vkd3d-shader";
  }
};

TEST_F(TranslatedBytecode, BindsWhatTheModuleOfGlslangBinds) {
  const BytecodeModule made = bytecode_module(bytecode("resources"), "Main");
  const Reflection ours = reflect(made.spirv);
  const Reflection theirs = reflect(by_glslang("resources", hlsl::Stage::compute).spirv);
  EXPECT_EQ(ours.workgroup_size, theirs.workgroup_size);
  const std::vector<Resource> a = sorted(ours.resources);
  const std::vector<Resource> b = sorted(theirs.resources);
  ASSERT_THAT(names(a), testing::ElementsAreArray(names(b)));
  std::set<std::uint32_t> bindings;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].kind, b[i].kind) << a[i].name;
    EXPECT_EQ(a[i].written, b[i].written) << a[i].name;
    EXPECT_EQ(a[i].image.arrayed, b[i].image.arrayed) << a[i].name;
    EXPECT_EQ(a[i].image.texel, b[i].image.texel) << a[i].name;
    EXPECT_EQ(a[i].set, 0) << a[i].name;
    bindings.insert(a[i].binding);
  }
  EXPECT_EQ(bindings.size(), a.size());
}

TEST_F(TranslatedBytecode, CanBeCounted) {
  const spirv::Module counted =
      counted_module(bytecode_module(bytecode("resources"), "Main").untouched, "Main");
  const std::vector<Resource> resources = reflect(counted).resources;
  EXPECT_TRUE(std::any_of(resources.begin(), resources.end(),
                          [](const Resource& resource) { return resource.name == texel_counts_name; }));
}

TEST_F(TranslatedBytecode, KeepsTheSemanticsOfTheInputsThatItReads) {
  const BytecodeModule made = bytecode_module(bytecode("triangle"), "Main");
  std::vector<std::string> read;
  for (const StageLocation& input : pipeline_interface(made.spirv, "Main").inputs)
    for (const SignatureElement& element : made.signature)
      if (!element.output && element.location == static_cast<int>(input.location) && element.read)
        read.push_back(element.semantic);
  EXPECT_THAT(read, testing::ElementsAre("POSITION0", "TEXCOORD1"));
  const PipelineInterface theirs =
      pipeline_interface(by_glslang("triangle", hlsl::Stage::vertex).spirv, "Main");
  EXPECT_EQ(pipeline_interface(made.spirv, "Main").outputs.size(), theirs.outputs.size());
}

TEST_F(TranslatedBytecode, BytesThatAreNoProgramAreRefused) {
  std::string damaged = bytecode("resources");
  const std::size_t code = damaged.find("SHEX");
  ASSERT_NE(code, std::string::npos);
  damaged.replace(code, 4, "SHEY");
  EXPECT_THROW(bytecode_module(damaged, "Main"), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::shaders
