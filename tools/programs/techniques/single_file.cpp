#include "techniques/single_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "input/input_error.h"
#include "input/text_file.h"
#include "platform/data_directory.h"
#include "preprocessing/preprocessor.h"
#include "project/include_bounds.h"
#include "project/include_search.h"
#include "techniques/emitted_text.h"
#include "techniques/parameter_packing.h"
#include "techniques/technique_call.h"

namespace penumbra::techniques {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

using preprocessing::CutSource;
using preprocessing::Item;
using preprocessing::Step;

bool begins_condition(const Item& item) {
  return item.step == Step::on_condition || item.step == Step::on_defined || item.step == Step::on_undefined;
}

// Returns whether all of the source is in `#ifndef G`, `#define G`, ..., `#endif`.
bool has_guard(const CutSource& source) {
  const std::vector<Item>& items = source.items;
  return items.size() > 2 && items[0].step == Step::on_undefined && items[1].step == Step::define &&
         source.definitions[items[1].index].name == items[0].index && items[0].next + 1 == items.size();
}

class Paste {
 public:
  Paste(const TechniqueList& list, const Technique& technique) : package_(list.package) {
    roots_.packages.push_back({kPackage, library_});
    roots_.directories = list.include_directories();
    roots_.own.push_back(project::own_tree(fs::absolute(list.package / technique.file())));
  }

  // Adds the text of a file; an empty path says that it is in none.
  void add(const std::string& text, const fs::path& file) {
    const std::vector<std::string> lines = lines_of(text);
    const CutSource source = preprocessor_.cut(text);
    const bool guarded = has_guard(source);
    std::map<std::size_t, const Item*> directives;  // by index of their line
    std::set<std::size_t> code;                     // indices of lines with code
    for (const Item& item : source.items) {
      if (item.step != Step::run) {
        directives.emplace(item.place.line - 1, &item);
        continue;
      }
      const preprocessing::Run& run = source.runs[item.index];
      for (std::size_t at = run.first; at < run.last; ++at) code.insert(source.places[at].line - 1);
    }
    std::string own = "\n// ---- " + (file.empty() ? "what to bind and to call" : name_of(file)) + "\n";
    bool has_code = false;
    int depth = guarded ? -1 : 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto directive = directives.find(i);
      const Item* const item = directive == directives.end() ? nullptr : directive->second;
      if (item != nullptr && begins_condition(*item)) ++depth;
      if (item != nullptr && item->step == Step::end) --depth;
      // The condition of a guard goes, its #define stays.
      const bool of_guard = guarded && item != nullptr;
      if (of_guard && (item == &source.items.front() || item == &source.items.back())) continue;
      if (item != nullptr && item->once) continue;
      const std::string where = file.string() + ":" + std::to_string(i + 1);
      if (item != nullptr && item->step == Step::problem && lines[i].find("include") != std::string::npos)
        throw InputError(where, "an #include of a macro cannot be pasted", "write the file's name");
      const std::optional<fs::path> included = item != nullptr && item->step == Step::include
                                                   ? included_file(source.includes[item->index], file, where)
                                                   : std::nullopt;
      if (!included) {
        has_code =
            has_code || code.contains(i) || (item != nullptr && !(of_guard && item == &source.items[1]));
        if (!lines[i].empty() || !own.ends_with("\n\n")) own += lines[i] + "\n";
      } else if (pasted_.insert(*included).second) {
        if (depth > 0)
          throw InputError(where, "an #include in a condition cannot be pasted",
                           "include the file unconditionally");
        if (has_code) text_ += std::exchange(own, "");
        add(read_found_text_file(*included), *included);
      }
    }
    while (own.ends_with("\n\n")) own.pop_back();
    text_ += own;
  }

  const std::string& text() const { return text_; }
  const std::set<fs::path>& pasted() const { return pasted_; }

  // The name is relative to the package or to the library, and has no folder of this machine.
  std::string name_of(const fs::path& file) const {
    for (const fs::path& root : {package_, library_}) {
      const fs::path inside = fs::absolute(file).lexically_normal().lexically_relative(
          fs::absolute(root / "").lexically_normal());
      if (!inside.empty() && *inside.begin() != "..") return inside.generic_string();
    }
    return file.filename().string();
  }

  const fs::path& library() const { return library_; }

 private:
  static constexpr const char* kPackage = "com.penumbra.shadows";

  // There is no file where the #include is of another package than this library: it stays.
  std::optional<fs::path> included_file(const std::string& asked, const fs::path& file,
                                        const std::string& where) const {
    if (asked.starts_with("Packages/") && asked.find(kPackage) == std::string::npos) return std::nullopt;
    const project::IncludeSearch search = project::find_include(roots_, asked, file);
    if (!search.file) throw InputError(where, search.problem);
    return search.file;
  }

  fs::path package_;
  fs::path library_ = platform::data_directory();
  project::IncludeRoots roots_;
  preprocessing::Preprocessor preprocessor_;
  std::set<fs::path> pasted_;
  std::string text_;
};

// The comments of the head: what follows a broken line stands two columns further in.
std::string comment(const std::string& indent, const std::string& text) {
  return comment_lines(text, "//" + indent, "//" + indent + "  ");
}

std::string commented(const std::string& text) {
  std::string lines;
  for (const std::string& line : lines_of(text)) lines += line.empty() ? "//\n" : "// " + line + "\n";
  return lines;
}

// Links of Markdown call a heading so: "apache-license-version-20".
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ')
      anchor += c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return anchor;
}

