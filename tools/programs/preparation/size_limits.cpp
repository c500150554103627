#include <map>

#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr std::size_t deepest_nesting = 1000;
constexpr std::size_t most_operators =
    8000;  // each is a level of the syntax tree, which is traversed recursively

class Nesting {
 public:
  explicit Nesting(TokenText& text) : text_(text) {}

  bool run() {
    for (std::size_t at = 0; at < text_.size(); ++at) {
      count(at);
      const bool deep =
          brackets_ > deepest_nesting || prefixes_ > deepest_nesting || in_statement_ > deepest_nesting;
      if (!deep && operators_ <= most_operators) continue;
      text_.error(at, deep ? "more than " + std::to_string(deepest_nesting) + " levels of nesting: split it"
                           : "more than " + std::to_string(most_operators) +
                                 " operators in one expression: split it");
      return false;
    }
    return true;
  }

 private:
  void count(std::size_t at) {
    const char lead = text_.lead(at);
    if (lead == '(' || lead == '[' || lead == '{') ++brackets_;
    if ((lead == ')' || lead == ']' || lead == '}') && brackets_ > 0) --brackets_;
    if (lead == ';' || lead == '{' || lead == '}') in_statement_ = 0;
    if (lead == ';' || lead == '{' || lead == '}' || lead == ',') operators_ = 0;
    if (lead != '\0' && std::string_view("+-*/%&|^<>=.").find(lead) != std::string_view::npos) ++operators_;
    if (lead == '?' || text_.is_any(at, "if", "for", "while")) ++in_statement_;
    prefixes_ = lead == '-' || lead == '+' || lead == '!' || lead == '~' || in_cast(at) ? prefixes_ + 1 : 0;
  }

  // Returns whether it is a token of `(name)`: a run of casts has three tokens each.
  bool in_cast(std::size_t at) const {
    const auto is_cast = [&](std::size_t open) {
      return text_.is(open, "(") && text_.is_identifier(open + 1) && text_.is(open + 2, ")");
    };
    return is_cast(at) || (at > 0 && is_cast(at - 1)) || (at > 1 && is_cast(at - 2));
  }

  TokenText& text_;
  std::size_t brackets_ = 0;
  std::size_t prefixes_ = 0;
  std::size_t operators_ = 0;     // number since the last ',' or end of a statement
  std::size_t in_statement_ = 0;  // conditions without a ';' or a brace between them
};

constexpr std::size_t most_members = 65536;

class StructSizes {
 public:
  explicit StructSizes(TokenText& text) : text_(text), types_(text.types()) {}

  bool run() {
    std::size_t first = npos;  // for a struct that is too large, the token of its name
    bool is_endless = false;
    for (const auto& [name, type] : types_.structs()) {
      const std::size_t members = members_of(name), at = types_.declarations()[type.declaration].name;
      if (members <= most_members || at > first) continue;
      first = at;
      is_endless = members == endless;
    }
    if (first == npos) return true;
    const std::string named = "'" + text_.name(first) + "'";
    text_.error(first, is_endless ? named + " contains itself"
                                  : named + " has more than " + std::to_string(most_members) +
                                        " members, those of the structs in it included");
    return false;
  }

 private:
  static constexpr std::size_t endless = static_cast<std::size_t>(-1);

  // Counts the members of all levels: endless for a struct that contains itself, else at most a little more
  // than most_members.
  std::size_t members_of(std::string_view name) {
    const auto known = types_.structs().find(name);
    if (known == types_.structs().end()) return 1;
    if (const auto found = counted_.find(name); found != counted_.end()) return found->second;
    counted_[name] = endless;  // while its own members are counted
    std::size_t count = known->second.base.empty() ? 0 : members_of(known->second.base);
    for (const std::size_t member : known->second.members) {
      if (count > most_members) break;
      const std::size_t inside = members_of(types_.declared()[member].type.name);
      count = inside == endless ? endless : count + inside;
    }
    counted_[name] = count;
    return count;
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::map<std::string_view, std::size_t> counted_;
};

}  // namespace

bool check_nesting(TokenText& text) {
  return Nesting(text).run();
}

bool check_struct_sizes(TokenText& text) {
  return StructSizes(text).run();
}

}  // namespace penumbra::preparation
