// Reads the #pragma lines of a program, and the variants they declare.
#include <set>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "variants/plan.h"
#include "variants/pragmas.h"

namespace penumbra::fuzz {

namespace {

// A space that spans too much throws InputError; every other one counts what it lists.
void list_variants(const variants::Pragmas& pragmas) {
  const variants::KeywordSpace space(pragmas);
  const variants::VariantList& whole = space.whole_program();
  const std::uint64_t count = whole.count().value();
  std::set<variants::Keywords> seen;
  for (std::uint64_t i = 0; i < count && i < 64; ++i) {
    const variants::Keywords variant = whole.at(i);
    require(seen.insert(variant).second, "no variant is listed twice");
    const int target = variants::shader_target(pragmas, variant);
    require(target >= 25 && target <= 69, "a shader model is one of Unity's");
  }
  if (count > 0) whole.at(count - 1);
  const std::vector<variants::PlannedProgram> programs{
      {"a", &space, {hlsl::Stage::vertex, hlsl::Stage::fragment}}};
  variants::text_of(variants::plan(programs));
  variants::refusal(programs, 4);
}

}  // namespace

void targets::pragmas(std::string_view bytes) {
  const std::string text(bytes);
  const std::string other = text.substr(text.size() / 2);
  const variants::FindIncluded find = [&](const std::string& name, const std::string&) {
    return name.empty() ? std::nullopt : std::optional(variants::IncludedText{"b.hlsl", other});
  };
  const variants::Pragmas pragmas =
      variants::read_pragmas({"a.shader", text, {{"UNITY_VERSION", "202230"}}, find});
  require(pragmas.diagnostics.size() <= 201, "at most 200 messages, and that there are more");
  for (const hlsl::Diagnostic& message : pragmas.diagnostics) {
    require(message.line >= 1 && message.column >= 1, "a message has a place");
    require_harmless(hlsl::format(message));
  }
  for (const char* renderer : {"vulkan", "gles3"}) variants::compiles_for(pragmas, renderer);
  read([&] { list_variants(pragmas); });
}

}  // namespace penumbra::fuzz
