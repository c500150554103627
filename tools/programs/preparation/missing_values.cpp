#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/entry_functions.h"
#include "preparation/resource_types.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

using Functions = std::map<std::string_view, std::vector<const hlsl::Declaration*>>;

bool has_return(const TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = function.open; at < function.close; ++at)
    if (text.is(at, "return")) return true;
  return false;
}

// The function returns a value: a missing texture or sampler is an error of its own.
bool lacks_return(const TokenText& text, const hlsl::Declaration& function) {
  std::size_t type = function.type;
  while (type < function.name && is_modifier(text[type].spelling)) ++type;
  return !text.is(type, "void") && !is_resource(text[type].spelling) && !has_return(text, function);
}

// The front end reports `return;` in a function without any value. This reports it in a function that returns
// values elsewhere.
void refuse_bare_returns(TokenText& text, const hlsl::Declaration& function) {
  std::size_t type = function.type;
  while (type < function.name && is_modifier(text[type].spelling)) ++type;
  if (text.is(type, "void")) return;
  std::vector<std::size_t> bare;
  bool has_value = false;
  for (std::size_t at = function.open; at < function.close; ++at) {
    if (!text.is(at, "return")) continue;
    if (!text.is(at + 1, ";"))
      has_value = true;
    else if (!text.is(at - 1, "return"))
      bare.push_back(at);
  }
  for (const std::size_t at : bare)
    if (has_value)
      text.note(at, hlsl::Severity::error,
                "'" + std::string(text[function.name].spelling) + "' returns a " +
                    std::string(text[type].spelling) + ": this return needs a value (X3080)");
}

// Returns the names that the entry point calls, and those that these call.
std::set<std::string_view> called_names(const TokenText& text, const Functions& functions,
                                        std::string_view entry) {
  std::set<std::string_view> called{entry};
  std::vector<std::string_view> waiting{entry};
  while (!waiting.empty()) {
    const auto known = functions.find(waiting.back());
    waiting.pop_back();
    for (const hlsl::Declaration* function : known->second)
      for (std::size_t at = function->open; at < function->close; ++at)
        if (text.is_identifier(at) && text.is(at + 1, "(") && functions.contains(text[at].spelling) &&
            called.insert(text[at].spelling).second)
          waiting.push_back(text[at].spelling);
  }
  return called;
}

}  // namespace

void check_missing_values(TokenText& text, const EntryPoint& entry) {
  if (entry_functions(text, entry).empty()) return;
  Functions functions;
  std::vector<const hlsl::Declaration*> suspects;
  for (const hlsl::Declaration& declaration : text.declarations()) {
    if (declaration.kind != hlsl::Declaration::Kind::function) continue;
    functions[text[declaration.name].spelling].push_back(&declaration);
    refuse_bare_returns(text, declaration);
    if (lacks_return(text, declaration)) suspects.push_back(&declaration);
  }
  if (suspects.empty()) return;
  const std::set<std::string_view> called = called_names(text, functions, entry.name);
  for (const hlsl::Declaration* function : suspects) {
    const std::string_view name = text[function->name].spelling;
    if (called.contains(name) && functions.at(name).size() == 1)
      text.note(function->name, hlsl::Severity::error,
                "'" + std::string(name) +
                    "' has no return statement: return a value, or make it void (not all control paths "
                    "return a value, X3507)");
  }
}

}  // namespace penumbra::preparation
