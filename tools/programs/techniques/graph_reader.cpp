#include "techniques/graph_reader.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "input/enumerator.h"
#include "input/input_error.h"
#include "input/text_line.h"

namespace penumbra::techniques {
namespace {

// Returns the value of that name: the schema lets no other name through.
template <typename Value>
Value of_name(const std::string& name) {
  return enumerator_named<Value>(name, names_of<Value>).value();
}

std::vector<std::pair<std::string, std::string>> read_bindings(JsonObject object) {
  std::vector<std::pair<std::string, std::string>> bindings;
  for (const std::string& key : object.keys()) bindings.emplace_back(key, object.text(key, ""));
  return bindings;
}

void read_numbers(JsonObject& object, const std::string& key, std::array<int, 3>& numbers) {
  if (!object.has(key)) return;
  const std::vector<double> given = object.numbers(key, numbers.size());
  std::transform(given.begin(), given.end(), numbers.begin(), [](double n) { return static_cast<int>(n); });
}

GraphTexture read_texture(JsonObject object) {
  GraphTexture texture;
  texture.name = object.text("name", "");
  texture.where = object.where("name");
  texture.previous_of = object.text("previous_of", "");
  texture.extent = of_name<ExtentOf>(object.text("extent", name_of(ExtentOf::screen)));
  texture.divisor = object.integer("divisor", 1);
  read_numbers(object, "size", texture.size);
  texture.format = object.text("format", texture.format);
  texture.mips = object.integer("mips", 1);
  texture.layers = object.integer("layers", 1);
  texture.samples = object.integer("samples", 1);
  return texture;
}

GroupCount read_groups(JsonObject object) {
  GroupCount groups;
  read_numbers(object, "fixed", groups.fixed);
  groups.texels_of = object.text("texels_of", "");
  groups.divisor = object.integer("divisor", 1);
  return groups;
}

void require_structs(JsonObject& object, const TechniqueList& list, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (list.find_struct(name) != nullptr) continue;
    std::vector<std::string> known;
    for (const ParameterStruct& parameters : list.structs) known.push_back(parameters.name);
    require_known(object, "parameters", "struct", name, known);
  }
}

std::vector<std::string> read_absent(JsonObject& object, const GraphPass& pass) {
  std::vector<std::string> absent = object.texts("absent");
  for (const std::string& name : absent) {
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
  pass.name = object.text("name", "");
  pass.where = object.where("name");
  pass.kind = of_name<PassKind>(object.text("kind", ""));
  pass.frequency = of_name<Frequency>(object.text("runs", name_of(Frequency::frame)));
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
    pass.stencil = object.text("stencil", "");
    pass.absent = read_absent(object, pass);
    pass.depth = object.text("depth", "");
    pass.casters = of_name<DrawnCasters>(object.text("casters", name_of(DrawnCasters::opaque)));
    pass.each_mip = object.boolean("each_mip", false);
    pass.groups = read_groups(object.object("groups"));
  }
  return pass;
}

constexpr std::size_t kMostItems = 256;

template <typename Item>
void append(std::vector<Item>& items, const std::vector<Item>& more) {
  items.insert(items.end(), more.begin(), more.end());
}

void require_bounded(JsonObject& object, const PassGraph& graph) {
  if (graph.passes.size() + graph.textures.size() > kMostItems)
    object.fail("name", "a graph has at most " + std::to_string(kMostItems) + " passes and textures");
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
  for (const std::string& name : object.texts("needs")) add_once(needs, of_name<Need>(name));
}

void add(PassGraph& graph, const PassGraph& part) {
  append(graph.textures, part.textures);
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
  const std::string name = object.text(key, "");
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
  filter.function = object.text("function", "");
  filter.arguments =
      object.has("arguments") ? object.texts("arguments") : std::vector<std::string>{"shadowMap"};
  filter.parameters = object.text("parameters", "");
  if (!filter.parameters.empty()) require_structs(object, list, {filter.parameters});
  return filter;
}

PassGraph read_graph(JsonObject& object, const TechniqueList& list, const ManifestFiles& files,
                     const std::map<std::string, PassGraph>& known) {
  PassGraph graph;
  for (const std::string& part : object.texts("parts")) {
    if (!known.contains(part)) {
      std::vector<std::string> names;
      for (const auto& [name, other] : known) names.push_back(name);
      require_known(object, "parts", "graph", part, names);
    }
    add(graph, known.at(part));
    require_bounded(object, graph);
  }
  for (const JsonObject& texture : object.objects("textures"))
    graph.textures.push_back(read_texture(texture));
  for (const JsonObject& pass : object.objects("passes"))
    graph.passes.push_back(read_pass(pass, list, files));
  require_bounded(object, graph);
  give_shapes(graph.textures, PassGraph(graph));
  append(graph.keywords, read_keywords(object));
  read_needs(object, graph.needs);
  graph.visibility = object.text("visibility", graph.visibility);
  graph.mask = object.text("mask", graph.mask);
  append(graph.published, object.texts("published"));
  require_at_most(object, "published", graph.published.size(), kMostItems, "published textures");
  graph.source = object.text("source", graph.source);
  return graph;
}

}  // namespace penumbra::techniques
