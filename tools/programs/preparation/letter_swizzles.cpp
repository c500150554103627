#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/expression_reader.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

// Finds the members of numbers that are in `asked`.
class MembersOfNumbers final : public ExpressionReader {
 public:
  MembersOfNumbers(const TokenText& text, const std::set<std::size_t>& asked)
      : ExpressionReader(text), asked_(asked) {}

  std::vector<std::size_t> found;

 private:
  void read_binary(const ReadOperand&, std::size_t, const ReadOperand&) override {}
  void read_member(const NumberShape& of, std::size_t member) override {
    if (of.known() && !of.is_matrix() && asked_.contains(member)) found.push_back(member);
  }

  const std::set<std::size_t>& asked_;
};

bool is_of_textures(std::string_view word) {
  return word.size() <= 4 && word.find_first_not_of("stpq") == std::string_view::npos;
}

// Returns the identifiers of these letters after a '.'. `declared` has those that occur elsewhere, and so may
// be members.
std::set<std::size_t> candidates(const TokenText& text, std::set<std::string_view>& declared) {
  std::set<std::size_t> found;
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (!text.is_identifier(at) || !is_of_textures(text[at].spelling)) continue;
    if (!text.is(at - 1, "."))
      declared.insert(text[at].spelling);
    else if (!text.is(at + 1, "("))
      found.insert(at);
  }
  return found;
}

}  // namespace

void check_letter_swizzles(TokenText& text) {
  std::set<std::string_view> declared;
  const std::set<std::size_t> asked = candidates(text, declared);
  if (asked.empty()) return;
  std::set<std::size_t> refused;
  for (const std::size_t at : asked)
    if (!declared.contains(text[at].spelling)) refused.insert(at);
  if (refused.size() < asked.size()) {
    MembersOfNumbers numbers(text, asked);
    numbers.read_all();
    refused.insert(numbers.found.begin(), numbers.found.end());
  }
  for (const std::size_t at : refused) {
    const std::string word(text[at].spelling);
    std::string meant;
    for (const char c : word) meant += "xyzw"[std::string_view("stpq").find(c)];
    text.note(at, hlsl::Severity::error,
              "'." + word + "' is not a swizzle of HLSL, which has xyzw and rgba: write '." + meant + "'");
  }
}

}  // namespace penumbra::preparation
