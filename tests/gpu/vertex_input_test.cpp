// Vertices from buffers, in order and by indices.
#include <array>

#include "gpu/gpu_test.h"
#include "gpu/sequence.h"

namespace penumbra::gpu {
namespace {

using Colour = std::array<float, 4>;
using Position = std::array<float, 3>;
using Uv = std::array<float, 2>;

// The corners are those of a square over all of the target: two triangles that share two corners.
const std::vector<Position> corners{{-1, -1, 0.5F}, {1, -1, 0.5F}, {-1, 1, 0.5F}, {1, 1, 0.5F}};
const std::vector<Uv> uvs{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
const std::vector<std::uint32_t> indices{0, 1, 2, 1, 3, 2};

class GpuVertices : public Gpu {
 protected:
  RasterShaders shaders() const {
    RasterShaders made;
    made.vertex = compile_test_shader("Vertices.hlsl", "Draw", hlsl::Stage::vertex);
    made.vertex_entry = "Draw";
    made.fragment = compile_test_shader("Vertices.hlsl", "Colour", hlsl::Stage::fragment);
    made.fragment_entry = "Colour";
    made.colours = {Format::rgba32f};
    made.inputs = {{0, 3}, {1, 2}};
    return made;
  }
  template <typename T>
  Buffer buffer(const std::vector<T>& content) const {
    return Buffer(*device, std::span<const T>(content));
  }
};

TEST_F(GpuVertices, IndicesShareCorners) {
  RasterPass pass(*device, shaders());
  const Buffer positions = buffer(corners), coordinates = buffer(uvs), order = buffer(indices);
  const Image target(*device, Format::rgba32f, 2, 2);
  pass.draw({{&target}}, {{0, 0, 2, 2, 6, {}}}, {{&positions, &coordinates}, &order});
  EXPECT_EQ(target.download<Colour>(),
            (std::vector<Colour>{
                {0.25F, 0.25F, 0, 1}, {0.75F, 0.25F, 0, 1}, {0.25F, 0.75F, 0, 1}, {0.75F, 0.75F, 0, 1}}));
}

TEST_F(GpuVertices, AreDrawnInOrderWithoutIndices) {
  RasterPass pass(*device, shaders());
  const Buffer positions = buffer(corners), coordinates = buffer(uvs);
  const Image target(*device, Format::rgba32f, 2, 2);
  pass.draw({{&target}}, {{0, 0, 2, 2, 3, {}}}, {{&positions, &coordinates}});
  const std::vector<Colour> drawn = target.download<Colour>();
  EXPECT_EQ(drawn.front(), (Colour{0.25F, 0.25F, 0, 1}));
  EXPECT_EQ(drawn.back(), (Colour{0, 0, 0, 0})) << "beyond the one triangle";
}

// The sequence waits for what an earlier step has written.
TEST_F(GpuVertices, MayBeWrittenInTheSameSequence) {
  const RasterPass pass(*device, shaders());
  const Buffer positions = buffer(corners), coordinates = buffer(uvs), order = buffer(indices);
  const Image target(*device, Format::rgba32f, 2, 2);
  ComputePass zeros(*device, {.spirv = compile_test_shader("Pyramid.hlsl", "Zeros"), .entry = "Zeros"});
  zeros.bindings().buffer("_Zeroed", order);
  Sequence sequence(*device);
  sequence.dispatch(zeros, zeros.bindings(), {6, 1, 1});
  sequence.draw(pass, pass.more_bindings(), {{&target}}, {{0, 0, 2, 2, 6, {}}},
                {{&positions, &coordinates}, &order});
  sequence.run();
  EXPECT_TRUE(sequence.waited()[1]);
  EXPECT_EQ(target.download<Colour>(), std::vector<Colour>(4, Colour{0, 0, 0, 0})) << "all corners are one";
}

TEST_F(GpuVertices, BuffersThatDoNotFitAreRefused) {
  RasterPass pass(*device, shaders());
  const Buffer positions = buffer(corners), coordinates = buffer(uvs), order = buffer(indices);
  const Image target(*device, Format::rgba32f, 2, 2);
  const auto draw = [&](std::uint32_t count, const VertexStreams& streams) {
    pass.draw({{&target}}, {{0, 0, 2, 2, count, {}}}, streams);
  };
  EXPECT_THROW(draw(3, {}), std::logic_error);
  EXPECT_THROW(draw(3, {{&positions, nullptr}}), std::logic_error);
  EXPECT_THROW(draw(6, {{&positions, &coordinates}}), std::invalid_argument);
  EXPECT_THROW(draw(9, {{&positions, &coordinates}, &order}), std::invalid_argument);
  RasterShaders wide = shaders();
  wide.inputs[0].components = 5;
  EXPECT_THROW(RasterPass(*device, wide), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::gpu
