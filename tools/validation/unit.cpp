#include "validation/unit.h"

#include <algorithm>

#include "validation/byte_stream.h"

namespace penumbra::validation {

namespace {

using hlsl::Diagnostic;
using Pair = std::pair<std::string, std::string>;

void write(ByteWriter& out, const std::vector<std::string>& texts) {
  out.list(texts, [&](const std::string& text) { out.text(text); });
}

void write(ByteWriter& out, const std::vector<Pair>& pairs) {
  out.list(pairs, [&](const Pair& pair) {
    out.text(pair.first);
    out.text(pair.second);
  });
}

// The members by name and all of them: one more in the struct, and this does not compile until it is written.
void write(ByteWriter& out, const shaders::CompileRequest& request) {
  const auto& [file, text, entry, stage, defines, roots, directories, project, cginc_root, overlays, prepare,
               optimise, debug_lines, keep_unoptimised, vulkan] = request;
  out.text(file.string());
  out.number(text ? 1 : 0);
  out.text(text.value_or(""));
  out.text(entry);
  out.number(static_cast<std::uint64_t>(stage));
  write(out, defines);
  out.list(roots, [&](const shaders::PackageRoot& root) {
    out.text(root.name);
    out.text(root.directory.string());
  });
  out.list(directories, [&](const std::filesystem::path& directory) { out.text(directory.string()); });
  out.text(project.string());
  out.text(cginc_root.string());
  out.list(overlays, [&](const shaders::IncludeOverlay& overlay) {
    out.text(overlay.suffix);
    out.text(overlay.file.string());
  });
  out.number(prepare ? 1 : 0);
  out.number(optimise ? 1 : 0);
  out.number(debug_lines ? 1 : 0);
  out.number(keep_unoptimised ? 1 : 0);
  out.number(static_cast<std::uint64_t>(vulkan));
}

void write(ByteWriter& out, const LintOrder& order) {
  const auto& [wanted, shader_target, left_out] = order;
  out.number(wanted ? 1 : 0);
  out.number(static_cast<std::uint64_t>(std::max(shader_target, 0)));
  write(out, left_out);
}

void write(ByteWriter& out, const Diagnostic& diagnostic) {
  const auto& [file, line, column, severity, message, source_line, rule] = diagnostic;
  out.text(file);
  out.number(static_cast<std::uint64_t>(std::max(line, 0)));
  out.number(static_cast<std::uint64_t>(std::max(column, 0)));
  out.number(static_cast<std::uint64_t>(severity));
  out.text(message);
  out.text(source_line);
  out.text(rule);
}

void write(ByteWriter& out, const std::vector<Diagnostic>& diagnostics) {
  out.list(diagnostics, [&](const Diagnostic& diagnostic) { write(out, diagnostic); });
}

template <typename Enumeration>
Enumeration read_enumerator(ByteReader& in, Enumeration last) {
  const std::uint64_t value = in.number();
  if (value > static_cast<std::uint64_t>(last)) in.spoil();
  return value > static_cast<std::uint64_t>(last) ? last : static_cast<Enumeration>(value);
}

int read_place(ByteReader& in) {
  const std::uint64_t value = in.number();
  if (value > 0x7FFFFFFF) in.spoil();
  return value > 0x7FFFFFFF ? 0 : static_cast<int>(value);
}

std::vector<std::string> read_texts(ByteReader& in) {
  return in.list<std::string>([&] { return in.text(); });
}

Pair read_pair(ByteReader& in) {
  std::string first = in.text();
  return {std::move(first), in.text()};
}

std::vector<Pair> read_pairs(ByteReader& in) {
  return in.list<Pair>([&] { return read_pair(in); });
}

shaders::CompileRequest read_request(ByteReader& in) {
  shaders::CompileRequest request;
  request.file = in.text();
  const bool has_text = in.flag();
  std::string text = in.text();
  if (has_text) request.text = std::move(text);
  request.entry = in.text();
  request.stage = read_enumerator(in, hlsl::Stage::compute);
  request.defines = read_pairs(in);
  for (auto& [name, directory] : read_pairs(in)) request.package_roots.push_back({name, directory});
  for (std::string& directory : read_texts(in)) request.include_directories.emplace_back(directory);
  request.project = in.text();
  request.cginc_root = in.text();
  for (auto& [suffix, file] : read_pairs(in)) request.overlays.push_back({suffix, file});
  request.prepare = in.flag();
  request.optimise = in.flag();
  request.debug_lines = in.flag();
  request.keep_unoptimised = in.flag();
  request.vulkan = read_enumerator(in, shaders::VulkanVersion::v1_2);
  return request;
}

std::vector<Diagnostic> read_diagnostics(ByteReader& in) {
  return in.list<Diagnostic>([&] {
    Diagnostic diagnostic;
    diagnostic.file = in.text();
    diagnostic.line = read_place(in);
    diagnostic.column = read_place(in);
    diagnostic.severity = read_enumerator(in, hlsl::Severity::error);
    diagnostic.message = in.text();
    diagnostic.source_line = in.text();
    diagnostic.rule = in.text();
    return diagnostic;
  });
}

}  // namespace

std::string encode(const shaders::CompileRequest& request) {
  ByteWriter out;
  write(out, request);
  return out.take();
}

std::string encode(const std::vector<Diagnostic>& diagnostics) {
  ByteWriter out;
  write(out, diagnostics);
  return out.take();
}

std::string encode(const LintOrder& order) {
  ByteWriter out;
  write(out, order);
  return out.take();
}

std::string encode(const CompileUnit& unit) {
  ByteWriter out;
  for (const std::string* text : {&unit.technique, &unit.file, &unit.shader, &unit.pass}) out.text(*text);
  out.number(static_cast<std::uint64_t>(std::max(unit.sub_shader, 0)));
  write(out, unit.keywords);
  write(out, unit.compile);
  write(out, unit.targets);
  write(out, unit.lint);
  return out.take();
}

std::optional<CompileUnit> decode_unit(std::string_view bytes) {
  ByteReader in(bytes);
  CompileUnit unit;
  for (std::string* text : {&unit.technique, &unit.file, &unit.shader, &unit.pass}) *text = in.text();
  unit.sub_shader = read_place(in);
  unit.keywords = read_texts(in);
  unit.compile = read_request(in);
  unit.targets = read_texts(in);
  unit.lint.wanted = in.flag();
  unit.lint.shader_target = read_place(in);
  unit.lint.left_out = read_texts(in);
  if (!in.exhausted()) return std::nullopt;
  return unit;
}

std::string encode(const CompileAnswer& answer) {
  ByteWriter out;
  write(out, answer.diagnostics);
  out.text(answer.module_key);
  out.text(answer.missing_editor_include);
  write(out, answer.quoted);
  out.number(answer.buffers ? 1 : 0);
  out.text(answer.buffers ? *answer.buffers : std::string());
  return out.take();
}

std::optional<CompileAnswer> decode_compile_answer(std::string_view bytes) {
  ByteReader in(bytes);
  CompileAnswer answer;
  answer.diagnostics = read_diagnostics(in);
  answer.module_key = in.text();
  answer.missing_editor_include = in.text();
  answer.quoted = read_pairs(in);
  const bool has_buffers = in.flag();
  std::string buffers = in.text();
  if (has_buffers) answer.buffers = std::make_shared<const std::string>(std::move(buffers));
  if (!in.exhausted()) return std::nullopt;
  return answer;
}

std::string encode(const EmittedAnswer& answer) {
  ByteWriter out;
  out.list(answer, [&](const std::vector<Diagnostic>& diagnostics) { write(out, diagnostics); });
  return out.take();
}

std::optional<EmittedAnswer> decode_emitted_answer(std::string_view bytes) {
  ByteReader in(bytes);
  EmittedAnswer answer = in.list<std::vector<Diagnostic>>([&] { return read_diagnostics(in); });
  if (!in.exhausted()) return std::nullopt;
  return answer;
}

}  // namespace penumbra::validation
