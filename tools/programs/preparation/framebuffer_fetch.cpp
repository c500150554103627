// Framebuffer fetch: shaders that read the pixel they are about to write.
//
// Unity has two notations, and on Vulkan both mean an input attachment of the subpass:
// - `cbuffer hlslcc_SubpassInput_f_2 { float4 name; }`, which its compiler recognises by name: f, h, i and u
//   are float4, half4, int4 and uint4, capital letters the same with multisampling, `name[8]`; the number is
//   that of the attachment. Shader libraries write it with FRAMEBUFFER_INPUT_FLOAT(2) and similar macros.
// - a fragment function's `inout half4 color : SV_Target1` (Unity manual, SL-PlatformDifferences, "Using
//   shader framebuffer fetch"). glslang treats it as an input from the vertex stage and a separate output.
//
// The first becomes a SubpassInput with that number, and its uses become `.SubpassLoad()`. The second becomes
// an `out` parameter that is loaded at the beginning of the function; only in functions that the text does
// not call.

#include "preparation/passes.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"

namespace penumbra::preparation {

namespace {

constexpr std::string_view block_prefix = "hlslcc_SubpassInput_";
constexpr std::size_t most_targets = 8;

std::optional<std::size_t> target_number(std::string_view digits) {
  if (digits.size() != 1 || digits[0] < '0' || digits[0] >= '0' + static_cast<char>(most_targets))
    return std::nullopt;
  return static_cast<std::size_t>(digits[0] - '0');
}

// Returns the number of SV_Target, SV_TARGET0, ...
std::optional<std::size_t> target_of_semantic(std::string_view word) {
  constexpr std::string_view semantic = "sv_target";
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  if (!std::string_view(lower).starts_with(semantic)) return std::nullopt;
  const std::string_view digits = word.substr(semantic.size());
  return digits.empty() ? 0 : target_number(digits);
}

// The type that the letter in the block's name selects.
struct InputKind {
  std::string_view element;
  bool multisampled = false;
};

std::optional<InputKind> input_kind(char letter) {
  switch (letter) {
    case 'f':
    case 'F':
      return InputKind{"float4", letter == 'F'};
    case 'h':
    case 'H':
      return InputKind{"half4", letter == 'H'};
    case 'i':
    case 'I':
      return InputKind{"int4", letter == 'I'};
    case 'u':
    case 'U':
      return InputKind{"uint4", letter == 'U'};
    default:
      return std::nullopt;
  }
}

std::string attachment(std::size_t number, std::string_view type, std::string_view name) {
  return "[[vk::input_attachment_index(" + std::to_string(number) + ")]] " + std::string(type) + " " +
         std::string(name) + ";";
}

class FramebufferFetch {
 public:
  explicit FramebufferFetch(TokenText& text) : text_(text), declarations_(text.declarations()) {}

  void run() {
    for (const hlsl::Declaration& declaration : declarations_)
      if (declaration.kind == hlsl::Declaration::Kind::buffer) block(declaration);
    load_inputs();
    for (const hlsl::Declaration& declaration : declarations_)
      if (declaration.kind == hlsl::Declaration::Kind::function) function(declaration);
    text_.apply();
  }

 private:
  void block(const hlsl::Declaration& buffer) {
    if (buffer.name == hlsl::Declaration::none) return;
    const std::string_view name = text_.word(buffer.name);
    if (!name.starts_with(block_prefix) || name.size() < block_prefix.size() + 3) return;
    const std::optional<InputKind> kind = input_kind(name[block_prefix.size()]);
    const std::optional<std::size_t> number = target_number(name.substr(block_prefix.size() + 2));
    if (!kind || !number || name[block_prefix.size() + 1] != '_') return;
    std::size_t end = buffer.open + 1;
    while (end < buffer.close && !text_.is(end, ";")) ++end;
    const std::vector<Declarator> members = declarators(text_, buffer.open + 1, end);
    if (members.size() != 1 || end + 1 != buffer.close) return;
    const std::string type = std::string(kind->multisampled ? "SubpassInputMS<" : "SubpassInput<") +
                             std::string(kind->element) + ">";
    const std::string_view member = text_.word(members[0].name);
    inputs_.emplace(member, *kind);
    blocks_.emplace(buffer.open, buffer.close);
    text_.replace(buffer.first, buffer.last - buffer.first + 1, attachment(*number, type, member));
  }

