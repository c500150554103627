// The integers and conditions that every thread of a group computes from its thread number alone. Internal to
// this folder.
//
// They are those of the group with SV_GroupID 0. Arithmetic is of 32 bits, as in HLSL.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "spirv/code.h"

namespace penumbra::lint {

class ThreadValues {
 public:
  using OfThreads = std::vector<std::uint32_t>;  // one for each thread, in the order of SV_GroupIndex

  explicit ThreadValues(const spirv::Code& code);  // a legalised compute shader, which must outlive this

  std::size_t threads() const { return threads_; }  // 0 if it is unknown
  // Returns null if the value depends on anything else, or is no scalar. The result stays valid.
  const OfThreads* of(spirv::Id value);

 private:
  using Components = std::vector<OfThreads>;

  const std::optional<Components>& components(spirv::Id value);
  std::optional<Components> computed(const spirv::Instruction& instruction);
  std::optional<Components> loaded(const spirv::Instruction& load);
  OfThreads thread_number(std::size_t axis) const;

  const spirv::Code& code_;
  std::vector<std::uint32_t> size_;
  std::size_t threads_ = 0;
  int depth_ = 0;
  std::map<spirv::Id, std::optional<Components>> known_;
};

}  // namespace penumbra::lint
