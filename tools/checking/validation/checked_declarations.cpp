#include "validation/checked_declarations.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "hlsl/expanded_text.h"
#include "platform/content_hash.h"

namespace penumbra::validation {

namespace {

using hlsl::Diagnostic;

// The inputs of the parser other than the text.
std::string circumstances_of(const shaders::CompileRequest& request) {
  return std::to_string(static_cast<int>(request.stage)) + " " +
         shaders::vulkan_version_name(request.vulkan) + (request.prepare ? " prepared " : " as it is ") +
         (request.half_is_16_bits ? "16-bit half " : "");
}

// Returns these inputs and those that determine the generated module.
std::string module_circumstances_of(const shaders::CompileRequest& request) {
  std::string text = circumstances_of(request) + request.file.string() + "\n" + request.entry + "\n";
  for (const bool flag :
       {request.optimise, request.debug_lines, request.keep_unoptimised, request.dxc, request.rasterized})
    text += flag ? '1' : '0';
  return text;
}

std::string key_of(const shaders::CompileRequest& request, const std::string& text) {
  platform::ContentHash hash;
  return hash.update(module_circumstances_of(request)).update(text).hex();
}

bool is_before(const Diagnostic& a, const Diagnostic& b) {
  return std::tie(a.file, a.line, a.column, a.message) < std::tie(b.file, b.line, b.column, b.message);
}

bool is_same(const Diagnostic& a, const Diagnostic& b) {
  return !is_before(a, b) && !is_before(b, a);
}

// Returns the diagnostics by location; those without one come last, in their order.
std::vector<Diagnostic> in_order(std::vector<Diagnostic> messages) {
  const auto placed = std::stable_partition(messages.begin(), messages.end(),
                                            [](const Diagnostic& message) { return message.line > 0; });
  std::stable_sort(messages.begin(), placed, is_before);
  messages.erase(std::unique(messages.begin(), placed, is_same), placed);
  return messages;
}

}  // namespace

std::vector<std::size_t> CheckedDeclarations::unknown(const hlsl::Reach& reach,
                                                      const std::string& circumstances) const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < reach.unreached().size(); ++i)
    if (known_.count(circumstances + reach.unreached()[i]) == 0) indices.push_back(i);
  return indices;
}

// Keeps the warnings of the checked declarations.
void CheckedDeclarations::learn(const hlsl::Reach& reach, const std::string& circumstances,
                                const std::vector<Diagnostic>& said,
                                const std::vector<std::size_t>& checked) {
  for (const std::size_t i : checked) known_[circumstances + reach.unreached()[i]] = {};
  for (const Diagnostic& message : said)
    for (const std::size_t i : reach.at(message))
      if (std::binary_search(checked.begin(), checked.end(), i))
        known_[circumstances + reach.unreached()[i]].push_back(message);
}

// The result has no files, because these depend on the request.
shaders::CompileResult CheckedDeclarations::compile_prepared(const shaders::CompileRequest& request,
                                                             shaders::PreprocessedSource prepared) {
  const std::string key = key_of(request, prepared.text);
  const std::vector<Diagnostic> notes = std::exchange(prepared.diagnostics, {});
  std::shared_ptr<const shaders::CompileResult> known = prepared_.find(key);
  if (!known) {
    shaders::CompileResult made = shaders::compile(request, std::move(prepared));
    made.sources = {};
    made.dependencies.clear();
    known = prepared_.keep(key, std::move(made));
  }
  shaders::CompileResult result = *known;
  result.diagnostics.insert(result.diagnostics.begin(), notes.begin(), notes.end());
  return result;
}

shaders::CompileResult CheckedDeclarations::compile_reached(const shaders::CompileRequest& request,
                                                            shaders::PreprocessedSource reached,
                                                            Sharing sharing) {
  if (sharing != Sharing::everything) {
    shaders::prepare(request, reached);
    return shaders::compile(request, std::move(reached));
  }
  reached.text = hlsl::dense_lines(reached.text);
  const std::string key = key_of(request, reached.text);
  const std::vector<Diagnostic> said = std::exchange(reached.diagnostics, {});
  std::vector<std::filesystem::path> dependencies = std::move(reached.dependencies);
  std::shared_ptr<const shaders::CompileResult> known = reached_.find(key);
  hlsl::SourceFiles sources = known ? std::move(reached.sources) : reached.sources;
  if (!known) {
    shaders::prepare(request, reached);
    const bool wrong = hlsl::has_errors(reached.diagnostics);
    known = reached_.keep(key, wrong ? shaders::compile(request, std::move(reached))
                                     : compile_prepared(request, std::move(reached)));
  }
  shaders::CompileResult result = *known;
  result.diagnostics.insert(result.diagnostics.begin(), said.begin(), said.end());
  result.dependencies = std::move(dependencies);
  result.sources = std::move(sources);
  return result;
}

shaders::CompileResult CheckedDeclarations::compile(const shaders::CompileRequest& request,
                                                    shaders::PreprocessedSource expanded, Sharing sharing) {
  const std::string text = std::move(expanded.text);
  const std::vector<Diagnostic> before = expanded.diagnostics;
  const hlsl::Reach reach(text, request.file.string(), request.entry);
  const std::string circumstances = circumstances_of(request);
  const auto whole = [&](shaders::PreprocessedSource source) {
    source.text = text;
    source.diagnostics = before;
    return compile_whole(request, std::move(source));
  };

  if (const std::vector<std::size_t> unknown = this->unknown(reach, circumstances); !unknown.empty()) {
    expanded.text = reach.text_with(unknown);
    expanded.diagnostics.clear();
    shaders::prepare(request, expanded);
    const std::vector<Diagnostic> said = shaders::front_end_messages(request, expanded);
    if (hlsl::has_errors(said)) return whole(std::move(expanded));
    learn(reach, circumstances, said, unknown);
  }

  expanded.text = reach.text_with({});
  expanded.diagnostics = before;
  shaders::CompileResult result = compile_reached(request, expanded, sharing);
  if (hlsl::has_errors(result.diagnostics)) return whole(std::move(expanded));
  for (const std::string& key : reach.unreached()) {
    const std::vector<Diagnostic>& said = known_.at(circumstances + key);
    result.diagnostics.insert(result.diagnostics.end(), said.begin(), said.end());
  }
  result.diagnostics = in_order(std::move(result.diagnostics));
  return result;
}

shaders::CompileResult compile_whole(const shaders::CompileRequest& request,
                                     shaders::PreprocessedSource expanded) {
  shaders::prepare(request, expanded);
  return shaders::compile(request, std::move(expanded));
}

}  // namespace penumbra::validation