  void load_inputs() {
    if (inputs_.empty()) return;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      if (const auto block = blocks_.find(at); block != blocks_.end()) at = block->second;
      const auto input = text_.is_identifier(at) ? inputs_.find(text_.word(at)) : inputs_.end();
      if (input == inputs_.end() || (at > 0 && text_.is(at - 1, "."))) continue;
      if (!input->second.multisampled) {
        text_.insert(at + 1, ".SubpassLoad()");
      } else if (text_.is(at + 1, "[") && text_.matching_bracket(at + 1) != npos) {
        text_.replace(at + 1, 1, ".SubpassLoad(");
        text_.replace(text_.matching_bracket(at + 1), 1, ")");
      }
    }
  }

  // Returns the names followed by '(' that are neither defined nor declared there.
  const std::set<std::string_view>& called() {
    if (!called_.empty()) return called_;
    called_.insert({});  // found
    for (std::size_t at = 0; at + 1 < text_.size(); ++at) {
      if (!text_.is_identifier(at) || !text_.is(at + 1, "(")) continue;
      const bool statement = at > 0 && text_.is_any(at - 1, "return", "else");
      if (statement || at == 0 || !text_.is_identifier(at - 1)) called_.insert(text_.word(at));
    }
    return called_;
  }

  void function(const hlsl::Declaration& function) {
    for (std::size_t at = function.parameters_open + 1; at < function.parameters_close; ++at)
      if (text_.is(at, "inout") && parameter(function, at)) at = function.parameters_close;
  }

  // Rewrites `inout half4 color : SV_Target1`, and with the first one all of the function's; returns true if
  // the function has been handled.
  bool parameter(const hlsl::Declaration& function, std::size_t first) {
    const bool is_fetch = text_.is_identifier(first + 1) && text_.is_identifier(first + 2) &&
                          text_.is(first + 3, ":") && text_.is_identifier(first + 4) &&
                          is_number_type(text_.word(first + 1));
    const std::optional<std::size_t> number =
        is_fetch ? target_of_semantic(text_.word(first + 4)) : std::nullopt;
    if (!number) return false;
    if (called().count(text_.word(function.name)) != 0) return true;
    const std::string type = text_.name(first + 1);
    const std::string name = text_.name(first + 2);
    const std::string element = type.substr(0, type.find_last_not_of("1234") + 1) + "4";
    const std::string input = text_.free_name("penumbra_target" + std::to_string(*number) + "_" + element);
    if (declared_.insert(input).second)
      text_.insert(function.first, attachment(*number, "SubpassInput<" + element + ">", input));
    text_.replace(first, 1, "out");
    text_.insert(function.open + 1, name + " = (" + type + ")" + input + ".SubpassLoad();");
    return false;
  }

  TokenText& text_;
  const std::vector<hlsl::Declaration>& declarations_;
  std::map<std::string_view, InputKind> inputs_;  // by the name that reads them
  std::map<std::size_t, std::size_t> blocks_;     // the '{' and '}' of removed blocks
  std::set<std::string_view> called_;
  std::set<std::string> declared_;  // names of the attachments of inout parameters
};

}  // namespace

void read_framebuffer(TokenText& text) {
  const auto& tokens = text.tokens();
  const bool any = std::any_of(tokens.begin(), tokens.end(), [](const hlsl::Token& token) {
    return token.spelling.starts_with(block_prefix) || token.spelling == "inout";
  });
  if (any) FramebufferFetch(text).run();
}

}  // namespace penumbra::preparation
