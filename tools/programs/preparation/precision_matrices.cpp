#include "preparation/precision_matrices.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace penumbra::preparation {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> known_scalars{{{"min16float", "half"},
                                                                                      {"min10float", "half"},
                                                                                      {"min16int", "int"},
                                                                                      {"min12int", "int"},
                                                                                      {"min16uint", "uint"}}};

bool is_matrix_shape(std::string_view shape) {
  const auto size = [](char c) { return c >= '1' && c <= '4'; };
  return shape.size() == 3 && size(shape[0]) && shape[1] == 'x' && size(shape[2]);
}

// Returns the equivalent matrix type of glslang; empty if the identifier is not a matrix of minimum
// precision.
std::string known_matrix(std::string_view word) {
  for (const auto& [minimum, known] : known_scalars) {
    if (word.substr(0, minimum.size()) != minimum || !is_matrix_shape(word.substr(minimum.size()))) continue;
    return std::string(known) + std::string(word.substr(minimum.size()));
  }
  return {};
}

}  // namespace

void name_precision_matrices(TokenText& text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.lead(at) != 'm') continue;  // all of them begin with it
    const std::string known = known_matrix(text[at].spelling);
    if (!known.empty()) text.replace(at, 1, known);
  }
  text.apply();
}

}  // namespace penumbra::preparation
