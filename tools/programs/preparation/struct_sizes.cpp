#include <map>
#include <string>
#include <string_view>

#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

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
    const std::string named = "'" + std::string(text_[first].spelling) + "'";
    text_.note(first, hlsl::Severity::error,
               is_endless ? named + " contains itself"
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

bool check_struct_sizes(TokenText& text) {
  return StructSizes(text).run();
}

}  // namespace penumbra::preparation
