// Tests graphs as C#: names that C# cannot have are refused.
#include "techniques/graph_emit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "input/input_error.h"
#include "shaders/shader_files.h"

namespace penumbra::techniques {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class GraphEmitTest : public testing::Test {
 protected:
  GraphEmitTest() { files_.write("T.shader", "// here\n"); }

  static std::string graph(const std::string& name, const std::string& texture = "\"format\": \"r8\"") {
    return R"({"name": ")" + name + R"(", "textures": [{"name": "visibility", )" + texture + R"(}],
      "passes": [{"name": "Draw", "kind": "raster", "shader": "T.shader", "writes": ["visibility"]}],
      "visibility": "visibility"})";
  }

  std::string emitted(const std::string& graphs) const {
    const std::filesystem::path manifest =
        files_.write("lit-up.technique.json", "{\"graphs\": [" + graphs + R"(], "techniques": [
      {"name": "t", "title": "T", "family": "t", "source": "s", "graph": "first"}]})");
    return emit_graphs_csharp(read_technique_list(manifest)).at(0).text;
  }

  std::string problem(const std::string& graphs) const {
    try {
      (void)emitted(graphs);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  shaders::ShaderFiles files_;
};

TEST_F(GraphEmitTest, NamesAreCSharps) {
  EXPECT_THAT(emitted(graph("first") + "," + graph("2x-second graph")),
              AllOf(HasSubstr("static class LitUpGraphs"), HasSubstr("TechniqueGraph First ="),
                    HasSubstr("TechniqueGraph Of2xSecondGraph =")));
}

TEST_F(GraphEmitTest, NamesThatCSharpCannotHaveAreRefused) {
  EXPECT_THAT(
      problem(graph("first") + "," + graph("First")),
      AllOf(HasSubstr("lit-up.technique.json:3:"), HasSubstr("'first' and 'First' are both First in C#")));
  EXPECT_THAT(problem(graph("first") + "," + graph("---")), HasSubstr("'---' is no name that C# can have"));
}

TEST_F(GraphEmitTest, AHistoryNamesWhatItIsOf) {
  const std::string graph = R"({"name": "first", "textures": [
        {"name": "before", "previous_of": "visibility"}, {"name": "visibility", "format": "r8"}],
      "passes": [{"name": "Draw", "kind": "raster", "shader": "T.shader", "reads": {"_Before": "before"},
                  "writes": ["visibility"]}], "visibility": "visibility"})";
  EXPECT_THAT(emitted(graph),
              HasSubstr("new GraphTexture(\"before\", GraphExtent.Screen, GraphicsFormat.R8_UNorm, "
                        "previousOf: 1)"));
}

TEST_F(GraphEmitTest, APartIsNotWhole) {
  const std::string part = R"({"name": "part", "textures": [{"name": "mask", "format": "r8"}],
      "passes": [{"name": "Mask", "kind": "raster", "shader": "T.shader", "writes": ["mask"]}], "mask": "mask"})";
  std::string whole = graph("first");
  whole.insert(1, R"("parts": ["part"], )");
  EXPECT_THAT(emitted(part + "," + whole), AllOf(HasSubstr("mask = 0"), HasSubstr("visibility = 1"),
                                                 Not(HasSubstr("TechniqueGraph Part"))));
}

TEST_F(GraphEmitTest, AGraphThatNoTechniqueHasIsCheckedToo) {
  EXPECT_THAT(problem(graph("first") + "," + graph("second", "\"format\": \"r8\", \"divisor\": 2")),
              HasSubstr("the visibility has not one texel for each pixel of the screen"));
}

}  // namespace
}  // namespace penumbra::techniques
