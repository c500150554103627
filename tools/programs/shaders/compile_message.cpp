#include "shaders/compile_message.h"

#include <utility>

namespace penumbra::shaders {

using hlsl::Diagnostic;
using platform::ByteReader;
using platform::ByteWriter;

namespace {

using Pair = std::pair<std::string, std::string>;

void write(ByteWriter& out, const std::vector<Pair>& pairs) {
  out.list(pairs, [&](const Pair& pair) {
    out.text(pair.first);
    out.text(pair.second);
  });
}

Pair read_pair(ByteReader& in) {
  std::string first = in.text();
  return {std::move(first), in.text()};
}

std::vector<Pair> read_pairs(ByteReader& in) {
  return in.list<Pair>([&] { return read_pair(in); });
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

int read_place(ByteReader& in) {
  const std::uint64_t value = in.number();
  if (value > 0x7FFFFFFF) in.spoil();
  return value > 0x7FFFFFFF ? 0 : static_cast<int>(value);
}

}  // namespace

// A structured binding takes all members: adding a member to the struct breaks the build until it is
// serialised, too.
void write(ByteWriter& out, const shaders::CompileRequest& request) {
  const auto& [file, text, written_for, entry, stage, defines, roots, directories, project, cginc_root,
               prepare, optimise, debug_lines, keep_unoptimised, vulkan, entry_place, half_is_16_bits, dxc,
               rasterized] = request;
  out.text(file.string());
  out.number(text ? 1 : 0);
  out.text(text ? *text : std::string());
  out.number(written_for ? 1 : 0);
  out.text(written_for ? written_for->string() : "");
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
  out.number(prepare ? 1 : 0);
  out.number(optimise ? 1 : 0);
  out.number(debug_lines ? 1 : 0);
  out.number(keep_unoptimised ? 1 : 0);
  out.number(static_cast<std::uint64_t>(vulkan));
  out.text(entry_place.file);
  out.number(static_cast<std::uint64_t>(std::max(entry_place.line, 0)));
  out.number(static_cast<std::uint64_t>(std::max(entry_place.column, 0)));
  out.number(half_is_16_bits ? 1 : 0);
  out.number(dxc ? 1 : 0);
  out.number(rasterized ? 1 : 0);
}

void write(ByteWriter& out, const std::vector<Diagnostic>& diagnostics) {
  out.list(diagnostics, [&](const Diagnostic& diagnostic) { write(out, diagnostic); });
}

void write(ByteWriter& out, const Signature& signature) {
  out.list(signature, [&](const SignatureElement& element) {
    out.text(element.semantic);
    out.number(element.output ? 1 : 0);
    out.number(element.per_patch ? 1 : 0);
    out.number(static_cast<std::uint64_t>(element.location + 1));
    out.number(static_cast<std::uint64_t>(element.type));
    out.number(static_cast<std::uint64_t>(element.components));
    out.number(static_cast<std::uint64_t>(element.count));
    out.number(element.read ? 1 : 0);
    out.number(element.of_cascade ? 1 : 0);
    out.text(element.written);
    out.text(element.file);
    out.number(static_cast<std::uint64_t>(element.line));
  });
}

CompileRequest read_compile_request(ByteReader& in) {
  CompileRequest request;
  request.file = in.text();
  const bool has_text = in.flag();
  std::string text = in.text();
  if (has_text) request.text = std::move(text);
  const bool is_written = in.flag();
  std::string written_for = in.text();
  if (is_written) request.written_for = std::move(written_for);
  request.entry = in.text();
  request.stage = in.enumerator(hlsl::Stage::compute);
  request.defines = read_pairs(in);
  for (auto& [name, directory] : read_pairs(in)) request.package_roots.push_back({name, directory});
  request.include_directories =
      in.list<std::filesystem::path>([&] { return std::filesystem::path(in.text()); });
  request.project = in.text();
  request.cginc_root = in.text();
  request.prepare = in.flag();
  request.optimise = in.flag();
  request.debug_lines = in.flag();
  request.keep_unoptimised = in.flag();
  request.vulkan = in.enumerator(VulkanVersion::v1_2);
  request.entry_place.file = in.text();
  request.entry_place.line = read_place(in);
  request.entry_place.column = read_place(in);
  request.half_is_16_bits = in.flag();
  request.dxc = in.flag();
  request.rasterized = in.flag();
  return request;
}

std::vector<Diagnostic> read_diagnostics(ByteReader& in) {
  return in.list<Diagnostic>([&] {
    Diagnostic diagnostic;
    diagnostic.file = in.text();
    diagnostic.line = read_place(in);
    diagnostic.column = read_place(in);
    diagnostic.severity = in.enumerator(hlsl::Severity::error);
    diagnostic.message = in.text();
    diagnostic.source_line = in.text();
    diagnostic.rule = in.text();
    return diagnostic;
  });
}

Signature read_signature(ByteReader& in) {
  return in.list<SignatureElement>([&] {
    SignatureElement element;
    element.semantic = in.text();
    element.output = in.flag();
    element.per_patch = in.flag();
    element.location = read_place(in) - 1;
    element.type = in.enumerator(SignatureType::other);
    element.components = read_place(in);
    element.count = read_place(in);
    element.read = in.flag();
    element.of_cascade = in.flag();
    element.written = in.text();
    element.file = in.text();
    element.line = read_place(in);
    return element;
  });
}

CompilerFailure compiler_failure(const platform::WorkerOutcome& outcome) {
  CompilerFailure failure{"the compiler " + outcome.failure, {}, outcome.failure.starts_with("took ")};
  if (!outcome.output_tail.empty()) failure.problem += "; it said: " + outcome.output_tail;
  failure.remedy = failure.limited
                       ? "simplify the shader, or raise --time-limit and --memory-limit"
                       : "leave out parts of the shader until it compiles; `penumbra validate` keeps the "
                         "text that the compiler fails on";
  return failure;
}

}  // namespace penumbra::shaders
