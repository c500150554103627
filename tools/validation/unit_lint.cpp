#include "validation/unit_lint.h"

#include <algorithm>
#include <utility>

#include "lint/module_rules.h"
#include "platform/byte_stream.h"

namespace penumbra::validation {

std::optional<hlsl::Diagnostic> message_of(lint::Finding finding, const LintOrder& order) {
  if (std::find(order.left_out.begin(), order.left_out.end(), finding.rule) != order.left_out.end())
    return std::nullopt;
  finding.diagnostic.rule = std::move(finding.rule);
  return std::move(finding.diagnostic);
}

std::vector<hlsl::Diagnostic> lint_messages(const CompileUnit& unit,
                                            const std::vector<std::uint32_t>& unoptimised,
                                            const hlsl::SourceFiles& sources) {
  std::vector<hlsl::Diagnostic> messages;
  for (lint::Finding& finding : lint::lint_module(
           {unoptimised, unit.compile.stage, unit.compile.file.string(), sources, unit.lint.shader_target}))
    if (std::optional<hlsl::Diagnostic> message = message_of(std::move(finding), unit.lint))
      messages.push_back(*std::move(message));
  return messages;
}

bool holds_suppression(std::string_view source) {
  return source.find("penumbra-lint") != std::string_view::npos;
}

std::string encode(const std::vector<lint::ConstantBuffer>& buffers) {
  ByteWriter out;
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
  ByteReader in(bytes);
  const auto number = [&] { return static_cast<std::uint32_t>(in.number()); };
  auto buffers = in.list<lint::ConstantBuffer>([&] {
    lint::ConstantBuffer buffer;
    buffer.name = in.text();
    buffer.size = number();
    buffer.members = in.list<lint::ConstantBufferMember>([&] {
      lint::ConstantBufferMember member;
      member.name = in.text();
      member.offset = number();
      member.size = number();
      return member;
    });
    return buffer;
  });
  if (!in.exhausted()) return std::nullopt;
  return buffers;
}

}  // namespace penumbra::validation
