#include "spirv/code.h"

#include <spirv-tools/libspirv.hpp>
#include <stdexcept>

namespace penumbra::spirv {

namespace {

constexpr std::uint32_t most_ids = 0x400000;  // specification 2.17, universal limits

std::uint64_t key(Id id, std::uint32_t member_plus_one = 0) {
  return (static_cast<std::uint64_t>(id) << 32U) | member_plus_one;
}

}  // namespace

struct SpirvReader {
  Code& code;
  std::size_t at = 5;  // the first word behind the header
  Place place;
  bool in_function = false;

  void read(const spv_parsed_instruction_t& parsed) {
    Instruction instruction;
    instruction.op = static_cast<spv::Op>(parsed.opcode);
    instruction.type = parsed.type_id;
    instruction.result = parsed.result_id;
    const std::size_t head = 1 + (parsed.type_id != 0 ? 1 : 0) + (parsed.result_id != 0 ? 1 : 0);
    instruction.operands = std::span(code.words_).subspan(at + head, parsed.num_words - head);
    at += parsed.num_words;
    track_place(instruction);
    if (instruction.op == spv::OpLine || instruction.op == spv::OpNoLine) return;
    instruction.place = place;
    note_ids(parsed, instruction);
    note(instruction);
    code.instructions_.push_back(instruction);
    structure(instruction);
  }

  void note_ids(const spv_parsed_instruction_t& parsed, Instruction& instruction) {
    instruction.ids_begin = code.ids_.size();
    for (std::uint16_t i = 0; i < parsed.num_operands; ++i) {
      const spv_operand_type_t type = parsed.operands[i].type;
      if (type == SPV_OPERAND_TYPE_ID || type == SPV_OPERAND_TYPE_SCOPE_ID ||
          type == SPV_OPERAND_TYPE_MEMORY_SEMANTICS_ID)
        code.ids_.push_back(parsed.words[parsed.operands[i].offset]);
    }
    instruction.ids_end = code.ids_.size();
  }

  // OpLine holds up to the next one, or to the end of the block (specification 3.52.3).
  void track_place(const Instruction& instruction) {
    if (instruction.op == spv::OpLine) {
      place = {instruction.operands[0], static_cast<int>(instruction.operands[1])};
    } else if (instruction.op == spv::OpNoLine || instruction.op == spv::OpLabel ||
               instruction.op == spv::OpFunctionEnd) {
      place = {};
    }
  }

  void note(const Instruction& instruction) {
    const auto& operands = instruction.operands;
    if (instruction.result != 0 && instruction.result < code.definitions_.size())
      code.definitions_[instruction.result] = static_cast<std::uint32_t>(code.instructions_.size() + 1);
    switch (instruction.op) {
      case spv::OpName:
        code.names_[key(operands[0])] = literal_text(operands.subspan(1));
        break;
      case spv::OpMemberName:
        code.names_[key(operands[0], operands[1] + 1)] = literal_text(operands.subspan(2));
        break;
      case spv::OpString:
        code.strings_[instruction.result] = literal_text(operands);
        break;
      case spv::OpDecorate:
        code.decorations_[{key(operands[0]), operands[1]}] = operands.size() > 2 ? operands[2] : 0;
        break;
      case spv::OpMemberDecorate:
        code.decorations_[{key(operands[0], operands[1] + 1), operands[2]}] =
            operands.size() > 3 ? operands[3] : 0;
        break;
      default:
        break;
    }
  }

