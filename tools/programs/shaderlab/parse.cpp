#include "shaderlab/parse.h"

#include <utility>

#include "hlsl/name_set.h"
#include "hlsl/source_text.h"
#include "shaderlab/characters.h"
#include "shaderlab/commands.h"
#include "shaderlab/cursor.h"
#include "shaderlab/lexer.h"
#include "shaderlab/properties.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

namespace {

struct KnownTag {
  const char* key;
  std::vector<std::string> values;
  bool others_allowed = false;  // user-defined names: only likely typing errors are reported
};

const std::vector<KnownTag>& known_tags() {
  static const std::vector<std::string> truth{"True", "False"};
  static const std::vector<KnownTag> tags{
      {"Queue", {"Background", "Geometry", "AlphaTest", "Transparent", "Overlay"}},
      // The last two belong to older versions, and to Unity's own pages about them.
      {"RenderPipeline",
       {"UniversalPipeline", "HDRenderPipeline", "UniversalRenderPipeline", "LightweightPipeline"},
       true},
      {"DisableBatching", {"True", "False", "LODFading"}},
      {"ForceNoShadowCasting", truth},
      {"IgnoreProjector", truth},
      {"CanUseSpriteAtlas", truth},
      {"PreviewType", {"Sphere", "Plane", "Skybox", "Cube"}, true}};
  return tags;
}

// Returns "Transparent" for "Transparent+10".
std::string_view without_offset(std::string_view queue) {
  return trimmed(queue.substr(0, queue.find_first_of("+-")));
}

// The values of tags that Unity itself interprets.
//
// https://docs.unity3d.com/Manual/SL-SubShaderTags.html and SL-PassTags.html. Unity accepts an unknown value:
// the tag then has no effect, or the SubShader is never selected.
//
// Says why the tag's value has no effect; empty for a known one, and for tags with arbitrary names.
std::string tag_problem(const Tag& tag) {
  for (const KnownTag& known : known_tags()) {
    if (!same_keyword(known.key, tag.key.text)) continue;
    const bool is_queue = known.key == std::string_view("Queue");
    const std::string_view value =
        is_queue ? without_offset(tag.value.text) : std::string_view(tag.value.text);
    if (value.empty() || is_digit(value.front())) return {};
    if (std::any_of(known.values.begin(), known.values.end(),
                    [&](const std::string& name) { return same_keyword(name, value); }))
      return {};
    const std::string hint = near_name_hint(value, known.values);
    if (hint.empty() && known.others_allowed) return {};
    return "'" + std::string(value.substr(0, 40)) + "' is not a known value of the tag " + known.key +
           (hint.empty() ? "" : ": " + hint);
  }
  return {};
}

constexpr int kDeepestCategory = 32;

// Keywords of other scopes: in the wrong braces they indicate that a '}' is missing.
const std::vector<std::string> kStructureWords = hlsl::names_in(
    "Shader Properties SubShader Category Pass UsePass GrabPass Fallback Dependency CustomEditor "
    "CustomEditorForRenderPipeline");

class StructureParser {
 public:
  StructureParser(Cursor& cursor, Shader& shader) : cursor_(cursor), shader_(shader) {}

  void parse() {
    if (!cursor_.take_word("Shader")) cursor_.fail("Shader \"Name\"");
    shader_.name = cursor_.expect_text("the shader's name");
    const Owner owner{"Shader", shader_.name.place.line};
    cursor_.expect_mark('{', "after the shader's name");
    while (!closes(owner)) shader_item(owner);
    trailing();
  }

 private:
  // The owner of the braces that are being read.
  struct Owner {
    const char* kind;
    int line;
    std::string text() const { return "the " + std::string(kind) + " of line " + std::to_string(line); }
  };

  bool closes(const Owner& owner) {
    if (cursor_.at_end()) cursor_.fail("'}' for " + owner.text());
    return cursor_.take_punctuation('}');
  }

  void shader_item(const Owner& owner) {
    if (cursor_.take_word("Properties")) {
      parse_properties(cursor_, shader_.properties);
    } else if (cursor_.at_word("SubShader")) {
      sub_shader(-1);
    } else if (cursor_.at_word("Category")) {
      category(-1, 1);
    } else if (cursor_.take_word("Fallback")) {
      fallback();
    } else if (cursor_.take_word("Dependency")) {
      dependency();
    } else if (cursor_.take_word("CustomEditor")) {
      cursor_.expect_text("the name of the editor's class");
    } else if (cursor_.take_word("CustomEditorForRenderPipeline")) {
      cursor_.expect_text("the name of the editor's class");
      cursor_.expect_text("the pipeline asset's class");
    } else {
      other(owner, {"Properties", "SubShader", "Category", "Fallback", "Dependency", "CustomEditor"});
    }
  }

  void fallback() {
    if (cursor_.take_word("Off")) return;
    cursor_.expect_text("Off or a shader's name");
    if (cursor_.take_punctuation(',')) cursor_.expect_number("the fallback's level of detail");
  }

  void dependency() {
    const Name role = cursor_.expect_text("what the dependency is for");
    cursor_.expect_mark('=', "after " + role.text);
    cursor_.expect_text("the shader depended on");
  }

