// Reads HLSL before the preprocessor with the project's own and with glslang's: what the first has a text for
// has the same text from the second, which has nothing to say of it. The first byte says whether the source
// is prepared.
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <optional>
#include <string>

#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "hlsl/source_text.h"
#include "preparation/bare_source.h"
#include "preparation/macro_arguments.h"
#include "preparation/source_directives.h"
#include "preprocessing/preprocessor.h"

namespace penumbra::fuzz {

namespace {

constexpr const char* name = "main.hlsl";
constexpr const char* definitions = "#define GIVEN 1\n#define CALLED(x) (x)\n";

class NoIncludes final : public preprocessing::Includes {
 public:
  std::optional<preprocessing::IncludedFile> enter(const std::string&, const std::string&) override {
    return std::nullopt;
  }
  void leave() override {}
};

std::optional<std::string> own_text(const std::string& source) {
  preprocessing::Preprocessor preprocessor;
  const preprocessing::CutSource given = preprocessor.cut(definitions);
  const preprocessing::CutSource cut = preprocessor.cut(source);
  NoIncludes includes;
  return preprocessor.run(given, cut, name, includes);
}

// Returns nothing when glslang says something.
std::optional<std::string> text_of_glslang(const std::string& source) {
  static const bool initialised = glslang::InitializeProcess();
  require(initialised, "glslang starts");
  const char* const texts[] = {source.c_str()};
  const int lengths[] = {static_cast<int>(source.size())};
  const char* const names[] = {name};
  glslang::TShader shader(EShLangFragment);
  shader.setStringsWithLengthsAndNames(texts, lengths, names, 1);
  // The preamble is SourceShader's.
  const std::string preamble = std::string("#undef VULKAN\n") + definitions;
  shader.setPreamble(preamble.c_str());
  shader.setEnvInput(glslang::EShSourceHlsl, EShLangFragment, glslang::EShClientVulkan, 100);
  glslang::TShader::ForbidIncluder includer;
  std::string text;
  const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl);
  const bool read =
      shader.preprocess(GetDefaultResources(), 500, ENoProfile, false, false, messages, &text, includer);
  if (!read || *shader.getInfoLog() != '\0') return std::nullopt;
  return text;
}

}  // namespace

void targets::preprocessing(std::string_view bytes) {
  const bool prepared = take_byte(bytes) % 2 == 0;
  std::string source = hlsl::normalise_source(bytes);
  std::erase(source, '\0');
  if (prepared)
    source = preparation::with_own_names_marked(
        preparation::bare_source(preparation::prepare_source(std::move(source)).text));
  if (source.find("GL_") != std::string::npos) return;  // glslang alone defines these names, for GLSL
  if (!source.ends_with('\n')) source += '\n';
  const std::optional<std::string> own = own_text(source);
  if (!own) return;
  const std::optional<std::string> by_glslang = text_of_glslang(source);
  require(by_glslang.has_value(), "glslang has nothing to say of it");
  require(*own == *by_glslang, "both preprocessors make the same text");
}

}  // namespace penumbra::fuzz
