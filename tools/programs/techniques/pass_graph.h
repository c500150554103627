// The passes of a technique and the textures and buffers between them, as data.
//
// A graph ends in visibility: either in a filter, a library function that is called for each receiver, or in
// a texture of the screen's size. A filter alone is the shortest graph.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hlsl/diagnostic.h"

namespace penumbra::techniques {

// What an extent is a share of: the camera's picture, the shadow map with all cascades, one cascade's tile of
// it (a layer for each cascade), or a size of its own.
enum class ExtentOf { screen, map, tile, fixed };

struct GraphTexture {
  std::string name;
  std::string where;  // file:line:column of its name, for messages; may be empty
  ExtentOf extent = ExtentOf::screen;
  int divisor = 1;            // texels of the extent per texel of the texture, along each axis; rounded up
  std::array<int, 3> size{};  // texels, of a fixed extent; a depth above 1: a 3D texture
  std::string format = "r8";  // of texel_formats.h
  int mips = 1;               // 0: down to one texel
  int layers = 1;             // of a tile: one for each cascade, whatever this says
  int samples = 1;            // of each texel
  std::string previous_of;    // holds what this texture held a frame ago, 0 in the first; has its shape
};

// Words of 32 bits: as many as a fixed number and so many for each texel of a texture, or for each block of
// divisor x divisor texels.
struct GraphBuffer {
  std::string name;
  std::string where;
  int words = 0;
  int words_per_texel = 0;
  std::string texture;    // whose texels count; empty: none
  int divisor = 1;        // of the texture's width and height, rounded up
  bool indirect = false;  // the first three words are the numbers of groups of dispatches
};

// What filters and passes of casters call the shadow map.
inline constexpr const char* shadow_map_name = "shadowMap";
// An argument of filters: the SpotMap of ShaderLibrary/Core/SpotLight.hlsl.
inline constexpr const char* spot_light_name = "spotLight";

// The keyword of materials with alpha test, as URP's own shaders declare it. Programs of casters that declare
// it have it on for such materials alone.
inline constexpr const char* alpha_test_keyword = "_ALPHATEST_ON";

// A function of the shader library: visibility of a receiver. Its arguments are these in order, then
// ShadowReceiver, ShadowTile and, where `parameters` is not empty, that struct.
struct FilterCall {
  std::string file;  // relative to the package's folder where it lies in it
  std::string function;
  std::vector<std::string> arguments;  // "shadowMap" (with its comparison sampler), "pointSampler",
                                       // "linearSampler", "spotLight", or a texture of the graph
  std::string parameters;              // struct name, may be empty