  void category(int parent, int depth) {
    const Place place = cursor_.take().place;
    if (depth > kDeepestCategory)
      cursor_.fail_at(place,
                      "Category is nested in more than " + std::to_string(kDeepestCategory) + " others");
    const Owner owner{"Category", place.line};
    cursor_.expect_mark('{', "after Category");
    const std::size_t index = shader_.categories.size();
    shader_.categories.push_back({place, parent, {}});
    while (!closes(owner)) {
      if (cursor_.at_word("SubShader")) {
        sub_shader(static_cast<int>(index));
      } else if (cursor_.at_word("Category")) {
        category(static_cast<int>(index), depth + 1);
      } else if (!setting(shader_.categories[index].settings)) {
        other(owner, {"SubShader", "Category", "Tags", "LOD"});
      }
    }
  }

  void sub_shader(int category) {
    const Place place = cursor_.take().place;
    const Owner owner{"SubShader", place.line};
    cursor_.expect_mark('{', "after SubShader");
    shader_.sub_shaders.push_back({place, category, {}, {}, {}});
    SubShader& parsed = shader_.sub_shaders.back();
    while (!closes(owner)) {
      if (cursor_.at_word("Pass")) {
        pass(parsed);
      } else if (cursor_.at_word("UsePass")) {
        const Place use = cursor_.take().place;
        parsed.passes.push_back(
            {Pass::Kind::use_pass, use, cursor_.expect_text("\"Shader/PASSNAME\" for UsePass,"), {}, {}});
      } else if (cursor_.at_word("GrabPass")) {
        grab_pass(parsed);
      } else if (cursor_.at(Token::Kind::program)) {
        parsed.programs.push_back(cursor_.take_program());
      } else if (!setting(parsed.settings)) {
        other(owner, {"Pass", "UsePass", "GrabPass", "Tags", "LOD", "PackageRequirements"});
      }
    }
  }

  void pass(SubShader& sub_shader) {
    const Place place = cursor_.take().place;
    const Owner owner{"Pass", place.line};
    cursor_.expect_mark('{', "after Pass");
    sub_shader.passes.push_back({Pass::Kind::pass, place, {}, {}, {}});
    Pass& parsed = sub_shader.passes.back();
    while (!closes(owner)) {
      if (cursor_.take_word("Name")) {
        parsed.name = cursor_.expect_text("the name of the Pass");
      } else if (cursor_.at(Token::Kind::program)) {
        parsed.programs.push_back(cursor_.take_program());
      } else if (!setting(parsed.settings)) {
        other(owner, {"Name", "Tags", "LOD", "PackageRequirements"});
      }
    }
  }

  // Reads GrabPass { }, GrabPass { "_TextureName" }, also with Name and Tags.
  void grab_pass(SubShader& sub_shader) {
    Pass grab{Pass::Kind::grab_pass, cursor_.take().place, {}, {}, {}};
    const Owner owner{"GrabPass", grab.place.line};
    cursor_.expect_mark('{', "after GrabPass");
    while (!closes(owner)) {
      if (cursor_.at(Token::Kind::string)) {
        grab.name = name_of(cursor_.take());
      } else if (cursor_.take_word("Name")) {
        cursor_.expect_text("the name of the GrabPass");
      } else if (!setting(grab.settings)) {
        other(owner, {"Name", "Tags"});
      }
    }
    sub_shader.passes.push_back(std::move(grab));
  }

  bool setting(Settings& settings) {
    if (cursor_.take_word("Tags")) {
      tags(settings.tags);
    } else if (cursor_.take_word("LOD")) {
      cursor_.expect_number("a number for LOD");
    } else if (cursor_.take_word("PackageRequirements")) {
      requirements();
    } else if (cursor_.at_word("Name")) {  // Unity reads one here, too: shaders of TextMesh Pro have it
      cursor_.warn(cursor_.take().place, "this Name is in no Pass and names nothing");
      cursor_.expect_text("the name");
    } else if (at_command(cursor_)) {
      settings.commands.push_back(parse_command(cursor_));
    } else {
      return false;
    }
    return true;
  }

  void tags(std::vector<Tag>& tags) {
    cursor_.expect_mark('{', "after Tags");
    while (!cursor_.take_punctuation('}')) {
      if (!tags.empty() && cursor_.at_punctuation(',')) {
        cursor_.warn(cursor_.take().place, "tags are written without a comma between them");
        continue;
      }
      if (!cursor_.at(Token::Kind::string)) cursor_.fail("a tag in quotes or '}' in Tags");
      Tag tag{name_of(cursor_.take()), {}};
      cursor_.expect_mark('=', "after the tag \"" + tag.key.text + "\"");
      tag.value = cursor_.expect_text("the value of \"" + tag.key.text + "\"");
      if (const std::string problem = tag_problem(tag); !problem.empty())
        cursor_.warn(tag.value.place, problem);
      tags.push_back(std::move(tag));
    }
  }

