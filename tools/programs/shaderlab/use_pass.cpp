#include "shaderlab/use_pass.h"

#include <algorithm>

#include "input/nearest_name.h"
#include "shaderlab/characters.h"
#include "shaderlab/located_diagnostic.h"

namespace penumbra::shaderlab {

namespace {

constexpr int kLongestChain = 16;

struct Path {
  std::string shader;
  std::string pass;
};

// The last '/' separates the two; shader names may contain slashes.
Path split(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return {{}, path};
  return {path.substr(0, slash), path.substr(slash + 1)};
}

std::string known_as(const Pass& pass) {
  return upper(pass.kind == Pass::Kind::use_pass ? split(pass.name.text).pass : pass.name.text);
}

std::vector<std::string> pass_names(const Shader& shader) {
  std::vector<std::string> names;
  for (const SubShader& sub_shader : shader.sub_shaders)
    for (const Pass& pass : sub_shader.passes)
      if (pass.kind != Pass::Kind::grab_pass && !pass.name.text.empty()) names.push_back(known_as(pass));
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

FoundPass find_pass(const Shader& shader, const std::string& name) {
  for (const SubShader& sub_shader : shader.sub_shaders)
    for (const Pass& pass : sub_shader.passes)
      if (pass.kind != Pass::Kind::grab_pass && known_as(pass) == name)
        return {&shader, &sub_shader, &pass, {}};
  return {};
}

class Resolver {
 public:
  Resolver(const Shader& user, const Pass& use, const std::vector<const Shader*>& shaders)
      : user_(user), use_(use), shaders_(shaders) {}

  FoundPass run() {
    FoundPass found;
    std::string path = use_.name.text;
    for (int i = 0; i < kLongestChain; ++i) {
      found = step(path);
      if (found.pass == nullptr || found.pass->kind == Pass::Kind::pass) return found;
      path = found.pass->name.text;
    }
    return failure(hlsl::Severity::error,
                   "UsePass \"" + use_.name.text + "\" leads from UsePass to UsePass and never to a Pass");
  }

 private:
  FoundPass failure(hlsl::Severity severity, const std::string& message) const {
    FoundPass none;
    none.diagnostic = diagnostic_at(user_.file, user_.text, use_.name.place, severity, message);
    return none;
  }

  FoundPass step(const std::string& path) const {
    const Path names = split(path);
    if (names.shader.empty() || names.pass.empty())
      return failure(hlsl::Severity::error,
                     "UsePass \"" + path + "\" names no Pass: write \"Shader/Name/PASSNAME\"");
    const auto shader = std::find_if(shaders_.begin(), shaders_.end(), [&](const Shader* candidate) {
      return candidate->name.text == names.shader;
    });
    if (shader == shaders_.end()) return no_shader(names);
    FoundPass found = find_pass(**shader, upper(names.pass));
    return found.pass == nullptr ? no_pass(**shader, names) : found;
  }

  FoundPass no_shader(const Path& names) const {
    std::vector<std::string> known;
    for (const Shader* shader : shaders_) known.push_back(shader->name.text);
    const std::string nearest = nearest_name(names.shader, known);
    return failure(hlsl::Severity::warning,
                   "UsePass needs the shader \"" + names.shader + "\", which is not among those read" +
                       (nearest.empty() ? "" : ": did you mean \"" + nearest + "\"?"));
  }

  FoundPass no_pass(const Shader& shader, const Path& names) const {
    const std::vector<std::string> known = pass_names(shader);
    return failure(hlsl::Severity::error,
                   "the shader \"" + names.shader + "\" has no Pass named " + upper(names.pass) + ": " +
                       (known.empty() ? "none of its passes has a name"
                                      : unknown_name_remedy(upper(names.pass), known)));
  }

  const Shader& user_;
  const Pass& use_;
  const std::vector<const Shader*>& shaders_;
};

}  // namespace

FoundPass resolve_use_pass(const Shader& user, const Pass& use, const std::vector<const Shader*>& shaders) {
  return Resolver(user, use, shaders).run();
}

}  // namespace penumbra::shaderlab