  void structure(const Instruction& instruction) {
    const std::size_t after = code.instructions_.size();
    switch (instruction.op) {
      case spv::OpFunction:
        code.function_index_[instruction.result] = code.functions_.size();
        code.functions_.emplace_back();
        in_function = true;
        break;
      case spv::OpFunctionParameter:
        if (!code.functions_.empty()) code.functions_.back().parameters.push_back(instruction.result);
        break;
      case spv::OpLabel:
        if (!code.functions_.empty())
          code.functions_.back().blocks.push_back({instruction.result, after, after});
        break;
      case spv::OpFunctionEnd:
        in_function = false;
        break;
      default:
        if (!code.functions_.empty() && !code.functions_.back().blocks.empty())
          code.functions_.back().blocks.back().end = after;
        break;
    }
  }
};

Code::Code(std::vector<std::uint32_t> words) : words_(std::move(words)) {
  if (words_.size() < 5 || words_[0] != spv::MagicNumber) throw std::invalid_argument("not a SPIR-V module");
  if (words_[3] > most_ids) throw std::invalid_argument("the SPIR-V module's bound is above the limit");
  definitions_.assign(words_[3], 0);
  SpirvReader reader{*this, 5, {}};
  const spvtools::Context context(SPV_ENV_VULKAN_1_1);
  spv_diagnostic diagnostic = nullptr;
  const auto visit = [](void* user, const spv_parsed_instruction_t* instruction) {
    static_cast<SpirvReader*>(user)->read(*instruction);
    return SPV_SUCCESS;
  };
  const spv_result_t result =
      spvBinaryParse(context.CContext(), &reader, words_.data(), words_.size(), nullptr, visit, &diagnostic);
  const std::string reason = diagnostic == nullptr ? "not a SPIR-V module" : diagnostic->error;
  spvDiagnosticDestroy(diagnostic);
  if (result != SPV_SUCCESS) throw std::invalid_argument(reason);
  if (reader.in_function) throw std::invalid_argument("a function of the SPIR-V module has no end");
}

const Instruction* Code::definition(Id id) const {
  if (id >= definitions_.size() || definitions_[id] == 0) return nullptr;
  return &instructions_[definitions_[id] - 1];
}

spv::Op Code::op(Id id) const {
  const Instruction* instruction = definition(id);
  return instruction == nullptr ? spv::OpNop : instruction->op;
}

const Function* Code::function(Id id) const {
  const auto found = function_index_.find(id);
  return found == function_index_.end() ? nullptr : &functions_[found->second];
}

std::string Code::name(Id id) const {
  const auto found = names_.find(key(id));
  return found == names_.end() ? std::string() : found->second;
}

std::string Code::member_name(Id type, std::uint32_t member) const {
  const auto found = names_.find(key(type, member + 1));
  return found == names_.end() ? std::to_string(member) : found->second;
}

std::string Code::file_name(Id file) const {
  const auto found = strings_.find(file);
  return found == strings_.end() ? std::string() : found->second;
}

std::optional<std::uint32_t> Code::decoration(Id id, spv::Decoration kind) const {
  const auto found = decorations_.find({key(id), kind});
  return found == decorations_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint32_t> Code::member_decoration(Id type, std::uint32_t member,
                                                     spv::Decoration kind) const {
  const auto found = decorations_.find({key(type, member + 1), kind});
  return found == decorations_.end() ? std::nullopt : std::optional(found->second);
}

Id Code::pointee(Id pointer_type) const {
  const Instruction* type = definition(pointer_type);
  return type != nullptr && type->op == spv::OpTypePointer ? type->operands[1] : 0;
}

std::optional<spv::StorageClass> Code::storage_class(Id pointer_type) const {
  const Instruction* type = definition(pointer_type);
  if (type == nullptr || type->op != spv::OpTypePointer) return std::nullopt;
  return static_cast<spv::StorageClass>(type->operands[0]);
}

std::optional<std::int64_t> Code::integer(Id id) const {
  const Instruction* constant = definition(id);
  if (constant == nullptr || constant->op != spv::OpConstant) return std::nullopt;
  const Instruction* type = definition(constant->type);
  if (type == nullptr || type->op != spv::OpTypeInt || type->operands[0] != 32) return std::nullopt;
  const std::uint32_t bits = constant->operands[0];
  return type->operands[1] != 0 ? static_cast<std::int64_t>(static_cast<std::int32_t>(bits))
                                : static_cast<std::int64_t>(bits);
}

}  // namespace penumbra::spirv
