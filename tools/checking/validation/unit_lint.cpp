#include "validation/unit_lint.h"

#include <algorithm>
#include <utility>

#include "lint/module_rules.h"
#include "lint/rule.h"
#include "platform/byte_stream.h"
#include "platform/content_hash.h"

namespace penumbra::validation {

std::vector<hlsl::Diagnostic> wanted(std::vector<hlsl::Diagnostic> findings, const LintOrder& order) {
  std::erase_if(findings, [&](const hlsl::Diagnostic& finding) {
    return std::find(order.left_out.begin(), order.left_out.end(), finding.rule) != order.left_out.end();
  });
  return findings;
}

std::vector<hlsl::Diagnostic> LintedModules::messages(const CompileUnit& unit,
                                                      const shaders::CompileResult& compiled,
                                                      std::vector<hlsl::Diagnostic> of_text) {
  const std::string file = unit.compile.file.string();
  platform::ContentHash hash;
  hash.update(std::span<const std::uint32_t>(compiled.unoptimised)).update(file);
  hash.update(static_cast<int>(unit.compile.stage)).update(unit.lint.shader_target);
  const std::string key = hash.hex();
  std::shared_ptr<const std::vector<hlsl::Diagnostic>> known = findings_.find(key);
  if (!known)
    known = findings_.keep(
        key, lint::module_findings({compiled.unoptimised, unit.compile.stage, file, compiled.sources,
                                    unit.lint.shader_target, compiled.legalised}));
  of_text.insert(of_text.end(), known->begin(), known->end());
  return wanted(lint::with_suppressions(std::move(of_text), compiled.sources), unit.lint);
}

void leave_unity_out(LintOrder& order) {
  for (const lint::RuleInfo& rule : lint::rules())
    if (rule.of_unity) order.left_out.push_back(rule.name);
}

bool holds_suppression(std::string_view source) {
  return source.find("penumbra-lint") != std::string_view::npos;
}

std::string encode(const std::vector<lint::ConstantBuffer>& buffers) {
  platform::ByteWriter out;
  out.list(buffers, [&](const lint::ConstantBuffer& buffer) {
    out.text(buffer.name);
    out.number(buffer.size);
    out.list(buffer.members, [&](const lint::ConstantBufferMember& member) {
      out.text(member.name);
      out.number(member.offset);
      out.number(member.size);
    });
  });
  return out.take();
}

std::optional<std::vector<lint::ConstantBuffer>> decode_buffers(std::string_view bytes) {
  platform::ByteReader in(bytes);
  const auto number = [&] { return static_cast<std::uint32_t>(in.number()); };
  auto buffers = in.list<lint::ConstantBuffer>([&] {
    lint::ConstantBuffer buffer;
    buffer.name = in.text();
    buffer.size = in.number();
    buffer.members = in.list<lint::ConstantBufferMember>([&] {
      lint::ConstantBufferMember member;
      member.name = in.text();
      member.offset = number();
      member.size = in.number();
      return member;
    });
    return buffer;
  });
  if (!in.exhausted()) return std::nullopt;
  return buffers;
}

}  // namespace penumbra::validation
