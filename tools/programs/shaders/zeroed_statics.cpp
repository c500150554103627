#include "shaders/zeroed_statics.h"

#include <algorithm>
#include <map>
#include <set>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

class ZeroedStatics {
 public:
  void run(SpirvModule& module) {
    SpirvModule result(module.begin(), module.begin() + spirv::header_words);
    spirv::for_each_instruction(module, [&](spirv::Words words) {
      const spv::Op op = spirv::opcode(words);
      if (op == spv::OpTypePointer && words[2] == spv::StorageClassPrivate) pointees_[words[1]] = words[3];
      if (has_null(op, words)) nullable_.insert(words[1]);
      const bool unset = op == spv::OpVariable && words.size() == 4 && words[3] == spv::StorageClassPrivate;
      if (!unset || !nullable_.contains(pointees_[words[1]])) {
        result.insert(result.end(), words.begin(), words.end());
        return;
      }
      const std::uint32_t null = null_of(pointees_[words[1]], result);
      result.insert(result.end(), {5U << 16U | spv::OpVariable, words[1], words[2], words[3], null});
    });
    module = std::move(result);
  }

 private:
  bool has_null(spv::Op op, spirv::Words words) const {
    switch (op) {
      case spv::OpTypeBool:
      case spv::OpTypeInt:
      case spv::OpTypeFloat:
        return true;
      case spv::OpTypeVector:
      case spv::OpTypeMatrix:
      case spv::OpTypeArray:
        return nullable_.contains(words[2]);
      case spv::OpTypeStruct:
        return std::all_of(words.begin() + 2, words.end(),
                           [&](std::uint32_t member) { return nullable_.contains(member); });
      default:
        return false;
    }
  }

  std::uint32_t null_of(std::uint32_t type, SpirvModule& result) {
    std::uint32_t& null = nulls_[type];
    if (null == 0) {
      null = result[3]++;
      result.insert(result.end(), {3U << 16U | spv::OpConstantNull, type, null});
    }
    return null;
  }

  std::map<std::uint32_t, std::uint32_t> pointees_;  // types that pointers to private variables point to
  std::set<std::uint32_t> nullable_;                 // nullable types
  std::map<std::uint32_t, std::uint32_t> nulls_;     // null constants by type
};

}  // namespace

void zero_statics(SpirvModule& module) {
  ZeroedStatics().run(module);
}

}  // namespace penumbra::shaders
