// Tests graphs as rows of the table that the renderer feature reads.
#include "techniques/feature_tables.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "input/input_error_matcher.h"
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
    return graph_rows(read_technique_list(manifest));
  }

  std::string problem(const std::string& graphs) const {
    return input_error_of([&] { (void)emitted(graphs); });
  }

  shaders::ShaderFiles files_;
};

TEST_F(GraphEmitTest, EachGraphHasItsRows) {
  const auto rows = [](const std::string& name) {
    return "graph\t" + name +
           "\ntexture\tvisibility\tScreen\tR8_UNorm\npass\tRaster\tFrame\tT.shader\tDraw\n"
           "write\t\tvisibility\nvisibility\tvisibility\n";
  };
  EXPECT_EQ(emitted(graph("first") + "," + graph("2x-second graph")),
            rows("first") + rows("2x-second graph"));
}

TEST_F(GraphEmitTest, GraphsOfOneNameAreRefused) {
  files_.write("ShaderLibrary/T.shader", "// here\n");
  for (const std::string name : {"a", "b"})
    files_.write("ShaderLibrary/" + name + ".technique.json",
                 "{\"graphs\": [" + graph("first") + R"(], "techniques": [{"name": ")" + name +
                     R"(", "title": "T", "family": "t", "source": "s", "graph": "first"}]})");
  expect_input_error(
      [&] { (void)graph_rows(read_technique_list(files_.path(""))); },
      HasSubstrs("b.technique.json:1:", "'first' is the name of another", "a.technique.json:1:"));
}

TEST_F(GraphEmitTest, AHistoryNamesWhatItIsOf) {
  const std::string graph = R"({"name": "first", "textures": [
        {"name": "before", "previous_of": "visibility"}, {"name": "visibility", "format": "r8"}],
      "passes": [{"name": "Draw", "kind": "raster", "shader": "T.shader", "reads": {"_Before": "before"},
                  "writes": ["visibility"]}], "visibility": "visibility"})";
  EXPECT_THAT(emitted(graph),
              HasSubstr("texture\tvisibility\tScreen\tR8_UNorm\nprevious\tbefore\tvisibility\n"));
}

TEST_F(GraphEmitTest, APartIsNotWhole) {
  const std::string part = R"({"name": "part", "textures": [{"name": "mask", "format": "r8"}],
      "passes": [{"name": "Mask", "kind": "raster", "shader": "T.shader", "writes": ["mask"]}], "mask": "mask"})";
  std::string whole = graph("first");
  whole.insert(1, R"("parts": ["part"], )");
  EXPECT_THAT(emitted(part + "," + whole),
              AllOf(HasSubstr("visibility\tvisibility\nmask\tmask\n"), Not(HasSubstr("graph\tpart"))));
}

TEST_F(GraphEmitTest, AGraphThatNoTechniqueHasIsCheckedToo) {
  EXPECT_THAT(problem(graph("first") + "," + graph("second", "\"format\": \"r8\", \"divisor\": 2")),
              HasSubstr("the visibility has not one texel for each pixel of the screen"));
}

}  // namespace
}  // namespace penumbra::techniques
