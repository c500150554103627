// The passes of a technique and the textures between them, as data.
//
// A graph ends in visibility: either in a filter, a library function that is called for each receiver, or in
// a texture of the screen's size. A filter alone is the shortest graph.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "hlsl/diagnostic.h"

namespace penumbra::techniques {

// The sizes of which an extent is a share: the camera's picture, the shadow map with all cascades, one
// cascade's tile of it (a layer for each cascade), or a size of its own.
enum class ExtentOf { screen, map, tile, fixed };

struct GraphTexture {
  std::string name;
  std::string where;  // file:line:column of its name, for messages; may be empty
  ExtentOf extent = ExtentOf::screen;
  int divisor = 1;            // texels of the extent per texel of the texture, along each axis; rounded up
  std::array<int, 3> size{};  // texels, for a fixed extent; with a depth above 1, a 3D texture
  std::string format = "r8";  // a name of texel_formats.h
  int mips = 1;               // 0 means down to one texel
  int layers = 1;             // a tile's texture has one for each cascade, whatever this says
  int samples = 1;            // samples of each texel
  // If set, this texture holds what that one held a frame ago, 0 in the first; it has its shape.
  std::string previous_of;
};

// The name of the shadow map in filters and passes of casters.
inline constexpr const char* shadow_map_name = "shadowMap";
// This argument of filters is the SpotMap of ShaderLibrary/Core/SpotLight.hlsl.
inline constexpr const char* spot_light_name = "spotLight";

// The keyword of materials with alpha test, as URP's own shaders declare it. Programs of casters that declare
// it have it on for such materials alone.
inline constexpr const char* alpha_test_keyword = "_ALPHATEST_ON";

// A function of the shader library that returns the visibility of a receiver. Its arguments are these in
// order, then ShadowReceiver, ShadowTile and, where `parameters` is not empty, that struct.
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

// The casters that a pass draws: those that the shadow map holds, with alpha test where they have holes;
// those that blend, which it does not hold; or the closed shadow volumes of the former, without holes.
enum class DrawnCasters { opaque, blended, volumes };

enum class Frequency { bake, cascade, frame };  // once; for each cascade that was drawn anew; every frame

// The number of groups of threads with which a kernel is started.
struct GroupCount {
  std::array<int, 3> fixed{};  // if all are 0, the number is not fixed
  std::string texels_of;       // one thread per texel of this texture,
  int divisor = 1;             // or per block of divisor x divisor texels
};

struct GraphPass {
  std::string name;
  std::string where;
  PassKind kind = PassKind::filter;
  Frequency frequency = Frequency::frame;
  std::string file;     // .shader or .compute, relative to the package's folder; empty for a filter
  std::string program;  // pass of the .shader or kernel of the .compute
  // The program's name of each texture, and its name in the graph.
  std::vector<std::pair<std::string, std::string>> reads;
  // Textures that the program declares and this pass does not bind. The program sees from a size of 0 that it
  // must not read them.
  std::vector<std::string> absent;
  std::vector<std::pair<std::string, std::string>> writes;  // for drawn passes the targets in order, unnamed
  // For kernels, those of `writes` that another pass has written before, and whose content this one changes.
  std::vector<std::string> updates;
  DrawnCasters casters = DrawnCasters::opaque;  // for kind casters
  // For casters, the texture that they are tested against and whose depth they write, or shadow_map_name. If
  // it is empty, there is no depth test.
  std::string depth;
  // For raster passes and casters, a texture with stencil that another pass of casters has as its depth. Its
  // depth is tested against and kept; casters change its stencil, and a raster pass is tested against it.
  std::string stencil;
  std::vector<std::string> parameters;  // structs
  // For raster passes that read and write one texture: they run once for each mip level but the first, from
  // the level before.
  bool each_mip = false;
  GroupCount groups;
  // The function that it computes at a receiver: a filter always has one, others if they call one.
  std::optional<FilterCall> filter;
};

// Returns whether it writes a texture of that name; a depth target is written, too.
bool writes_to(const GraphPass& pass, const std::string& name);
bool changes(const GraphPass& pass, const std::string& name);  // true if it is among the pass's updates

// The inputs of a graph's programs besides the frame, by names that are the same in every graph: textures and
// numbers that are made before the first frame, most of them from the scene's geometry.
enum class Need {
  ground_heights,   // the ground's, on a grid: heights alone, or with them
  horizon_angles,   // the angles up to which the ground hides the sky, in eight directions
  distance_fields,  // the scene's objects, in one 3D texture
  noise_mask,       // parameters/noise_mask.h: noise that is even over pixels and over frames
};

std::vector<Need> all_needs();

// The names in manifests, in the order of the enumerators.
template <typename Value>
inline constexpr std::nullptr_t names_of = nullptr;
template <>
inline constexpr std::array names_of<ExtentOf>{"screen", "map", "tile", "fixed"};
template <>
inline constexpr std::array names_of<PassKind>{"filter", "raster", "casters", "compute"};
template <>
inline constexpr std::array names_of<DrawnCasters>{"opaque", "blended", "volumes"};
template <>
inline constexpr std::array names_of<Frequency>{"bake", "cascade", "frame"};
template <>
inline constexpr std::array names_of<Need>{"groundHeights", "horizonAngles", "distanceFields", "noiseMask"};

template <typename Value>
requires(names_of<Value>.size() > 0) constexpr const char* name_of(Value value) {
  return names_of<Value>.at(static_cast<std::size_t>(value));
}

struct PassGraph {
  std::vector<GraphTexture> textures;
  std::vector<GraphPass> passes;      // in the order in which they run
  std::vector<std::string> keywords;  // these are on in every program that declares them
  std::vector<Need> needs{};          // each once
  std::string visibility;             // the texture that holds it; empty if a filter returns it
  std::string source;  // the texture that holds the visibility of an earlier graph; may be empty
  std::string mask;    // the texture that is below 0.5 where no penumbra is; may be empty
  // The textures that shaders after the passes read as a filter would, by argument_name; none where a filter
  // reads them.
  std::vector<std::string> published{};

