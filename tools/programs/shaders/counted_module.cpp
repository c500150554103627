#include "shaders/counted_module.h"

#include <glslang/SPIRV/GLSL.std.450.h>

#include <stdexcept>

#include "hlsl/name_set.h"
#include "shaders/image_holders.h"
#include "shaders/module_rewrite.h"
#include "shaders/spirv_module.h"
#include "spirv/code.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

using spirv::Id;
using Words = ModuleRewrite::Words;

bool reads_a_texel(spv::Op op) {
  const bool samples = op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageRead;
  const bool sparse = op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseDrefGather;
  return samples || sparse || op == spv::OpImageSparseRead || op == spv::OpImageTexelPointer;
}

// The texels that it names. Whether a sampler filters is not known here.
std::uint32_t texels_read(spv::Op op) {
  const bool one = hlsl::is_one_of(op, {spv::OpImageFetch, spv::OpImageRead, spv::OpImageSparseFetch,
                                        spv::OpImageSparseRead, spv::OpImageTexelPointer});
  return one ? 1 : 4;
}

// The operand of an atomic operation is the result of OpImageTexelPointer.
bool writes_a_texel(spv::Op op) {
  return op == spv::OpImageWrite || op == spv::OpImageTexelPointer;
}

bool ends_the_invocation(spv::Op op) {
  return hlsl::is_one_of(op, {spv::OpKill, spv::OpTerminateInvocation, spv::OpDemoteToHelperInvocationEXT});
}

bool tells_the_source(spv::Op op) {
  return hlsl::is_one_of(op, {spv::OpLine, spv::OpNoLine, spv::OpSource, spv::OpSourceContinued,
                              spv::OpString, spv::OpModuleProcessed});
}

bool ends_a_block(spv::Op op) {
  switch (op) {
    case spv::OpSelectionMerge:
    case spv::OpLoopMerge:  // the count comes before the branch
    case spv::OpBranch:
    case spv::OpBranchConditional:
    case spv::OpSwitch:
    case spv::OpReturn:
    case spv::OpReturnValue:
    case spv::OpUnreachable:
      return true;
    default:
      return ends_the_invocation(op);
  }
}

// Counts the scalar operations of an instruction, as counted_module.h defines them.
class OperationCount {
 public:
  OperationCount(const spirv::Code& code, const std::set<Id>& uncounted)
      : code_(code), uncounted_(uncounted) {}

  std::uint32_t of(const spirv::Instruction& one) const {
    if (one.result != 0 && uncounted_.contains(one.result)) return 0;
    if (one.op == spv::OpExtInst) return of_extended(one);
    if (one.op == spv::OpLoad) return is_shared(one.operands[0]) ? scalars(one.type) : 0;
    if (one.op == spv::OpStore) return is_shared(one.operands[0]) ? scalars(type_of(one.operands[1])) : 0;
    if (one.op >= spv::OpAtomicLoad && one.op <= spv::OpAtomicXor) return 1;
    if (one.op == spv::OpDot) return 2 * scalars(type_of(one.operands[0])) - 1;
    if (one.op == spv::OpAny || one.op == spv::OpAll) return scalars(type_of(one.operands[0]));
    if (const std::uint32_t products = products_of_each(one); products != 0)
      return scalars(one.type) * (2 * products - 1);
    return is_arithmetic(one.op) ? scalars(one.type) : 0;
  }

 private:
  static bool is_arithmetic(spv::Op op) {
    const bool converts = op >= spv::OpConvertFToU && op <= spv::OpQuantizeToF16;
    const bool calculates = op >= spv::OpSNegate && op <= spv::OpOuterProduct;
    const bool widens = op >= spv::OpIAddCarry && op <= spv::OpSMulExtended;
    const bool compares = op >= spv::OpIsNan && op <= spv::OpFUnordGreaterThanEqual;
    const bool of_bits = op >= spv::OpShiftRightLogical && op <= spv::OpBitCount;
    const bool derives = op >= spv::OpDPdx && op <= spv::OpFwidthCoarse;
    return converts || calculates || widens || compares || of_bits || derives;
  }