// The result has the sections that name a pasted file, and those that these refer to.
std::string notices(const Paste& paste) {
  const std::string all = read_found_text_file(paste.library() / "Third Party Notices.md");
  std::string chosen;
  for (std::size_t at = all.find("\n## "); at != std::string::npos;) {
    const std::size_t next = all.find("\n## ", at + 1);
    const std::string section = all.substr(at, next - at);
    const std::string heading = section.substr(4, section.find('\n', 1) - 4);
    const bool named = std::any_of(paste.pasted().begin(), paste.pasted().end(), [&](const fs::path& file) {
      return section.find("`" + paste.name_of(file) + "`") != std::string::npos;
    });
    if (named || chosen.find("(#" + anchor_of(heading) + ")") != std::string::npos) chosen += section;
    at = next;
  }
  return chosen;
}

std::string texture_use(const GraphTexture& texture, const PassGraph& graph) {
  std::string text = argument_name(texture.name) + ": " + texture.format + ", written by";
  for (const GraphPass& pass : graph.passes)
    if (pass.kind != PassKind::filter && writes_to(pass, texture.name))
      text += " " + pass.program + " of " + pass.file;
  return text;
}

std::string argument_use(const std::string& argument, const PassGraph& graph) {
  if (argument == shadow_map_name)
    return "_ShadowMap: the shadow map's stored depths, 0 to 1; sampler_ShadowMap: compares, linear, "
           "clamped; a "
           "receiver passes that is as near to the light as the texel or nearer";
  if (argument == "pointSampler") return "sampler_PointClamp: nearest texel, clamped";
  if (argument == "linearSampler") return "sampler_LinearClamp: linear, clamped";
  if (argument == spot_light_name)
    return "_PenumbraSpotLight: near plane, m; far plane, m; tangent of half the map's angle; the source's "
           "radius, m";
  const GraphTexture* texture = graph.texture(argument);
  return texture == nullptr ? argument_name(argument) + ": a texture" : texture_use(*texture, graph);
}

// Each vector is named, and of each component the field, its value, its unit and what it is.
template <typename Name>
std::string struct_uses(const ParameterStruct& parameters,
                        const std::map<std::string, std::vector<double>>& values, Name name) {
  std::string text;
  const std::vector<PackedPlace> places = packed_places(parameters);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ParameterField& field = parameters.fields[i];
    if (places[i].component == 0) text += comment("   ", name(places[i].vector) + ":");
    const auto components = std::string_view("xyzw").substr(places[i].component, component_count(field));
    text += comment("     ", fmt::format("{}: {} = {:g}; {}: {}", components, field.name,
                                         fmt::join(values.at(field.name), ", "), field.unit, field.doc));
  }
  return text;
}

std::string uses(const TechniqueList& list, const Technique& technique) {
  const PassGraph& graph = technique.graph;
  std::string text;
  std::set<std::string> named;
  const auto add_arguments = [&](const FilterCall& filter) {
    for (const std::string& argument : filter.arguments)
      if (named.insert(argument).second) text += comment("   ", argument_use(argument, graph));
  };
  add_arguments(*graph.filter());
  if (const ParameterStruct* parameters = list.find_struct(graph.filter()->parameters))
    text += struct_uses(*parameters, technique.values,
                        [&](std::size_t i) { return "float4 " + uniform_name(*parameters, i); });
  for (const CascadeRule& rule : technique.cascades) {
    add_arguments(rule.filter);
    if (const ParameterStruct* parameters = list.find_struct(rule.filter.parameters))
      text += struct_uses(*parameters, values_of(rule, technique),
                          [&](std::size_t i) { return "float4 " + uniform_name(*parameters, i, rule); });
  }
  return text;
}

std::string head(const TechniqueList& list, const Technique& technique, const std::string& version,
                 const Paste& paste) {
  std::string text = comment(" ", "Penumbra " + version + ": the technique " + technique.name + ", " +
                                      technique.title + ", in one file without includes.");
  text += comment(" ", "Written by `penumbra emit --single-file " + technique.name + "`.") + "//\n";
  text += comment(" ", "Source: " + technique.source);
  if (!technique.use_when.empty()) text += comment(" ", "Use it: " + technique.use_when);
  if (!technique.not_when.empty()) text += comment(" ", "Not: " + technique.not_when);
  text +=
      comment(" ",
              "Call: float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile, int cascade), which "
              "is at the end of this file; 1 is lit. The structs say their units where they are declared. "
              "Cascade 0 is the nearest.");
  text +=
      comment(" ",
              "Define: UNITY_REVERSED_Z as 1 before this file where stored depth is 1 at the light. The "
              "macros of textures are those of Unity's core package where it stands before this file, "
              "else those below. The program that includes this file needs `#pragma target 4.5` or more.");
  text += comment(" ", "Bind, with the values that the technique is measured with:");
  return text + uses(list, technique) + "//\n" +
         commented(read_found_text_file(paste.library() / "LICENSE.md")) + commented(notices(paste));
}

}  // namespace

SingleFile single_file(const TechniqueList& list, const Technique& technique, const std::string& version) {
  if (technique.graph.filter_pass() == nullptr)
    throw InputError("",
                     "'" + technique.name + "' draws its visibility by passes, which no function replaces",
                     "name a technique that ends in a filter");
  Paste paste(list, technique);
  std::string keywords;
  for (const std::string& keyword : technique.keywords) keywords += "#define " + keyword + " 1\n";
  paste.add(emit_technique_call(list, technique).source(), {});
  return {head(list, technique, version, paste) + keywords + paste.text(),
          {paste.pasted().begin(), paste.pasted().end()}};
}

}  // namespace penumbra::techniques
