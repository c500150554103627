// Direct3D 9 samplers, which combine a texture and a sampler: sampler1D, sampler2D, sampler3D, samplerCUBE,
// `sampler` where tex2D or a similar function reads it, and these functions
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-tex2d and the pages beside it). For some
// of them glslang produces a module that no Vulkan driver accepts; others it rejects.
//
// `sampler2D _MainTex;` becomes `Texture2D _MainTex; SamplerState sampler_MainTex;`, the names that Unity's
// own macros use. Wherever the sampler was a whole argument of tex2D, of a function or of a prototype, a
// member, or an array element, the pair replaces it; `a = b` becomes both assignments. The functions are
// defined once at the beginning of the text under their names, as documented: tex2Dlod(s, c) is
// t.SampleLevel(s, c.xy, c.w), tex2Dbias the same with SampleBias, tex2Dproj divides by c.w, tex2Dgrad and
// tex2D with four arguments are SampleGrad. As functions, they convert arguments as the built-in ones do, and
// evaluate them once. register(s1) becomes register(t1) for the texture and stays for the sampler; sampler
// states in the shader have no effect in Unity and are removed.
//
// Limits: the kind of a `sampler` follows from the functions that read it; a sampler read as two kinds is an
// error. A sampler that is returned or selected by ?: is an error. An index is evaluated twice.

#include "preparation/passes.h"

#include <algorithm>
#include <set>
#include <utility>

#include "preparation/dx9_functions.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

using Place = DeclaredValue::Place;

// A use of a sampler outside of its declaration: the tokens first to last; `name` is its name.
struct Use {
  std::size_t declared = npos;
  std::size_t first = npos;
  std::size_t name = npos;
  std::size_t last = npos;
  std::size_t callee = npos;  // the call of which it is a whole argument
  int argument = 0;           // number of that argument
  int arguments = 0;          // number of arguments
};

// A statement that declares one or several variables together.
struct Statement {
  std::size_t first = npos;
  std::size_t last = npos;
};

class Separation {
 public:
  explicit Separation(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (const DeclaredValue& value : declared()) dimensions_.push_back(dx9_dimension(value.type.name));
    for (const FunctionType& function : types_.functions())
      functions_[text_.word(function.name)].push_back(&function);
    find_uses();
    infer_dimensions();
    find_statements();
    for (std::size_t index = 0; index < declared().size(); ++index)
      if (is_dx9(index)) declare(index);
    for (const Use& use : uses_)
      if (is_dx9(use.declared)) separate(use);
    std::string definitions;
    for (const auto& [name, arguments] : needed_) definitions += dx9_definition(name, arguments) + " ";
    text_.insert_without_line(0, definitions);
    text_.apply();
  }

 private:
  const std::vector<DeclaredValue>& declared() const { return types_.declared(); }
  bool is_dx9(std::size_t index) const { return !dimensions_[index].empty(); }
  bool is_any_sampler(std::size_t index) const {
    return is_dx9(index) || declared()[index].type.name == "sampler";
  }

  void find_uses() {
    struct Open {
      std::size_t bracket;
      int argument;
    };
    std::vector<Open> open;
    count_arguments();
    for (std::size_t at = 0; at < text_.size(); ++at) {
      if (text_.is_any(at, "(", "[", "{")) open.push_back({at, 0});
      if (text_.is(at, ",") && !open.empty()) ++open.back().argument;
      const bool closes = text_.is_any(at, ")", "]", "}");
      if (closes && !open.empty()) open.pop_back();
      Use use = use_that_ends(at);
      if (use.declared == npos) continue;
      if (!open.empty() && text_.is(open.back().bracket, "("))
        as_argument(use, open.back().bracket, open.back().argument);
      uses_.push_back(use);
    }
  }

