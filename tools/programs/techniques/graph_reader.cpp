#include "techniques/graph_reader.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "input/text_line.h"

namespace penumbra::techniques {
namespace {

template <typename Value>
Value chosen(JsonObject& object, const std::string& key, const std::string& fallback, const std::string& what,
             const std::vector<std::pair<std::string, Value>>& choices) {
  const std::string text = object.text(key, fallback);
  if (text.empty()) object.fail(key, "'" + key + "' is missing");
  std::vector<std::string> known;
  for (const auto& [name, value] : choices) {
    if (name == text) return value;
    known.push_back(name);
  }
  require_known(object, key, what, text, known);
  return {};
}

std::vector<std::pair<std::string, std::string>> read_bindings(JsonObject object) {
  constexpr std::size_t kMost = 128;
  const std::vector<std::string> keys = object.keys();
  if (!keys.empty()) require_at_most(object, keys.front(), keys.size(), kMost, "names of one pass");
  std::vector<std::pair<std::string, std::string>> bindings;
  for (const std::string& key : keys) bindings.emplace_back(key, required_text(object, key));
  return bindings;
}

int whole(JsonObject& object, const std::string& key, double value, int most) {
  if (value != std::floor(value) || value < 1.0 || value > most)
    object.fail(key, "'" + key + "' has whole numbers from 1 to " + std::to_string(most));
  return static_cast<int>(value);
}

GraphTexture read_texture(JsonObject object) {
  GraphTexture texture;
  texture.name = required_identifier(object, "name");
  texture.where = object.where("name");
  texture.previous_of = object.text("previous_of", "");
  if (!texture.previous_of.empty()) {
    for (const char* key : {"extent", "divisor", "size", "format", "mips", "layers", "samples"})
      if (object.has(key))
        object.fail(key,
                    "'" + texture.name + "' is '" + texture.previous_of + "' a frame ago, and has its " + key,
                    "leave it out");
    object.finish();
    return texture;
  }
  texture.extent = chosen<ExtentOf>(object, "extent", "screen", "extent",
                                    {{"screen", ExtentOf::screen},
                                     {"map", ExtentOf::map},
                                     {"tile", ExtentOf::tile},
                                     {"fixed", ExtentOf::fixed}});
  texture.divisor = object.integer("divisor", 1);
  if (texture.extent == ExtentOf::fixed) {
    const std::vector<double> size = object.numbers("size", 3);
    if (object.has("divisor")) object.fail("divisor", "a fixed size has no divisor");
    for (std::size_t i = 0; i < 3; ++i) texture.size[i] = whole(object, "size", size[i], 16384);
  }
  texture.format = required_text(object, "format");
  texture.mips = object.integer("mips", 1);
  texture.layers = object.integer("layers", 1);
  texture.samples = object.integer("samples", 1);
  object.finish();
  return texture;
}

GraphBuffer read_buffer(JsonObject object) {
  GraphBuffer buffer;
  buffer.name = required_identifier(object, "name");
  buffer.where = object.where("name");
  buffer.words = object.integer("words", 0);
  buffer.words_per_texel = object.integer("words_per_texel", 0);
  buffer.texture = object.text("texture", "");
  buffer.divisor = object.integer("divisor", 1);
  buffer.indirect = object.boolean("indirect", false);
  constexpr int kMost = 1 << 24;
  if (buffer.words < 0 || buffer.words > kMost || buffer.words_per_texel < 0 || buffer.words_per_texel > 64)
    object.fail("name", "'" + buffer.name + "' has 0 to 2^24 words and 0 to 64 words per texel");
  if (buffer.words + buffer.words_per_texel == 0)
    object.fail("name", "'" + buffer.name + "' has no words",
                "give \"words\", or \"words_per_texel\" and \"texture\"");
  if ((buffer.words_per_texel > 0) == buffer.texture.empty())
    object.fail("name", "\"words_per_texel\" and \"texture\" must be used together");
  if (buffer.divisor < 1 || buffer.divisor > 64) object.fail("divisor", "a divisor is 1 to 64");
  if (buffer.divisor > 1 && buffer.texture.empty())
    object.fail("divisor", "it divides the size of the buffer's texture, and there is none");
  if (buffer.indirect && buffer.words < 3)
    object.fail("name", "numbers of groups take three words: '" + buffer.name + "' has " +
                            std::to_string(buffer.words));
  object.finish();
  return buffer;
}

GroupCount read_groups(JsonObject object) {
  GroupCount groups;
  if (object.has("fixed")) {
    const std::vector<double> fixed = object.numbers("fixed", 3);
    for (std::size_t i = 0; i < 3; ++i) {
      groups.fixed[i] = whole(object, "fixed", fixed[i], 65535);
    }
  }
  groups.texels_of = object.text("texels_of", "");
  groups.divisor = object.integer("divisor", 1);
  if (groups.divisor < 1 || groups.divisor > 64) object.fail("divisor", "a divisor is 1 to 64");
  if (groups.divisor > 1 && groups.texels_of.empty())
    object.fail("divisor", "it divides the size of \"texels_of\", and there is none");
  groups.indirect = object.text("indirect", "");
  object.finish();
  return groups;
}

void require_structs(JsonObject& object, const TechniqueList& list, const std::vector<std::string>& names) {
  require_at_most(object, "parameters", names.size(), 64, "structs of one pass");
  for (const std::string& name : names) {
    if (list.find_struct(name) != nullptr) continue;
    std::vector<std::string> known;
    for (const ParameterStruct& parameters : list.structs) known.push_back(parameters.name);
    require_known(object, "parameters", "struct", name, known);
  }
}

// These names become C# and uniforms.
std::vector<std::string> read_absent(JsonObject& object, const GraphPass& pass) {
  std::vector<std::string> absent = object.texts("absent");
  constexpr std::size_t kMost = 64;
  if (absent.size() > kMost)
    object.fail("absent", "a pass has at most " + std::to_string(kMost) + " absent textures");
  for (const std::string& name : absent) {
    if (!hlsl::is_identifier(name))
      object.fail("absent", "'" + name + "' is no identifier", "write what the program calls the texture");
    for (const auto& [shader_name, texture] : pass.reads)
      if (shader_name == name)
        object.fail("absent", "the pass reads '" + name + "'", R"(leave it out of "reads" or of "absent")");
    if (std::count(absent.begin(), absent.end(), name) > 1)
      object.fail("absent", "'" + name + "' stands there twice");
  }
  return absent;
}

GraphPass read_pass(JsonObject object, const TechniqueList& list, const ManifestFiles& files) {
  GraphPass pass;
  pass.name = required_text(object, "name");
  pass.where = object.where("name");
  pass.kind = chosen<PassKind>(object, "kind", "", "kind of pass",
                               {{"filter", PassKind::filter},
                                {"raster", PassKind::raster},
                                {"casters", PassKind::casters},
                                {"compute", PassKind::compute}});
  pass.frequency = chosen<Frequency>(
      object, "runs", "frame", "frequency",
      {{"frame", Frequency::frame}, {"cascade", Frequency::cascade}, {"bake", Frequency::bake}});
  if (object.has("filter")) pass.filter = read_filter(object.object("filter"), list, files);
  if (pass.kind != PassKind::filter) {
    const bool kernel = pass.kind == PassKind::compute;
    pass.file = files.required(object, kernel ? "compute" : "shader");
    pass.program = object.text(kernel ? "kernel" : "pass", pass.name);
    pass.reads = read_bindings(object.object("reads"));
    if (kernel) {
      pass.writes = read_bindings(object.object("writes"));
      for (auto& updated : read_bindings(object.object("updates"))) {
        pass.updates.push_back(updated.second);
        pass.writes.push_back(std::move(updated));
      }
    } else
      for (const std::string& target : object.texts("writes")) pass.writes.emplace_back("", target);
    pass.parameters = object.texts("parameters");
    require_structs(object, list, pass.parameters);
    if (!kernel) pass.stencil = object.text("stencil", "");
    if (pass.kind == PassKind::raster) pass.absent = read_absent(object, pass);
    if (pass.kind == PassKind::casters) {
      pass.depth = object.text("depth", "");
      pass.casters = chosen<DrawnCasters>(object, "casters", "opaque", "kind of casters",
                                          {{name_of(DrawnCasters::opaque), DrawnCasters::opaque},
                                           {name_of(DrawnCasters::blended), DrawnCasters::blended},
                                           {name_of(DrawnCasters::volumes), DrawnCasters::volumes}});
    } else {
      pass.each_mip = object.boolean("each_mip", false);
    }
    if (kernel) pass.groups = read_groups(object.object("groups"));
  }
  object.finish();
  return pass;
}

constexpr std::size_t kMostItems = 256;

template <typename Item>
void append(std::vector<Item>& items, const std::vector<Item>& more) {
  items.insert(items.end(), more.begin(), more.end());
}

void require_bounded(JsonObject& object, const PassGraph& graph) {
  if (graph.passes.size() + graph.textures.size() + graph.buffers.size() > kMostItems)
    object.fail("name",
                "a graph has at most " + std::to_string(kMostItems) + " passes, textures and buffers");
}

// check_graph() reports names that are not declared.
void give_shapes(std::vector<GraphTexture>& textures, const PassGraph& graph) {
  for (GraphTexture& texture : textures) {
    if (texture.previous_of.empty()) continue;
    const GraphTexture* now = graph.texture(texture.previous_of);
    if (now == nullptr) continue;
    GraphTexture shaped = *now;
    shaped.name = texture.name;
    shaped.where = texture.where;
    shaped.previous_of = texture.previous_of;
    texture = shaped;
  }
}

void add_once(std::vector<Need>& needs, Need need) {
  if (std::find(needs.begin(), needs.end(), need) == needs.end()) needs.push_back(need);
}

void read_needs(JsonObject& object, std::vector<Need>& needs) {
  std::vector<std::string> known;
  for (const Need need : all_needs()) known.emplace_back(name_of(need));
  for (const std::string& name : object.texts("needs")) {
    require_known(object, "needs", "input", name, known);
    for (const Need need : all_needs())
      if (name == name_of(need)) add_once(needs, need);
  }
}

void add(PassGraph& graph, const PassGraph& part) {
  append(graph.textures, part.textures);
  append(graph.buffers, part.buffers);
  append(graph.passes, part.passes);
  append(graph.keywords, part.keywords);
  append(graph.published, part.published);
  for (const Need need : part.needs) add_once(graph.needs, need);
  if (!part.visibility.empty()) graph.visibility = part.visibility;
  if (!part.mask.empty()) graph.mask = part.mask;
  if (!part.source.empty()) graph.source = part.source;
}

// Emitted code has names of files: in comments, and in quotes behind #include.
bool can_be_emitted(const std::string& name) {
  return is_one_line(name) && name.find_first_of("\"\\") == std::string::npos;
}

constexpr const char* kUnfitName =
    "a file's name is one line, with no quotes, no backslashes and no control characters";
constexpr const char* kFitName = "rename the file or its folder; folders are separated by /";

}  // namespace

ManifestFiles::ManifestFiles(const std::filesystem::path& manifest, const std::filesystem::path& package)
    : folder_(std::filesystem::absolute(manifest).parent_path()),
      package_(std::filesystem::absolute(package).lexically_normal()),
      tree_(project::own_tree(manifest)) {
  bounds_.add(tree_);
  if (!project::no_file_owns(package_)) bounds_.add(package_);
}

std::string ManifestFiles::required(JsonObject& object, const std::string& key) const {
  const std::string name = required_line(object, key);
  if (!can_be_emitted(name)) object.fail(key, kUnfitName, kFitName);
  const std::filesystem::path file = (folder_ / name).lexically_normal();
  if (!bounds_.contain(file))
    object.fail(key, "'" + name + "' lies outside of '" + tree_.string() + "', to which the manifest belongs",
                "keep a technique's files in the folder of its manifest, its package or its git repository");
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    object.fail(key, "there is no file '" + name + "' in '" + folder_.string() + "'",
                "files are named relative to the manifest");
  return named(file);
}

std::string ManifestFiles::named(const std::filesystem::path& file) const {
  const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
  const std::filesystem::path inside = whole.lexically_relative(package_);
  const bool outside = inside.empty() || *inside.begin() == "..";
  std::string name = (outside ? whole : inside).generic_string();
  if (!can_be_emitted(name)) throw InputError(name, kUnfitName, kFitName);
  return name;
}

FilterCall read_filter(JsonObject object, const TechniqueList& list, const ManifestFiles& files) {
  FilterCall filter;
  filter.file = files.required(object, "file");
  filter.function = required_identifier(object, "function");
  filter.arguments =
      object.has("arguments") ? object.texts("arguments") : std::vector<std::string>{"shadowMap"};
  filter.parameters = object.text("parameters", "");
  if (!filter.parameters.empty()) require_structs(object, list, {filter.parameters});
  object.finish();
  return filter;
}

PassGraph read_graph(JsonObject& object, const TechniqueList& list, const ManifestFiles& files,
                     const std::map<std::string, PassGraph>& known) {
  PassGraph graph;
  const std::vector<std::string> parts = object.texts("parts");
  require_at_most(object, "parts", parts.size(), kMostItems, "parts of one graph");
  for (const std::string& part : parts) {
    if (!known.contains(part)) {
      std::vector<std::string> names;
      for (const auto& [name, other] : known) names.push_back(name);
      require_known(object, "parts", "graph", part, names);
    }
    add(graph, known.at(part));
    require_bounded(object, graph);
  }
  for (const JsonObject& texture : entries(object, "textures", graph.textures.size(), kMostItems))
    graph.textures.push_back(read_texture(texture));
  for (const JsonObject& buffer : entries(object, "buffers", graph.buffers.size(), kMostItems))
    graph.buffers.push_back(read_buffer(buffer));
  for (const JsonObject& pass : entries(object, "passes", graph.passes.size(), kMostItems))
    graph.passes.push_back(read_pass(pass, list, files));
  require_bounded(object, graph);
  give_shapes(graph.textures, PassGraph(graph));
  append(graph.keywords, read_keywords(object, "keywords"));
  read_needs(object, graph.needs);
  graph.visibility = object.text("visibility", graph.visibility);
  graph.mask = object.text("mask", graph.mask);
  append(graph.published, object.texts("published"));
  require_at_most(object, "published", graph.published.size(), kMostItems, "published textures");
  graph.source = object.text("source", graph.source);
  object.finish();
  return graph;
}

}  // namespace penumbra::techniques
