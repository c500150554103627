#include "preparation/zeroed_resource_structs.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/resource_types.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class Zeroes {
 public:
  explicit Zeroes(TokenText& text)
      : text_(text), types_(text.types()), carriers_(structs_with_resources(types_)) {}

  void run() {
    for (std::size_t at = 0; at + 3 < text_.size(); ++at)
      if (is_cast(at)) replace(at);
    for (const std::string_view type : needed_) define(type);
    text_.apply();
  }

 private:
  std::string_view word(std::size_t at) const { return text_[at].spelling; }

  // The cast is ( S ) 0, or 0.0 and 0.0f.
  bool is_cast(std::size_t at) const {
    if (!text_.is(at, "(") || !text_.is(at + 2, ")")) return false;
    const bool zero = text_[at + 3].spelling.find_first_not_of("0.fFhHuU") == std::string_view::npos;
    return text_[at + 3].kind == hlsl::Token::Kind::number && zero && carriers_.count(word(at + 1)) != 0;
  }

  void replace(std::size_t at) {
    need(word(at + 1));
    text_.replace(at, 4, function_name(word(at + 1)) + "()");
  }

  // Adds the struct with the structs of its members.
  void need(std::string_view type) {
    std::vector<std::string_view> open{type};
    while (!open.empty()) {
      type = open.back();
      open.pop_back();
      if (!needed_.insert(type).second) continue;
      for (const std::size_t member : members(type))
        if (carriers_.count(types_.declared()[member].type.name) != 0)
          open.push_back(types_.declared()[member].type.name);
    }
  }

  // The members of its bases come first.
  std::vector<std::size_t> members(std::string_view type) const {
    constexpr int deepest = 16;
    std::vector<std::size_t> all;
    for (int depth = 0; depth < deepest; ++depth) {
      const auto known = types_.structs().find(type);
      if (known == types_.structs().end()) break;
      all.insert(all.begin(), known->second.members.begin(), known->second.members.end());
      type = known->second.base;
    }
    return all;
  }

  std::string function_name(std::string_view type) const {
    return text_.free_name("zero_" + std::string(type));
  }

  void define(std::string_view type) {
    const StructType& known = types_.structs().at(type);
    std::string body;
    for (const std::size_t index : members(type)) body += zero(types_.declared()[index]);
    text_.insert(types_.declarations()[known.declaration].last + 1,
                 std::string(type) + " " + function_name(type) + "() { " + std::string(type) + " zero; " +
                     body + "return zero; } ");
  }

  // Returns zero.member = (float4)0; or a loop over its elements.
  std::string zero(const DeclaredValue& member) const {
    const std::string_view type = member.type.name;
    if (is_resource(type) || member.type_at == npos) return {};
    std::string element = "zero." + std::string(word(member.name));
    std::string loops;
    std::size_t open = member.name + 1;
    for (int dimension = 0; dimension < member.type.dimensions; ++dimension) {
      const std::string i = "i" + std::to_string(dimension);
      const std::size_t close = text_.matching_bracket(open);
      const std::string size = text_.spelled(open + 1, close - open - 1);
      loops.append("for (int ")
          .append(i)
          .append(" = 0; ")
          .append(i)
          .append(" < ")
          .append(size)
          .append("; ++");
      loops.append(i).append(") ");
      element.append("[").append(i).append("]");
      open = close + 1;
    }
    const std::string value =
        carriers_.count(type) != 0
            ? function_name(type) + "()"
            : "(" + text_.spelled(member.type_at, member.type_end - member.type_at) + ")0";
    return loops + element + " = " + value + "; ";
  }

  TokenText& text_;
  const ValueTypes& types_;
  const std::set<std::string_view> carriers_;
  std::set<std::string_view> needed_;
};

}  // namespace

void zero_resource_structs(TokenText& text) {
  Zeroes(text).run();
}

}  // namespace penumbra::preparation
