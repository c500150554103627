#include "shaders/shared_registers.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>

#include "hlsl/declarations.h"
#include "hlsl/tokens.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

struct Placed {
  std::size_t name = 0;      // its token
  std::string register_set;  // "t, space1"
  std::size_t first = 0;     // register
  std::size_t count = 1;
};

class RegisterReader {
 public:
  explicit RegisterReader(const std::vector<hlsl::Token>& tokens) : tokens_(tokens) {}

  std::vector<Placed> run() {
    for (const hlsl::Declaration& declaration : hlsl::read_declarations(tokens_)) {
      const bool buffer = declaration.kind == hlsl::Declaration::Kind::buffer;
      if (declaration.name == hlsl::Declaration::none) continue;
      if (!buffer && declaration.kind != hlsl::Declaration::Kind::variable) continue;
      read(declaration.name, buffer ? declaration.open : declaration.last);
    }
    return std::move(found_);
  }

 private:
  bool is(std::size_t at, std::string_view spelling) const {
    return at < tokens_.size() && tokens_[at].spelling == spelling;
  }

  static std::size_t number(std::string_view text, std::size_t otherwise) {
    std::size_t value = otherwise;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }

  // Reads `a : register(t0), b[2] : register(t1, space1)` from its first name to `end`.
  void read(std::size_t name, std::size_t end) {
    Placed placed{name, "", 0, 1};
    for (std::size_t at = name + 1; at < end; ++at) {
      if (is(at, "=") || is(at, "{")) return;
      if (is(at, ",")) placed = {at + 1, "", 0, 1};
      if (is(at, "[") && is(at + 2, "]")) placed.count *= number(tokens_[at + 1].spelling, 1);
      if (is(at, "register") && is(at + 1, "(") && at + 3 < end) at = read_register(at + 2, placed);
    }
  }

  std::size_t read_register(std::size_t at, Placed& placed) {
    const std::string_view word = tokens_[at].spelling;
    const bool of_resources =
        word.size() > 1 && std::string_view("tsub").find(word[0]) != std::string_view::npos;
    if (!of_resources || word.find_first_not_of("0123456789", 1) != std::string_view::npos) return at;
    placed.first = number(word.substr(1), 0);
    placed.register_set = word[0];
    if (is(at + 1, ",") && at + 2 < tokens_.size()) {
      placed.register_set.append(", ").append(tokens_[at + 2].spelling);
      at += 2;
    }
    found_.push_back(placed);
    return at + 1;
  }

  const std::vector<hlsl::Token>& tokens_;
  std::vector<Placed> found_;
};

bool overlap(const Placed& a, const Placed& b) {
  return a.register_set == b.register_set && a.first < b.first + b.count && b.first < a.first + a.count;
}

// Returns the names of a module's resources; for a block that of its type.
std::set<std::string> used_names(const SpirvModule& module) {
  std::map<std::uint32_t, std::string> names;
  std::map<std::uint32_t, std::uint32_t> pointed;  // by pointer type
  std::set<std::string> used;
  spirv::for_each_instruction(module, [&](spirv::Words words) {
    const spv::Op op = spirv::opcode(words);
    if (op == spv::OpName && words.size() > 2) names[words[1]] = spirv::literal_text(words.subspan(2));
    if (op == spv::OpTypePointer && words.size() > 3) pointed[words[1]] = words[3];
    if (op != spv::OpVariable || words.size() < 4) return;
    const bool resource = words[3] == spv::StorageClassUniformConstant ||
                          words[3] == spv::StorageClassUniform || words[3] == spv::StorageClassStorageBuffer;
    if (!resource) return;
    used.insert(names[words[2]]);
    used.insert(names[pointed[words[1]]]);
  });
  return used;
}

}  // namespace

std::vector<hlsl::Diagnostic> shared_registers(const SpirvModule& optimised, const std::string& text,
                                               const std::string& file) {
  if (text.find("register") == std::string::npos) return {};
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  std::vector<Placed> placed = RegisterReader(tokens).run();
  const std::set<std::string> used = used_names(optimised);
  std::erase_if(placed,
                [&](const Placed& one) { return !used.contains(std::string(tokens[one.name].spelling)); });
  std::vector<hlsl::Diagnostic> problems;
  for (std::size_t later = 1; later < placed.size(); ++later) {
    const auto earlier = std::find_if(placed.begin(), placed.begin() + static_cast<std::ptrdiff_t>(later),
                                      [&](const Placed& one) { return overlap(one, placed[later]); });
    if (earlier == placed.begin() + static_cast<std::ptrdiff_t>(later)) continue;
    const hlsl::Token& name = tokens[placed[later].name];
    problems.push_back(
        error_at(SourcePlace{name.file.empty() ? file : std::string(name.file), name.line},
                 "'" + std::string(name.spelling) + "' and '" + std::string(tokens[earlier->name].spelling) +
                     "' are used and have the same register: leave the registers out, as Unity binds "
                     "by name, or give each its own"));
  }
  return problems;
}

}  // namespace penumbra::shaders