  const GraphTexture* texture(const std::string& name) const;
  const GraphPass* filter_pass() const;  // the pass of kind filter; null if there is none
  const FilterCall* filter() const;      // filter of the last pass that has one
  bool over_screen() const { return !visibility.empty(); }
  bool draws_casters() const;
  bool draws(DrawnCasters casters) const;
  bool has_history() const;   // true if it reads what a texture held a frame ago
  bool needs_camera() const;  // true if it runs over the screen, or draws what the camera sees of the casters
};

// Returns a graph of that filter alone.
PassGraph graph_of(FilterCall filter, const std::string& where);

// Returns both, one after the other: the visibility of `earlier`, a texture, is the source of `later`.
PassGraph in_sequence(const PassGraph& earlier, const PassGraph& later);

// Throws InputError for the first thing that is wrong, at its texture or pass, or else at `where`:
// names that nothing has or two have, a texture that nothing or two passes write (others may change it), or
// nothing reads, depth where there is none, passes that wait for each other, a pass that runs more rarely
// than what it reads, targets of different extents, uses that a format does not have anywhere, no visibility
// or one of another size than the screen's.
void check_graph(const PassGraph& graph, const std::string& where);

// Returns the passes in an order in which each comes after those whose output it reads, else in the order
// given; absent where passes wait for each other.
std::optional<std::vector<GraphPass>> in_running_order(const PassGraph& graph);

// Returns the features that the pass needs and this target lacks, at the texture that needs them: formats
// that its compute shaders cannot write. Targets have the names that `penumbra validate` takes.
std::vector<hlsl::Diagnostic> target_problems(const PassGraph& graph, const GraphPass& pass,
                                              const std::string& target);

// The reads of a graph's passes, and the order that follows from them.
bool reads(const PassGraph& graph, const GraphPass& pass, const std::string& name);

// Returns whether `later` has to wait for `earlier`: it reads or changes what `earlier` writes, or makes the
// mip levels of it.
bool waits_for(const PassGraph& graph, const GraphPass& later, const GraphPass& earlier);

// Returns for each pass the numbers of those that it waits for, rising. Only passes that write what it needs
// are examined.
std::vector<std::vector<std::size_t>> awaited_passes(const PassGraph& graph);

}  // namespace penumbra::techniques