  // Returns for a product with a matrix how many products add up to each scalar of the result, and 0 for
  // anything else.
  std::uint32_t products_of_each(const spirv::Instruction& one) const {
    switch (one.op) {
      case spv::OpVectorTimesMatrix:
        return scalars(type_of(one.operands[0]));
      case spv::OpMatrixTimesVector:
        return scalars(type_of(one.operands[1]));
      case spv::OpMatrixTimesMatrix:
        return code_.definition(type_of(one.operands[0]))->operands[1];
      default:
        return 0;
    }
  }

  // operands[1] is the number of the function, operands[2] its first argument.
  std::uint32_t of_extended(const spirv::Instruction& one) const {
    const auto components = [&] { return scalars(type_of(one.operands[2])); };
    switch (one.operands[1]) {
      case GLSLstd450Length:
        return 2 * components();
      case GLSLstd450Distance:
      case GLSLstd450Normalize:
        return 3 * components();
      case GLSLstd450Cross:
        return 9;
      default:
        return scalars(one.type);
    }
  }

  bool is_shared(Id pointer) const {
    return code_.storage_class(type_of(pointer)) == spv::StorageClassWorkgroup;
  }

  Id type_of(Id id) const {
    const spirv::Instruction* definition = code_.definition(id);
    return definition == nullptr ? 0 : definition->type;
  }

  std::uint32_t scalars(Id type) const {
    const spirv::Instruction* definition = code_.definition(type);
    if (definition == nullptr) return 1;
    switch (definition->op) {
      case spv::OpTypeVector:
      case spv::OpTypeMatrix:
        return definition->operands[1] * scalars(definition->operands[0]);
      case spv::OpTypeArray:
        return static_cast<std::uint32_t>(code_.integer(definition->operands[1]).value_or(1)) *
               scalars(definition->operands[0]);
      case spv::OpTypeStruct: {
        std::uint32_t all = 0;
        for (const Id member : definition->operands) all += scalars(member);
        return all;
      }
      default:
        return 1;
    }
  }

  const spirv::Code& code_;
  const std::set<Id>& uncounted_;
};

// The operations to add at the end of each block, by its label.
class OperationsOfBlocks {
 public:
  OperationsOfBlocks(const spirv::Code& code, const std::set<Id>& uncounted)
      : code_(code), count_(code, uncounted) {
    for (const spirv::Function& function : code.functions()) {
      for (const spirv::Block& block : function.blocks)
        for (std::size_t i = block.begin; i < block.end; ++i)
          added_[block.label] += count_.of(code.instructions()[i]);
      for (const spirv::Block& block : function.blocks) move_out_of_test(function, block);
    }
  }

  std::uint32_t of(Id label) const {
    const auto found = added_.find(label);
    return found == added_.end() ? 0 : found->second;
  }

 private:
  const spirv::Instruction& terminator(const spirv::Block& block) const {
    return code_.instructions()[block.end - 1];
  }

  bool branches_to(const spirv::Block& block, Id label) const {
    return terminator(block).op == spv::OpBranch && terminator(block).operands[0] == label;
  }

  // When SPIRV-Tools unrolls a loop, it loses the addition in the block of the loop's test: its value after
  // the loop is that of the first test. So the blocks that branch to the loop's head make the addition, which
  // is as frequent, since a test follows each time.
  void move_out_of_test(const spirv::Function& function, const spirv::Block& head) {
    if (!has_unrolled_loop(head) || terminator(head).op != spv::OpBranch) return;
    const Id test = terminator(head).operands[0];
    const auto tests = [&](const spirv::Block& block) {
      return block.label == test && terminator(block).op == spv::OpBranchConditional;
    };
    if (std::none_of(function.blocks.begin(), function.blocks.end(), tests)) return;
    const std::uint32_t moved = std::exchange(added_[head.label], 0) + std::exchange(added_[test], 0);
    for (const spirv::Block& block : function.blocks)
      if (branches_to(block, head.label)) added_[block.label] += moved;
  }

  bool has_unrolled_loop(const spirv::Block& head) const {
    for (std::size_t i = head.begin; i < head.end; ++i) {
      const spirv::Instruction& one = code_.instructions()[i];
      if (one.op == spv::OpLoopMerge) return (one.operands[2] & spv::LoopControlUnrollMask) != 0;
    }
    return false;
  }

