#include "lint/text_rules.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

#include "hlsl/name_set.h"
#include "hlsl/token_place.h"
#include "hlsl/tokens.h"

namespace penumbra::lint {

namespace {

constexpr hlsl::NameSet reserved("pass", "technique", "technique10", "technique11", "compile", "asm",
                                 "asm_fragment", "decl", "stateblock", "stateblock_state", "fxgroup",
                                 "compile_fragment", "pixelfragment", "vertexfragment", "pixelshader",
                                 "vertexshader", "export", "interface", "dynamic_cast", "delete", "register",
                                 "String", "PixelShader", "VertexShader", "GeometryShader", "HullShader",
                                 "DomainShader", "ComputeShader", "CompileShader", "BlendState",
                                 "RasterizerState", "DepthStencilState", "RenderTargetView",
                                 "DepthStencilView", "NULL", "texture1D", "texture2D", "texture3D",
                                 "textureCUBE");

// FXC reads these in upper and lower case.
constexpr hlsl::NameSet reserved_in_any_case("pass", "technique", "asm", "decl");

// These words begin statements, and a name behind them is used, not declared.
constexpr hlsl::NameSet statements("return", "else", "do", "case");
constexpr hlsl::NameSet kinds_with_members("struct", "class", "cbuffer", "tbuffer", "interface");

bool is_reserved(std::string_view word) {
  if (reserved.contains(word)) return true;
  if (word.size() > 9) return false;
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return reserved_in_any_case.contains(lower);
}

// A template such as `Texture2D<float4>` before the name has few tokens, which no expression has.
template <typename Tokens>
bool ends_template(const Tokens& tokens, std::size_t close) {
  constexpr std::size_t longest = 6;
  for (std::size_t at = close; at > 1 && close - at < longest; --at)
    if (tokens[at - 1].spelling == "<") return tokens[at - 2].kind == hlsl::Token::Kind::identifier;
  return false;
}

// A declared name has a type or another name of the declaration before it, and a token that may follow there
// behind it.
template <typename Tokens>
bool is_declared(const Tokens& tokens, std::size_t at) {
  if (at == 0 || at + 1 == tokens.size()) return false;
  const hlsl::Token& before = tokens[at - 1];
  const auto is_followed_by = [&](std::string_view marks) {
    return marks.find(tokens[at + 1].spelling[0]) != std::string_view::npos;
  };
  if (before.spelling == ",") return is_followed_by("=;");
  if (before.spelling == ">") return is_followed_by("=;,)[:") && ends_template(tokens, at - 1);
  if (before.kind != hlsl::Token::Kind::identifier) return false;
  return is_followed_by(kinds_with_members.contains(before.spelling) ? "{:" : "=;,)[(:") &&
         !statements.contains(before.spelling);
}

template <typename Tokens>
std::vector<std::size_t> declared_names(const Tokens& tokens) {
  std::vector<std::size_t> found;
  for (std::size_t at = 0; at < tokens.size(); ++at)
    if (is_reserved(tokens[at].spelling) && is_declared(tokens, at)) found.push_back(at);
  return found;
}

}  // namespace

std::vector<hlsl::Diagnostic> reserved_name_findings(const std::string& expanded,
                                                     const std::string& main_file,
                                                     const hlsl::SourceFiles& sources) {
  if (declared_names(hlsl::lex(expanded)).empty()) return {};
  std::vector<hlsl::Diagnostic> findings;
  const hlsl::TokenPlaces tokens(expanded, main_file);
  for (const std::size_t at : declared_names(tokens)) {
    const hlsl::TokenPlace place = tokens.at(at, sources);
    findings.push_back({place.file, place.line, place.column, hlsl::Severity::warning,
                        "'" + std::string(tokens[at].spelling) +
                            "' is a reserved word of FXC, Unity's compiler: choose another name",
                        sources.line(place.file, place.line), "reserved-name"});
  }
  return findings;
}

}  // namespace penumbra::lint