  bool takes(const std::string& argument) const;
};

enum class PassKind {
  filter,   // calls a FilterCall for each receiver; the last of its graph
  raster,   // a pass of a .shader, drawn over all of its targets
  casters,  // a pass of a .shader that draws the scene's casters, for each cascade or as the camera sees them
  compute   // a kernel of a .compute
};

inline bool is_drawn(PassKind kind) {
  return kind == PassKind::raster || kind == PassKind::casters;
}

// Which casters a pass draws: those that the shadow map holds, with alpha test where they have holes; those
// that blend, which it does not hold; or the closed shadow volumes of the former, without holes.
enum class DrawnCasters { opaque, blended, volumes };

enum class Frequency { bake, cascade, frame };  // once; for each cascade that was drawn anew; every frame

const char* name_of(Frequency frequency);  // as manifests have it
const char* name_of(PassKind kind);
const char* name_of(DrawnCasters casters);

// How many groups of threads a kernel is started with.
struct GroupCount {
  std::array<int, 3> fixed{};  // all 0: not fixed
  std::string texels_of;       // one thread per texel of this texture,
  int divisor = 1;             // or per block of divisor x divisor of them
  std::string indirect;        // as this buffer says
};

struct GraphPass {
  std::string name;
  std::string where;
  PassKind kind = PassKind::filter;
  Frequency frequency = Frequency::frame;
  std::string file;     // .shader or .compute, relative to the package's folder; empty: a filter
  std::string program;  // pass of the .shader or kernel of the .compute
  // What the program calls a texture or buffer, and which one of the graph it is.
  std::vector<std::pair<std::string, std::string>> reads;
  // Textures that the program declares and this pass does not bind. The program sees from a size of 0 that it
  // must not read them.
  std::vector<std::string> absent;
  std::vector<std::pair<std::string, std::string>> writes;  // of drawn passes the targets in order, unnamed
  // Of kernels: those of `writes` that another pass has written before, and whose content this one changes.
  std::vector<std::string> updates;
  DrawnCasters casters = DrawnCasters::opaque;  // of kind casters
  // Of casters: the texture that they are tested against and whose depth they write, shadow_map_name, or
  // empty: no depth test.
  std::string depth;
  // Of raster passes and casters: a texture with stencil that another pass of casters has as its depth. Its
  // depth is tested against and kept; casters change its stencil, a raster pass is tested against that.
  std::string stencil;
  std::vector<std::string> parameters;  // structs
  bool each_mip = false;                // once for each mip level but the first, from the level before
  GroupCount groups;
  // What it computes at a receiver: always of a filter, of others where they call one.
  std::optional<FilterCall> filter;
};

// A texture or buffer by its name in the graph; a depth target is written, too.
bool writes_to(const GraphPass& pass, const std::string& name);
bool changes(const GraphPass& pass, const std::string& name);  // is among its updates

// What the programs of a graph read besides the frame, by names that are the same in every graph: textures
// and numbers that are made before the first frame, most of them from the scene's geometry.
enum class Need {
  ground_heights,   // of the ground, on a grid: heights alone, or with them
  horizon_angles,   // up to which the ground hides the sky, in eight directions
  distance_fields,  // of the scene's objects, in one 3D texture
  noise_mask,       // parameters/noise_mask.h: noise that is even over pixels and over frames
};

const char* name_of(Need need);  // as manifests have it
std::vector<Need> all_needs();

struct PassGraph {
  std::vector<GraphTexture> textures;
  std::vector<GraphBuffer> buffers;
  std::vector<GraphPass> passes;      // in the order in which they run
  std::vector<std::string> keywords;  // on in every program that declares them
  std::vector<Need> needs{};          // each once
  std::string visibility;             // the texture that holds it; empty: a filter's
  std::string source;                 // the texture that holds that of a graph before; may be empty
  std::string mask;                   // the texture that is below 0.5 where no penumbra is; may be empty
  // Textures that shaders after the passes read as a filter would, by argument_name; none where a filter
  // does.
  std::vector<std::string> published{};

  const GraphTexture* texture(const std::string& name) const;
  const GraphBuffer* buffer(const std::string& name) const;
  const GraphPass* filter_pass() const;  // of kind filter; null: none
  const FilterCall* filter() const;      // of the last pass that has one
  bool over_screen() const { return !visibility.empty(); }
  bool draws_casters() const;
  bool draws(DrawnCasters casters) const;
  bool needs_camera() const;  // over the screen, or draws what the camera sees of the casters
};

// A graph of that filter alone.
PassGraph graph_of(FilterCall filter, const std::string& where);

// Both, one after the other: the visibility of `earlier`, a texture, is the source of `later`.
PassGraph in_sequence(const PassGraph& earlier, const PassGraph& later);

// Throws InputError for the first thing that is wrong, at its texture, buffer or pass, or else at `where`:
// names that nothing has or two have, a texture that nothing or two passes write (others may change it), or
// nothing reads, depth where there is none, passes that wait for each other, a pass that runs more rarely
// than what it reads, targets of different extents, uses that a format does not have anywhere, no visibility
// or one of another size than the screen's.
void check_graph(const PassGraph& graph, const std::string& where);

// The passes such that each comes after those whose output it reads, else in the order given; absent where
// passes wait for each other.
std::optional<std::vector<GraphPass>> in_running_order(const PassGraph& graph);

// What this target lacks of what the pass needs, at the texture that needs it: formats that its compute
// shaders cannot write. Targets as `penumbra validate` names them.
std::vector<hlsl::Diagnostic> target_problems(const PassGraph& graph, const GraphPass& pass,
                                              const std::string& target);

}  // namespace penumbra::techniques