  const spirv::Code& code_;
  const OperationCount count_;
  std::map<Id, std::uint32_t> added_;
};

// The module's declarations of the entry point.
struct EntryFacts {
  Id function = 0;
  bool fragment = false;
  Id position = 0;                         // the variable with FragCoord or GlobalInvocationId; 0 for none
  std::set<std::uint32_t> colour_outputs;  // locations
  bool tests_depth_first = false;
};

class FactReader {
 public:
  FactReader(const spirv::Code& code, const std::string& entry) : code_(code) {
    for (const spirv::Instruction& one : code.instructions())
      if (one.op == spv::OpEntryPoint && spirv::literal_text(one.operands.subspan(2)) == entry) entry_ = &one;
    if (entry_ == nullptr) throw std::invalid_argument("the module has no entry point '" + entry + "'");
    const std::uint32_t model = entry_->operands[0];
    if (model != spv::ExecutionModelFragment && model != spv::ExecutionModelGLCompute)
      throw std::invalid_argument("'" + entry + "' is neither a fragment nor a compute shader");
  }

  EntryFacts facts() const {
    EntryFacts facts;
    facts.function = entry_->operands[1];
    facts.fragment = entry_->operands[0] == spv::ExecutionModelFragment;
    facts.position = built_in(facts.fragment ? spv::BuiltInFragCoord : spv::BuiltInGlobalInvocationId,
                              spv::StorageClassInput);
    if (facts.fragment) facts.colour_outputs = colour_outputs();
    facts.tests_depth_first = facts.fragment && may_test_depth_first();
    return facts;
  }

 private:
  std::optional<spv::StorageClass> storage_of(Id id) const {
    const spirv::Instruction* definition = code_.definition(id);
    return definition == nullptr ? std::nullopt : code_.storage_class(definition->type);
  }

  std::vector<Id> interface(spv::StorageClass storage) const {
    std::vector<Id> found;
    for (const Id id : code_.ids(*entry_).subspan(1))
      if (storage_of(id) == storage) found.push_back(id);
    return found;
  }

  Id built_in(spv::BuiltIn which, spv::StorageClass storage) const {
    for (const Id id : interface(storage))
      if (code_.decoration(id, spv::DecorationBuiltIn) == which) return id;
    return 0;
  }

  // The second colour for blending has the first one's location.
  std::set<std::uint32_t> colour_outputs() const {
    std::set<std::uint32_t> locations;
    for (const Id id : interface(spv::StorageClassOutput))
      if (const auto location = code_.decoration(id, spv::DecorationLocation)) locations.insert(*location);
    return locations;
  }

  bool may_test_depth_first() const {
    if (built_in(spv::BuiltInFragDepth, spv::StorageClassOutput) != 0 ||
        built_in(spv::BuiltInSampleMask, spv::StorageClassOutput) != 0)
      return false;
    return std::none_of(code_.instructions().begin(), code_.instructions().end(),
                        [this](const spirv::Instruction& one) { return forbids_depth_first(one); });
  }

  bool forbids_depth_first(const spirv::Instruction& one) const {
    if (ends_the_invocation(one.op) || writes_a_texel(one.op)) return true;
    if (one.op >= spv::OpAtomicLoad && one.op <= spv::OpAtomicXor) return true;
    if (one.op == spv::OpExecutionMode) return one.operands[1] == spv::ExecutionModeEarlyFragmentTests;
    if (one.op != spv::OpStore && one.op != spv::OpCopyMemory) return false;
    const std::optional<spv::StorageClass> to = storage_of(one.operands[0]);
    return to && (*to == spv::StorageClassUniform || *to == spv::StorageClassStorageBuffer);
  }

  const spirv::Code& code_;
  const spirv::Instruction* entry_ = nullptr;
};

Words name_words(Id id, const std::string& text) {
  Words words{id};
  words.resize(2 + text.size() / 4, 0);
  for (std::size_t i = 0; i < text.size(); ++i)
    words[1 + i / 4] |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) << (8 * (i % 4));
  return words;
}

class Counting {
 public:
  Counting(const SpirvModule& module, const spirv::Code& code, const EntryFacts& facts,
           const std::set<Id>& uncounted)
      : module_(module),
        code_(code),
        facts_(facts),
        operations_of_blocks_(code, uncounted),
        holders_(code),
        rewrite_(module) {}

