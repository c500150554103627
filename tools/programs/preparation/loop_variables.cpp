#include "preparation/loop_variables.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class LoopVariables {
 public:
  explicit LoopVariables(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    if (!find_uses()) return;
    for (std::size_t at = 1; at + 1 < text_.size(); ++at)
      if (text_.is(at, "for") && text_.is(at + 1, "(") && text_.matching_bracket(at + 1) != npos) find(at);
    if (loops_.empty()) return;
    for (const Loop& loop : loops_) move_declaration(loop);
    rename();
    text_.apply();
  }

 private:
  // A loop whose variable is read after it.
  struct Loop {
    std::size_t place;  // the token before which the declaration is inserted
    std::size_t first;  // first token of the declaration
    std::size_t semicolon;
    std::size_t end;  // its last token
  };

  // Finds the last use of each declared value. Returns false if there is no local variable.
  bool find_uses() {
    last_use_.assign(types_.declared().size(), 0);
    for (std::size_t at = 0; at < text_.size(); ++at)
      if (types_.named(at) != npos) last_use_[types_.named(at)] = at;
    return !last_use_.empty();
  }

  void find(std::size_t at) {
    const std::size_t semicolon = expression_end(text_, at + 2);
    if (semicolon == npos || !text_.is(semicolon, ";")) return;
    const Loop loop{before_attributes(at), at + 2, semicolon,
                    statement_end(text_.matching_bracket(at + 1) + 1)};
    const std::vector<std::size_t> variables = declared_in(loop);
    const bool outlives = std::any_of(variables.begin(), variables.end(),
                                      [&](std::size_t variable) { return last_use_[variable] > loop.end; });
    if (!outlives || !stands_in_block(loop.place)) return;
    loops_.push_back(loop);
    for (const std::size_t variable : variables) loop_of_[variable] = loops_.size() - 1;
  }

  std::vector<std::size_t> declared_in(const Loop& loop) const {
    std::vector<std::size_t> variables;
    for (std::size_t name = loop.first; name < loop.semicolon; ++name) {
      const std::size_t index = types_.named(name);
      if (index != npos && types_.declared()[index].name == name) variables.push_back(index);
    }
    return variables;
  }

  std::string new_name(std::size_t variable) const {
    const std::size_t name = types_.declared()[variable].name;
    // The name is unique among all loops: the token's index is part of it.
    return text_.free_name(std::string(text_[name].spelling) + "_of_loop" + std::to_string(name));
  }

  void move_declaration(const Loop& loop) {
    std::string moved;
    for (std::size_t at = loop.first; at < loop.semicolon; ++at)
      moved +=
          (loop_of_.count(types_.named(at)) != 0 ? new_name(types_.named(at)) : text_.spelled(at, 1)) + " ";
    text_.insert_from(loop.first, loop.place, moved + "; ");
    text_.erase(loop.first, loop.semicolon - loop.first);
  }

  void rename() {
    std::size_t next = 0;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      while (next < loops_.size() && loops_[next].semicolon <= at) ++next;
      const bool moved = next < loops_.size() && loops_[next].first <= at;
      const auto loop = moved ? loop_of_.end() : loop_of_.find(types_.named(at));
      if (loop == loop_of_.end()) continue;
      text_.replace(at, 1, new_name(loop->first));
      if (at > loops_[loop->second].end && hides_another(loop->first)) warn(at);
    }
  }

  // Returns whether the loop stands in the scope of another variable of that name.
  bool hides_another(std::size_t variable) const {
    const DeclaredValue& own = types_.declared()[variable];
    const std::uint32_t name = text_.identifier_number(own.name);
    for (std::size_t at = own.name; at-- > 0;) {
      if (text_.is(at, "}") && text_.matching_bracket(at) != npos) {
        at = text_.matching_bracket(at);
      } else if (text_.identifier_number(at) == name && types_.named(at) != npos &&
                 types_.named(at) != variable) {
        return !belongs_to_loop(types_.named(at));
      }
    }
    return false;
  }

  bool belongs_to_loop(std::size_t variable) const {
    const std::size_t first = types_.declared()[variable].first;
    return first != npos && first >= 2 && text_.is(first - 2, "for");
  }

  void warn(std::size_t at) {
    const std::string name(text_[at].spelling);
    text_.note(
        at, hlsl::Severity::warning,
        "'" + name +
            "' here refers to the variable of the loop above, not to the one declared before the loop; " +
            "rename the loop's variable");
  }

  // Returns one past the statement that begins here.
  std::size_t statement_end(std::size_t at) const {
    while (text_.is(at, "[") && text_.matching_bracket(at) != npos) at = text_.matching_bracket(at) + 1;
    if (text_.is(at, "{"))
      return text_.matching_bracket(at) == npos ? text_.size() : text_.matching_bracket(at);
    const bool headed = text_.is(at, "for") || text_.is(at, "while") || text_.is(at, "if");
    if (headed && text_.is(at + 1, "(") && text_.matching_bracket(at + 1) != npos) {
      const std::size_t end = statement_end(text_.matching_bracket(at + 1) + 1);
      return text_.is(at, "if") && text_.is(end + 1, "else") ? statement_end(end + 2) : end;
    }
    const std::size_t end = expression_end(text_, at);
    return end == npos ? text_.size() : end;
  }

  std::size_t before_attributes(std::size_t at) const {
    while (at > 0 && text_.is(at - 1, "]") && text_.matching_bracket(at - 1) != npos)
      at = text_.matching_bracket(at - 1);
    return at;
  }

  bool stands_in_block(std::size_t at) const {
    return at > 0 && (text_.is(at - 1, "{") || text_.is(at - 1, "}") || text_.is(at - 1, ";"));
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<std::size_t> last_use_;
  std::vector<Loop> loops_;                               // loops in the order of the text
  std::unordered_map<std::size_t, std::size_t> loop_of_;  // for a declared value: index into loops_
};

}  // namespace

void keep_loop_variables(TokenText& text) {
  LoopVariables(text).run();
}

}  // namespace penumbra::preparation
