#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/cbuffer_extents.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

struct PackedMember {
  std::size_t name = npos;
  std::size_t first = 0;  // word
  std::size_t size = 0;
  bool of_registers = false;
};

// Returns the word offset of `: packoffset(c1.y)` after a member's name; nothing without one.
std::optional<std::size_t> packed_at(const TokenText& text, const DeclaredValue& value) {
  for (std::size_t at = value.end; at + 2 < value.last; ++at) {
    if (!text.is(at, "packoffset") || !text.is(at + 1, "(")) continue;
    const std::string_view place = text[at + 2].spelling;
    std::size_t number = 0;
    const auto read = std::from_chars(place.data() + 1, place.data() + place.size(), number);
    if (place[0] != 'c' || read.ec != std::errc() || number > 4096) return std::nullopt;
    if (!text.is(at + 3, ".")) return number * kRegister;
    const std::string_view component = text[at + 4].spelling;
    std::size_t index = std::string_view("xyzw").find(component);
    if (index == npos) index = std::string_view("rgba").find(component);
    return index == npos || component.size() != 1 ? std::nullopt : std::optional(number * kRegister + index);
  }
  return std::nullopt;
}

std::vector<PackedMember> packed_members(const TokenText& text, const hlsl::Declaration& buffer) {
  std::vector<PackedMember> members;
  CbufferExtents extents(text);
  for (const DeclaredValue& value : text.types().declared()) {
    if (value.name == npos || value.name < buffer.open || value.name > buffer.close) continue;
    const std::optional<std::size_t> first = packed_at(text, value);
    const std::optional<Extent> extent = first ? extents.of(value) : std::nullopt;
    if (extent) members.push_back({value.name, *first, extent->size, extent->of_registers});
  }
  return members;
}

void check_place(TokenText& text, const PackedMember& member) {
  const std::string name = "the packoffset of '" + std::string(text[member.name].spelling) + "'";
  const std::size_t component = member.first % kRegister;
  if (member.of_registers && component != 0) {
    text.note(member.name, hlsl::Severity::error,
              name +
                  " is not the beginning of a register, which matrices, arrays and structs need: write it "
                  "without the component, or with .x");
  } else if (!member.of_registers && component + member.size > kRegister) {
    text.note(
        member.name, hlsl::Severity::error,
        name + " leaves room for " + std::to_string(kRegister - component) + " of its " +
            std::to_string(member.size) +
            " components in its register, and a vector must not straddle two: begin at an earlier component");
  }
}

void refuse_outside(TokenText& text) {
  for (const hlsl::Declaration& declaration : text.declarations())
    for (std::size_t at = declaration.first;
         declaration.kind == hlsl::Declaration::Kind::variable && at < declaration.last; ++at)
      if (text.is(at, "packoffset") && text.is(at - 1, ":"))
        text.note(at, hlsl::Severity::error,
                  "packoffset is for members of a cbuffer, and this variable is in none: remove it");
}

}  // namespace

void check_packed_members(TokenText& text) {
  refuse_outside(text);
  for (const hlsl::Declaration& buffer : text.declarations()) {
    if (buffer.kind != hlsl::Declaration::Kind::buffer) continue;
    const std::vector<PackedMember> members = packed_members(text, buffer);
    for (const PackedMember& member : members) check_place(text, member);
    for (std::size_t later = 1; later < members.size(); ++later) {
      for (std::size_t earlier = 0; earlier < later; ++earlier) {
        const PackedMember& a = members[earlier];
        const PackedMember& b = members[later];
        if (a.first >= b.first + b.size || b.first >= a.first + a.size) continue;
        text.note(b.name, hlsl::Severity::error,
                  "the packoffset of '" + std::string(text[b.name].spelling) + "' lies in '" +
                      std::string(text[a.name].spelling) + "': give them offsets that do not overlap");
        break;
      }
    }
  }
}

}  // namespace penumbra::preparation