  SpirvModule run() {
    add_counts_ = rewrite_.new_id();
    for (const Id holder : holders_.all()) bytes_of_[holder] = rewrite_.new_id();
    for (Id* counter : counters()) *counter = rewrite_.new_id();
    position_ = facts_.position != 0 ? facts_.position : rewrite_.new_id();
    spirv::for_each_instruction(module_, [this](spirv::Words one) { visit(one); });
    write_add_counts();
    return rewrite_.finished();
  }

 private:
  void visit(spirv::Words one) {
    const spv::Op op = spirv::opcode(one);
    if (tells_the_source(op)) return;
    if (op == spv::OpEntryPoint && one[2] == facts_.function) return keep_entry_point(one);
    if (op == spv::OpFunction) enter_function(one);
    if (op == spv::OpLabel) of_block_ = operations_of_blocks_.of(one[1]);
    if (function_ == facts_.function && !bytes_loaded_ &&
        !hlsl::is_one_of(op, {spv::OpFunction, spv::OpLabel, spv::OpVariable}))
      load_bytes();
    if (ends_a_block(op) && of_block_ != 0) add(operations_, std::exchange(of_block_, 0));
    if (reads_a_texel(op)) {
      add(fetches_, 1);
      add_bytes(bytes_read_, holders_.of(one[3]), texels_read(op));
    }
    if (writes_a_texel(op)) {
      add(written_, 1);
      add_bytes(bytes_written_, holders_.of(one[op == spv::OpImageWrite ? 1 : 3]), 1);
    }
    if (op == spv::OpControlBarrier) add(barriers_, 1);
    follow_images(op, one);
    if (ends_the_invocation(op)) call_add_counts();
    if (op == spv::OpReturn && function_ == facts_.function) {
      if (!facts_.colour_outputs.empty()) {
        add(written_, static_cast<std::uint32_t>(facts_.colour_outputs.size()));
        add_loaded(bytes_written_, loaded(bytes_of_outputs_));
      }
      call_add_counts();
    }
    rewrite_.keep(one);
    const bool of_entry = op == spv::OpExecutionMode && one[1] == facts_.function;
    if (of_entry && facts_.tests_depth_first && !depth_first_told_) {
      depth_first_told_ = true;
      keep(spv::OpExecutionMode, {facts_.function, spv::ExecutionModeEarlyFragmentTests});
    }
  }

  void keep(spv::Op op, const Words& operands) {
    Words words{static_cast<std::uint32_t>((operands.size() + 1) << 16U) | op};
    words.insert(words.end(), operands.begin(), operands.end());
    rewrite_.keep(words);
  }

  // The interface has all global variables since SPIR-V 1.4, before it only inputs and outputs.
  void keep_entry_point(spirv::Words one) {
    Words operands(one.begin() + 1, one.end());
    if (facts_.position == 0) operands.push_back(position_);
    if (module_[1] >= 0x00010400U) {
      counts_ = rewrite_.new_id();
      sizes_ = rewrite_.new_id();
      operands.push_back(counts_);
      if (!sized().empty()) operands.push_back(sizes_);
      for (const Id* counter : counters()) operands.push_back(*counter);
      for (const auto& [holder, bytes] : bytes_of_) operands.push_back(bytes);
    }
    keep(spv::OpEntryPoint, operands);
  }

  std::vector<Id*> counters() {
    return {&fetches_,       &written_,  &operations_,      &bytes_read_,
            &bytes_written_, &barriers_, &bytes_of_outputs_};
  }

  // What the host tells the bytes of: the module's textures, and the colour outputs, by their names.
  struct Sized {
    std::string name;
    Id kept_in = 0;  // a private variable, to which they are added
  };
  std::vector<Sized> sized() const {
    std::vector<Sized> all;
    for (const auto& [holder, bytes] : bytes_of_)
      if (storage_class_of(holder) == spv::StorageClassUniformConstant)
        all.push_back({code_.name(holder), bytes});
    for (const std::uint32_t location : facts_.colour_outputs)
      all.push_back({"SV_Target" + std::to_string(location), bytes_of_outputs_});
    return all;
  }