  void requirements() {
    cursor_.expect_mark('{', "after PackageRequirements");
    while (!cursor_.take_punctuation('}')) {
      if (!cursor_.at(Token::Kind::string)) cursor_.fail("a package in quotes or '}' in PackageRequirements");
      const Name package = name_of(cursor_.take());
      if (cursor_.take_punctuation(':')) cursor_.expect_text("the versions of " + package.text);
    }
  }

  // Reports a token that none of the owner's rules accepts.
  void other(const Owner& owner, const std::vector<std::string>& known) {
    if (cursor_.at(Token::Kind::program)) cursor_.fail_at(cursor_.peek().place, misplaced_program(owner));
    if (!cursor_.at(Token::Kind::identifier) || at_command(cursor_))
      cursor_.fail(known.front() + ", another item or '}' in " + owner.text());
    const Token& word = cursor_.peek();
    if (std::any_of(kStructureWords.begin(), kStructureWords.end(),
                    [&](const std::string& name) { return same_keyword(name, word.spelling); })) {
      cursor_.fail_at(word.place, "'" + std::string(word.spelling) + "' is not allowed in " + owner.text() +
                                      ": is its '}' missing?");
    }
    skip_unknown_command(cursor_, known);
  }

  std::string misplaced_program(const Owner& owner) const {
    return std::string(cursor_.peek().spelling) + " is in " + owner.text() +
           ": a program belongs in a Pass, a surface shader in a SubShader";
  }

  void trailing() {
    if (cursor_.at_end()) return;
    const Token first = cursor_.peek();
    if (first.kind == Token::Kind::broken) cursor_.take();  // reports the token's problem
    while (!cursor_.at_end()) {
      if (cursor_.at(Token::Kind::program) || cursor_.at_word("SubShader") || cursor_.at_word("Pass"))
        cursor_.fail_at(first.place, "the Shader ended before this '" + std::string(first.spelling) +
                                         "', and what follows would be lost: is there one '}' too many?");
      cursor_.take();
    }
    cursor_.warn(first.place, "what follows the end of the Shader is not read");
  }

  Cursor& cursor_;
  Shader& shader_;
};

// Shader, Category, SubShader and Pass.
//
// Fills all of the tree except its text and its include blocks; throws SyntaxError, after which the tree
// contains what was read so far.
void parse_structure(Cursor& cursor, Shader& shader) {
  StructureParser(cursor, shader).parse();
}

// Every program's text keeps the lines of the whole file, so many programs in a long file take much memory.
constexpr std::size_t kMostProgramText = std::size_t{256} << 20;

void limit_programs(const Cursor& cursor, const Lexed& lexed, std::size_t length) {
  const std::size_t most = kMostProgramText / std::max<std::size_t>(length, 1);
  if (lexed.programs.size() <= most) return;
  cursor.fail_at(lexed.programs[most].keyword,
                 "more than " + std::to_string(most) + " programs in a file of this length: split the file");
}

bool has_program(const Lexed& lexed, Language language) {
  return std::any_of(lexed.programs.begin(), lexed.programs.end(),
                     [&](const CodeBlock& program) { return program.language == language; });
}

void warn_of_idle_includes(Cursor& cursor, const Lexed& lexed) {
  if (lexed.programs.empty()) return;
  for (const CodeBlock& include : lexed.includes) {
    if (has_program(lexed, include.language)) continue;
    const std::string name = language_name(include.language);
    std::string message = name + "INCLUDE goes into ";
    message += name + "PROGRAM blocks, of which this file has none";
    cursor.warn(include.keyword, message);
  }
}

bool stands_before(const hlsl::Diagnostic& a, const hlsl::Diagnostic& b) {
  if ((a.line == 0) != (b.line == 0)) return b.line == 0;  // messages about the whole file come last
  return std::pair(a.line, a.column) < std::pair(b.line, b.column);
}

}  // namespace

ParsedShader parse_shader(std::string_view bytes, const std::string& file) {
  ParsedShader parsed;
  Shader& shader = parsed.shader;
  shader.file = file;
  shader.text = hlsl::normalise_source(bytes);
  Lexed lexed = lex(shader.text);
  Cursor cursor(file, shader.text, lexed);
  Place end{0, 0, shader.text.size()};
  try {
    parse_structure(cursor, shader);
    limit_programs(cursor, lexed, shader.text.size());
    warn_of_idle_includes(cursor, lexed);
  } catch (const SyntaxError& error) {
    end = error.place;
    parsed.complete = false;
    parsed.diagnostics.push_back(cursor.diagnostic(error.place, hlsl::Severity::error, error.message));
  }
  for (const Remark& warning : lexed.warnings)
    if (warning.place.offset < end.offset) cursor.warn(warning.place, warning.message);
  for (hlsl::Diagnostic& message : cursor.take_diagnostics()) {
    // The error that ends the parse and the unknown names before it often have one cause: only one error is
    // reported.
    if (!parsed.complete && message.severity == hlsl::Severity::error)
      message.severity = hlsl::Severity::warning;
    parsed.diagnostics.push_back(std::move(message));
  }
  std::stable_sort(parsed.diagnostics.begin(), parsed.diagnostics.end(), stands_before);
  shader.includes = std::move(lexed.includes);
  return parsed;
}

}  // namespace penumbra::shaderlab
