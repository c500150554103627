#include "validation/shard.h"

#include <algorithm>
#include <string>

#include "platform/content_hash.h"

namespace penumbra::validation {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const CompileUnit& unit) {
  return fs::absolute(unit.file).lexically_normal().parent_path();
}

fs::path common_folder(const std::vector<CompileUnit>& units) {
  fs::path common = folder_of(units.front());
  for (const CompileUnit& unit : units) {
    const fs::path folder = folder_of(unit);
    const auto differ = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
    fs::path shared;
    for (auto part = common.begin(); part != differ.first; ++part) shared /= *part;
    common = std::move(shared);
  }
  return common;
}

std::uint64_t place_of(const CompileUnit& unit, const fs::path& common) {
  platform::ContentHash hash;
  hash.update(fs::absolute(unit.file).lexically_normal().lexically_relative(common).generic_string());
  const bool compared = unit.program >= 0 && unit.compile.stage != hlsl::Stage::compute;
  compared ? add_variant_names(hash, unit) : add_names(hash, unit);
  return std::stoull(hash.hex().substr(0, 16), nullptr, 16);
}

}  // namespace

std::vector<std::size_t> units_of_shard(const std::vector<CompileUnit>& units, const Shard& shard) {
  std::vector<std::size_t> own;
  if (units.empty()) return own;
  const fs::path common = common_folder(units);
  for (std::size_t i = 0; i < units.size(); ++i)
    if (shard.count <= 1 || place_of(units[i], common) % shard.count == shard.index - 1) own.push_back(i);
  return own;
}

}  // namespace penumbra::validation