  std::optional<spv::StorageClass> storage_class_of(Id variable) const {
    const spirv::Instruction* definition = code_.definition(variable);
    if (definition == nullptr || definition->op != spv::OpVariable) return std::nullopt;
    return code_.storage_class(definition->type);
  }

  // The block has a member for each of sized().
  void declare_sizes() {
    const std::vector<Sized> all = sized();
    if (all.empty()) return;
    const Id block = rewrite_.new_type(spv::OpTypeStruct, Words(all.size(), uint_));
    rewrite_.decoration(spv::OpDecorate, {block, spv::DecorationBlock});
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      rewrite_.decoration(spv::OpMemberDecorate, {block, i, spv::DecorationOffset, 4 * i});
      Words name{block};
      const Words text = name_words(i, texel_bytes_uniform(all[i].name));
      name.insert(name.end(), text.begin(), text.end());
      rewrite_.name(spv::OpMemberName, name);
    }
    sizes_ = variable(block, spv::StorageClassUniform, sizes_);
    rewrite_.decoration(spv::OpDecorate, {sizes_, spv::DecorationDescriptorSet, 0});
    rewrite_.decoration(spv::OpDecorate, {sizes_, spv::DecorationBinding, 0});  // as declare_counts()
    rewrite_.name(spv::OpName, name_words(block, texel_bytes_name));
    rewrite_.name(spv::OpName, name_words(sizes_, texel_bytes_name));
  }

  // Follows the variables of the entry point's first block.
  void load_bytes() {
    bytes_loaded_ = true;
    const Id pointer = rewrite_.type(spv::OpTypePointer, {spv::StorageClassUniform, uint_});
    std::uint32_t member = 0;
    for (const Sized& one : sized()) {
      const Id at = rewrite_.result(spv::OpAccessChain, pointer, {sizes_, uint(member++)});
      add_loaded(one.kept_in, rewrite_.result(spv::OpLoad, uint_, {at}));
    }
  }

  void add_bytes(Id counter, Id holder, std::uint32_t texels) {
    if (holder == 0) throw std::logic_error("a texture whose origin is not known is accessed");
    add_loaded(counter, scaled(loaded(bytes_of_.at(holder)), uint(texels)));
  }

  void copy_bytes(Id to, Id from) {
    if (to == 0 || from == 0 || to == from) return;
    rewrite_.code(spv::OpStore, {bytes_of_.at(to), loaded(bytes_of_.at(from))});
  }

  // Where an image is stored, passed or returned, its bytes are, too.
  void follow_images(spv::Op op, spirv::Words one) {
    if (op == spv::OpStore) copy_bytes(holders_.of(one[1]), holders_.of(one[2]));
    if (op == spv::OpReturnValue) copy_bytes(holders_.of(function_), holders_.of(one[1]));
    if (op != spv::OpFunctionCall) return;
    const std::vector<Id>& parameters = code_.function(one[3])->parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      copy_bytes(holders_.of(parameters[i]), holders_.of(one[4 + i]));
  }

  void enter_function(spirv::Words one) {
    function_ = one[2];
    if (void_ != 0) return;
    declare();
  }

  // All types and variables of the module precede the first function.
  void declare() {
    const spirv::Instruction& entry = *code_.definition(facts_.function);
    void_ = entry.type;
    function_type_ = entry.operands[1];
    uint_ = rewrite_.uint_type();
    bool_ = rewrite_.type(spv::OpTypeBool, {});
    declare_position();
    for (const Id* counter : counters()) declare_private(*counter);
    for (const auto& [holder, bytes] : bytes_of_) declare_private(bytes);
    declare_sizes();
    declare_counts();
    rewrite_.name(spv::OpName, name_words(add_counts_, "$AddTexelCounts"));
  }

  void declare_position() {
    if (facts_.position != 0) {
      position_type_ = code_.pointee(code_.definition(facts_.position)->type);
      coordinate_type_ = code_.definition(position_type_)->operands[0];
      return;
    }
    coordinate_type_ = facts_.fragment ? rewrite_.type(spv::OpTypeFloat, {32}) : uint_;
    position_type_ = rewrite_.type(spv::OpTypeVector, {coordinate_type_, facts_.fragment ? 4U : 3U});
    variable(position_type_, spv::StorageClassInput, position_);
    const auto which = facts_.fragment ? spv::BuiltInFragCoord : spv::BuiltInGlobalInvocationId;
    rewrite_.decoration(spv::OpDecorate,
                        {position_, spv::DecorationBuiltIn, static_cast<std::uint32_t>(which)});
  }

  Id variable(Id type, spv::StorageClass storage, Id wanted, Id initial = 0) {
    const Id pointer = rewrite_.type(spv::OpTypePointer, {static_cast<std::uint32_t>(storage), type});
    const Id id = wanted != 0 ? wanted : rewrite_.new_id();
    Words operands{pointer, id, static_cast<std::uint32_t>(storage)};
    if (initial != 0) operands.push_back(initial);
    rewrite_.global(spv::OpVariable, operands);
    return id;
  }

  void declare_private(Id id) { variable(uint_, spv::StorageClassPrivate, id, uint(0)); }

  // SPIR-V 1.3 has a storage class for storage buffers; in earlier versions they are decorated blocks in the
  // Uniform class.
  void declare_counts() {
    const bool own_class = module_[1] >= 0x00010300U;
    storage_ = own_class ? spv::StorageClassStorageBuffer : spv::StorageClassUniform;
    const Id words = rewrite_.new_type(spv::OpTypeRuntimeArray, {uint_});
    const Id block = rewrite_.new_type(spv::OpTypeStruct, {words});
    rewrite_.decoration(spv::OpDecorate, {words, spv::DecorationArrayStride, 4});
    rewrite_.decoration(spv::OpMemberDecorate, {block, 0, spv::DecorationOffset, 0});
    const auto kind = own_class ? spv::DecorationBlock : spv::DecorationBufferBlock;
    rewrite_.decoration(spv::OpDecorate, {block, static_cast<std::uint32_t>(kind)});
    counts_ = variable(block, storage_, counts_);
    rewrite_.decoration(spv::OpDecorate, {counts_, spv::DecorationDescriptorSet, 0});
    rewrite_.decoration(spv::OpDecorate,
                        {counts_, spv::DecorationBinding, 0});  // numbered with the others later
    rewrite_.name(spv::OpName, name_words(block, texel_counts_name));
    rewrite_.name(spv::OpName, name_words(counts_, texel_counts_name));
  }

  void add(Id counter, std::uint32_t amount) { add_loaded(counter, uint(amount)); }

  void add_loaded(Id counter, Id amount) {
    const Id after = rewrite_.result(spv::OpIAdd, uint_, {loaded(counter), amount});
    rewrite_.code(spv::OpStore, {counter, after});
  }

  void call_add_counts() { rewrite_.result(spv::OpFunctionCall, void_, {add_counts_}); }

  Id word_pointer(Id index) {
    const Id pointer = rewrite_.type(spv::OpTypePointer, {static_cast<std::uint32_t>(storage_), uint_});
    return rewrite_.result(spv::OpAccessChain, pointer, {counts_, uint(0), index});
  }

  Id size_of_grid(std::uint32_t axis) {
    return rewrite_.result(spv::OpLoad, uint_, {word_pointer(uint(axis))});
  }

  // The source may declare SV_DispatchThreadID with a sign.
  Id coordinate(Id position, std::uint32_t axis, Id size) {
    Id at = rewrite_.result(spv::OpCompositeExtract, coordinate_type_, {position, axis});
    if (facts_.fragment) {
      at = rewrite_.result(spv::OpConvertFToU, uint_, {at});
    } else if (coordinate_type_ != uint_) {
      at = rewrite_.result(spv::OpBitcast, uint_, {at});
    }
    const Id last = rewrite_.result(spv::OpISub, uint_, {size, uint(1)});
    const Id inside = rewrite_.result(spv::OpULessThan, bool_, {at, last});
    return rewrite_.result(spv::OpSelect, uint_, {inside, at, last});
  }

  Id cell() {
    const Id position = rewrite_.result(spv::OpLoad, position_type_, {position_});
    Id index = 0;
    for (std::uint32_t axis = facts_.fragment ? 2 : 3; axis-- > 0;) {
      const Id size = size_of_grid(axis);
      const Id at = coordinate(position, axis, size);
      index = index == 0 ? at : rewrite_.result(spv::OpIAdd, uint_, {scaled(index, size), at});
    }
    return index;
  }

  Id scaled(Id index, Id size) { return rewrite_.result(spv::OpIMul, uint_, {index, size}); }

  void write_add_counts() {
    rewrite_.result(spv::OpFunction, void_, {spv::FunctionControlMaskNone, function_type_}, add_counts_);
    rewrite_.code(spv::OpLabel, {rewrite_.new_id()});
    const Id cells = rewrite_.result(spv::OpIMul, uint_, {cell(), uint(texel_counts_per_cell)});
    const Id first = rewrite_.result(spv::OpIAdd, uint_, {cells, uint(texel_counts_header)});
    add_atomically(first, loaded(fetches_));
    add_atomically(place_after(first, 1), loaded(written_));
    add_long(place_after(first, 2), place_after(first, 3), operations_);
    add_long(place_after(first, 4), place_after(first, 5), bytes_read_);
    add_long(place_after(first, 6), place_after(first, 7), bytes_written_);
    add_atomically(uint(texel_counts_invocations), uint(1));
    add_long(uint(texel_counts_barriers), uint(texel_counts_barriers + 1), barriers_);
    rewrite_.code(spv::OpReturn, {});
    rewrite_.code(spv::OpFunctionEnd, {});
  }

  Id uint(std::size_t value) { return rewrite_.uint_constant(static_cast<std::uint32_t>(value)); }

  Id loaded(Id counter) { return rewrite_.result(spv::OpLoad, uint_, {counter}); }

  Id place_after(Id first, std::size_t words) {
    return rewrite_.result(spv::OpIAdd, uint_, {first, uint(words)});
  }

  // Returns the word before the addition.
  Id add_atomically(Id index, Id count) {
    return rewrite_.result(
        spv::OpAtomicIAdd, uint_,
        {word_pointer(index), uint(spv::ScopeDevice), uint(spv::MemorySemanticsMaskNone), count});
  }

  // The count has two words: 32 bits are too few for all operations of a picture.
  void add_long(Id low, Id high, Id counter) {
    const Id count = loaded(counter);
    const Id before = add_atomically(low, count);
    const Id after = rewrite_.result(spv::OpIAdd, uint_, {before, count});
    const Id wrapped = rewrite_.result(spv::OpULessThan, bool_, {after, before});
    add_atomically(high, rewrite_.result(spv::OpSelect, uint_, {wrapped, uint(1), uint(0)}));
  }

  const SpirvModule& module_;
  const spirv::Code& code_;
  const EntryFacts facts_;
  const OperationsOfBlocks operations_of_blocks_;
  const ImageHolders holders_;
  std::map<Id, Id> bytes_of_;  // private variables with the bytes of a texel, by holder
  bool bytes_loaded_ = false;
  std::uint32_t of_block_ = 0;  // operations of the block that is visited, until they are added
  ModuleRewrite rewrite_;
  Id function_ = 0;  // the function that is visited
  bool depth_first_told_ = false;
  Id add_counts_ = 0;  // the function that adds the counts
  Id position_ = 0, counts_ = 0, sizes_ = 0;
  Id fetches_ = 0, written_ = 0, operations_ = 0, bytes_read_ = 0, bytes_written_ = 0, barriers_ = 0;
  Id bytes_of_outputs_ = 0;
  Id position_type_ = 0, coordinate_type_ = 0;
  Id void_ = 0, function_type_ = 0, uint_ = 0, bool_ = 0;
  spv::StorageClass storage_ = spv::StorageClassStorageBuffer;
};

}  // namespace

std::string texel_bytes_uniform(const std::string& texture) {
  return std::string(texel_bytes_name) + "(" + texture + ")";
}

spirv::Module counted_module(const spirv::Module& unoptimised, const std::string& entry, VulkanVersion vulkan,
                             const std::set<Id>& uncounted) {
  const spirv::Code code(unoptimised);
  SpirvModule module = Counting(unoptimised, code, FactReader(code, entry).facts(), uncounted).run();
  std::vector<std::string> problems;
  if (finish(module, vulkan, problems)) problems = validation_problems(module, vulkan, false);
  if (!problems.empty()) throw std::logic_error("the module that counts is not valid: " + problems.front());
  return module;
}

}  // namespace penumbra::shaders
