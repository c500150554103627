#include "validation/unit.h"

#include <algorithm>

#include "platform/byte_stream.h"
#include "shaders/compile_message.h"

namespace penumbra::validation {

using platform::ByteReader;
using platform::ByteWriter;

namespace {

using hlsl::Diagnostic;
using shaders::write;
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

void write(ByteWriter& out, const std::shared_ptr<const std::string>& text) {
  out.number(text ? 1 : 0);
  out.text(text ? *text : std::string());
}

void write(ByteWriter& out, const LintOrder& order) {
  const auto& [wanted, shader_target, left_out] = order;
  out.number(wanted ? 1 : 0);
  out.number(static_cast<std::uint64_t>(std::max(shader_target, 0)));
  write(out, left_out);
}

int read_place(ByteReader& in) {
  const std::uint64_t value = in.number();
  if (value > 0x7FFFFFFF) in.spoil();
  return value > 0x7FFFFFFF ? 0 : static_cast<int>(value);
}

std::shared_ptr<const std::string> read_shared_text(ByteReader& in) {
  const bool exists = in.flag();
  std::string text = in.text();
  return exists ? std::make_shared<const std::string>(std::move(text)) : nullptr;
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

}  // namespace

void add_names(platform::ContentHash& hash, const CompileUnit& unit) {
  add_variant_names(hash, unit);
  hash.update(unit.compile.entry).update(static_cast<int>(unit.compile.stage));
}

void add_variant_names(platform::ContentHash& hash, const CompileUnit& unit) {
  hash.update(unit.technique).update(unit.shader).update(unit.pass);
  for (const std::string& keyword : unit.keywords) hash.update(keyword);
}

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
  unit.compile = shaders::read_compile_request(in);
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
  out.list(answer.of_targets, [&](const shaders::TargetDiagnostics& of) {
    out.text(of.target);
    write(out, of.diagnostics);
  });
  out.text(answer.module_key);
  out.text(answer.unchecked);
  write(out, answer.quoted);
  write(out, answer.buffers);
  write(out, answer.signature);
  return out.take();
}

std::optional<CompileAnswer> decode_compile_answer(std::string_view bytes) {
  ByteReader in(bytes);
  CompileAnswer answer;
  answer.diagnostics = shaders::read_diagnostics(in);
  answer.of_targets = in.list<shaders::TargetDiagnostics>([&] {
    std::string target = in.text();
    return shaders::TargetDiagnostics{std::move(target), shaders::read_diagnostics(in)};
  });
  answer.module_key = in.text();
  answer.unchecked = in.text();
  answer.quoted = read_pairs(in);
  answer.buffers = read_shared_text(in);
  answer.signature = read_shared_text(in);
  if (!in.exhausted()) return std::nullopt;
  return answer;
}

std::string encode(const EmittedAnswer& answer) {
  ByteWriter out;
  out.list(answer, [&](const std::vector<Diagnostic>& diagnostics) { write(out, diagnostics); });
  return out.take();
}

std::string encode(const shaders::Signature& signature) {
  ByteWriter out;
  write(out, signature);
  return out.take();
}

std::optional<shaders::Signature> decode_signature(std::string_view bytes) {
  ByteReader in(bytes);
  shaders::Signature signature = shaders::read_signature(in);
  if (!in.exhausted()) return std::nullopt;
  return signature;
}

std::optional<EmittedAnswer> decode_emitted_answer(std::string_view bytes) {
  ByteReader in(bytes);
  EmittedAnswer answer = in.list<std::vector<Diagnostic>>([&] { return shaders::read_diagnostics(in); });
  if (!in.exhausted()) return std::nullopt;
  return answer;
}

}  // namespace penumbra::validation
