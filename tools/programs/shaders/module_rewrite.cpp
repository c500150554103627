#include "shaders/module_rewrite.h"

#include "hlsl/name_set.h"

namespace penumbra::shaders {

namespace {

void append(SpirvModule& to, spirv::Words words) {
  to.insert(to.end(), words.begin(), words.end());
}

void append(SpirvModule& to, spv::Op op, const ModuleRewrite::Words& operands) {
  to.push_back(static_cast<std::uint32_t>((operands.size() + 1) << 16U) | op);
  append(to, operands);
}

bool is_annotation(spv::Op op) {
  return hlsl::is_one_of(op, {spv::OpDecorate, spv::OpMemberDecorate, spv::OpDecorateString,
                              spv::OpMemberDecorateString, spv::OpDecorateId});
}

bool is_type(spv::Op op) {
  return op >= spv::OpTypeVoid && op <= spv::OpTypeForwardPointer;
}

// Returns whether type() takes this kind of type: a module may have each of them once.
bool is_there_once(spv::Op op) {
  return hlsl::is_one_of(op, {spv::OpTypeVoid, spv::OpTypeBool, spv::OpTypeInt, spv::OpTypeFloat,
                              spv::OpTypeVector, spv::OpTypePointer, spv::OpTypeFunction});
}

}  // namespace

ModuleRewrite::ModuleRewrite(const SpirvModule& module) : module_(module), next_(module[3]) {
  spirv::for_each_instruction(module, [this](spirv::Words one) {
    const spv::Op op = spirv::opcode(one);
    if (!is_there_once(op)) return;
    Words key{static_cast<std::uint32_t>(op)};
    key.insert(key.end(), one.begin() + 2, one.end());
    types_.emplace(std::move(key), one[1]);
  });
}

void ModuleRewrite::keep(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  types_begun_ = types_begun_ || is_type(op);
  functions_begun_ = functions_begun_ || op == spv::OpFunction;
  if (functions_begun_) return append(functions_, instruction);
  if (types_begun_) return append(globals_, instruction);
  append(is_annotation(op) ? annotations_ : head_, instruction);
}

std::uint32_t ModuleRewrite::result(spv::Op op, std::uint32_t type, const Words& operands,
                                    std::uint32_t wanted) {
  Words all{type, wanted != 0 ? wanted : next_++};
  append(all, operands);
  append(functions_, op, all);
  return all[1];
}

void ModuleRewrite::code(spv::Op op, const Words& operands) {
  append(functions_, op, operands);
}

std::uint32_t ModuleRewrite::type(spv::Op op, const Words& operands) {
  Words key{static_cast<std::uint32_t>(op)};
  append(key, operands);
  const auto known = types_.find(key);
  if (known != types_.end()) return known->second;
  return types_[key] = new_type(op, operands);
}

std::uint32_t ModuleRewrite::new_type(spv::Op op, const Words& operands) {
  Words all{next_++};
  append(all, operands);
  append(globals_, op, all);
  return all[0];
}

std::uint32_t ModuleRewrite::uint_type() {
  return type(spv::OpTypeInt, {32, 0});
}

std::uint32_t ModuleRewrite::uint_constant(std::uint32_t value) {
  const auto known = constants_.find(value);
  if (known != constants_.end()) return known->second;
  return constants_[value] = constant(spv::OpConstant, uint_type(), {value});
}

std::uint32_t ModuleRewrite::constant(spv::Op op, std::uint32_t type, const Words& operands) {
  Words all{type, next_++};
  append(all, operands);
  append(globals_, op, all);
  return all[1];
}

void ModuleRewrite::global(spv::Op op, const Words& operands) {
  append(globals_, op, operands);
}

void ModuleRewrite::decoration(spv::Op op, const Words& operands) {
  append(decorations_, op, operands);
}

void ModuleRewrite::name(spv::Op op, const Words& operands) {
  append(names_, op, operands);
}

SpirvModule ModuleRewrite::finished() const {
  SpirvModule all(module_.begin(), module_.begin() + spirv::header_words);
  all[3] = next_;
  for (const SpirvModule* part : {&head_, &names_, &annotations_, &decorations_, &globals_, &functions_})
    append(all, *part);
  return all;
}

}  // namespace penumbra::shaders