  // The argument separators of every pair of parentheses.
  void count_arguments() {
    commas_.assign(text_.size(), 0);
    std::vector<std::size_t> open;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      if (text_.matching_bracket(at) != npos && text_.matching_bracket(at) > at) open.push_back(at);
      if (text_.matching_bracket(at) != npos && text_.matching_bracket(at) < at && !open.empty())
        open.pop_back();
      if (text_.is(at, ",") && !open.empty()) ++commas_[open.back()];
    }
  }

  Use use_that_ends(std::size_t at) const {
    if (types_.begin(at) == npos || text_.is_any(at + 1, ".", "(")) return {};
    std::size_t name = at;
    while (text_.is(name, "]") && text_.matching_bracket(name) != npos && text_.matching_bracket(name) > 0)
      name = text_.matching_bracket(name) - 1;
    if (text_.is(at + 1, "[")) return {};
    const std::size_t index = text_.is_identifier(name) ? types_.named(name) : npos;
    if (index == npos || declared()[index].name == name || !is_any_sampler(index)) return {};
    Use use;
    use.declared = index;
    use.first = types_.begin(at);
    use.name = name;
    use.last = at;
    return use;
  }

  void as_argument(Use& use, std::size_t bracket, int argument) const {
    const bool whole = (text_.is_any(use.first - 1, "(", ",")) && (text_.is_any(use.last + 1, ",", ")"));
    if (!whole || bracket == 0 || !text_.is_identifier(bracket - 1)) return;
    use.callee = bracket - 1;
    use.argument = argument;
    use.arguments = commas_[bracket] + 1;
  }

  // The kind of a `sampler` follows from the functions that read it, directly or through parameters.
  void infer_dimensions() {
    constexpr int deepest = 16;

    for (int depth = 0; depth < deepest; ++depth) {
      bool changed = false;
      for (const Use& use : uses_) {
        if (declared()[use.declared].type.name != "sampler" || use.callee == npos) continue;
        changed = infer(use, dimension_by(use)) || changed;
      }
      if (!changed) return;
    }
  }

  std::string_view dimension_by(const Use& use) const {
    const std::optional<Dx9Function> function = dx9_function(text_.word(use.callee));
    if (function) return use.argument == 0 ? function->dimension : std::string_view{};
    const auto named = functions_.find(text_.word(use.callee));
    if (named == functions_.end()) return {};
    for (const FunctionType* callee : named->second) {
      if (callee->parameters.size() != static_cast<std::size_t>(use.arguments)) continue;
      const std::string_view dimension =
          dimensions_[callee->parameters[static_cast<std::size_t>(use.argument)]];
      if (!dimension.empty()) return dimension;
    }
    return {};
  }

  bool infer(const Use& use, std::string_view dimension) {
    std::string_view& known = dimensions_[use.declared];
    if (dimension.empty() || known == dimension) return false;
    if (known.empty()) {
      known = dimension;
      return true;
    }
    if (contradicted_.insert(use.declared).second)
      text_.error(use.name, "'" + text_.name(use.name) + "' is a sampler of " + texture_type(known) +
                                " elsewhere and of " + texture_type(dimension) +
                                " here; declare one for each, as sampler" + std::string(known) +
                                " and sampler" + std::string(dimension));
    return false;
  }

  std::string sampler_name(std::string_view of) const { return text_.free_name("sampler" + std::string(of)); }

  // Rewrites `sampler2D a : register(s0), b[2];` to `Texture2D a : register(t0), b[2]; SamplerState samplera
  // : ...;`.
  void declare(std::size_t index) {
    const DeclaredValue& value = declared()[index];
    if (value.type_at == npos) return;
    if (value.first != npos)
      text_.replace(value.type_at, value.type_end - value.type_at, texture_type(dimensions_[index]));
    const Statement& statement = statements_.at(value.type_at);
    const std::size_t first = statement.first;
    const std::string type = text_.spelled(first, value.type_at - first) + " SamplerState";
    const std::string name = value.name == npos
                                 ? std::string{}
                                 : " " + sampler_name(text_.word(value.name)) +
                                       text_.spelled(value.name + 1, value.end - value.name - 1);
    if (value.place == Place::parameter) {
      text_.replace(value.end, value.last - value.end, ", " + type + name);
      return;
    }
    const std::string rest = after_name(value);
    if (!text_.is_any(value.last, ";", ",")) return;
    text_.insert(statement.last + 1, type + name + rest + ";");
  }

  // Returns the tokens after the name of the new sampler; edits those after the texture's.
  std::string after_name(const DeclaredValue& value) {
    const bool is_variable = value.place == Place::local || value.is_static;
    if (text_.is(value.end, "=") && is_variable) {
      const Use* initial = use_at(value.end + 1, value.last);
      if (initial != nullptr) return " = " + sampler_of(*initial);
    }
    std::string annotation;
    if (text_.is(value.end, ":") && text_.is(value.end + 1, "register") && text_.is(value.end + 2, "(")) {
      const std::size_t close = text_.matching_bracket(value.end + 2);
      annotation = " " + text_.spelled(value.end, close - value.end + 1);
      std::string texture = annotation;
      const std::size_t letter = texture.find_last_of('(') + 1;
      const std::size_t space = std::min(texture.find_first_not_of(' ', letter), texture.size() - 1);
      if (texture[space] == 's') texture[space] = 't';
      text_.replace(value.end, value.last - value.end, texture);
    } else {
      text_.erase(value.end, value.last - value.end);
    }
    return annotation;
  }

  // Finds the first and last token of statements with several variables, by the token of their common type.
  void find_statements() {
    for (const DeclaredValue& value : declared()) {
      if (value.type_at == npos) continue;
      Statement& statement = statements_[value.type_at];
      if (value.first != npos) statement.first = value.first;
      statement.last = value.last;
    }
  }

  // Returns the use that spans exactly [first, end).
  const Use* use_at(std::size_t first, std::size_t end) const {
    const auto found = std::lower_bound(uses_.begin(), uses_.end(), end,
                                        [](const Use& use, std::size_t at) { return use.last + 1 < at; });
    const bool whole = found != uses_.end() && found->first == first && found->last + 1 == end;
    return whole && is_dx9(found->declared) ? &*found : nullptr;
  }

  // Returns the same chain, with the sampler's name.
  std::string sampler_of(const Use& use) const {
    return text_.spelled(use.first, use.name - use.first) + sampler_name(text_.word(use.name)) +
           text_.spelled(use.name + 1, use.last - use.name);
  }

  void separate(const Use& use) {
    if (use.callee != npos) {
      text_.insert(use.last + 1, ", " + sampler_of(use));
      if (use.argument == 0 && !is_defined(use)) needed_.emplace(text_.word(use.callee), use.arguments);
      return;
    }
    if (text_.is(use.first - 1, "=") && text_.is(use.last + 1, ";")) return;  // reported at the assignment
    if (text_.is(use.last + 1, "=") && assign(use)) return;
    text_.error(use.name,
                "'" + text_.name(use.name) +
                    "' is a Direct3D 9 sampler, which here can be sampled, assigned "
                    "or passed to a function and nothing else; declare a texture and a SamplerState instead");
  }

  bool assign(const Use& to) {
    std::size_t end = to.last + 2;
    while (end < text_.size() && !text_.is(end, ";")) ++end;
    const Use* from = use_at(to.last + 2, end);
    if (from == nullptr) return false;
    text_.insert(end, ", " + sampler_of(to) + " = " + sampler_of(*from));
    return true;
  }

  // Returns whether the text itself defines a function of that name for such a sampler.
  bool is_defined(const Use& use) const {
    const auto named = functions_.find(text_.word(use.callee));
    if (named == functions_.end()) return false;
    return std::any_of(named->second.begin(), named->second.end(), [&](const FunctionType* function) {
      return function->parameters.size() == static_cast<std::size_t>(use.arguments) &&
             dimensions_[function->parameters[0]] == dimensions_[use.declared];
    });
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<std::string_view> dimensions_;  // for each declared value; empty if it is no such sampler
  std::vector<int> commas_;
  std::vector<Use> uses_;  // uses in the order of the text
  std::set<std::size_t> contradicted_;
  std::unordered_map<std::string_view, std::vector<const FunctionType*>> functions_;
  std::unordered_map<std::size_t, Statement> statements_;
  std::set<std::pair<std::string_view, int>> needed_;  // functions to be defined, with their arguments
};

}  // namespace

void separate_dx9_samplers(TokenText& text) {
  const auto& tokens = text.tokens();
  const bool any = std::any_of(tokens.begin(), tokens.end(), [](const hlsl::Token& token) {
    return token.spelling[0] == 's' &&
           (token.spelling == "sampler" || !dx9_dimension(token.spelling).empty());
  });
  if (any) Separation(text).run();
}

}  // namespace penumbra::preparation
