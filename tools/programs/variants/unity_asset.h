// Unity's text assets: the fields of their YAML, one per line, as the editor writes them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra::variants {

// "  - name: value", "    - value" (without a name) or "  name: value".
struct AssetField {
  int line = 0;            // 1-based
  std::size_t indent = 0;  // column of the name, behind the "- " of an item
  bool begins_item = false;
  std::string_view name;
  std::string_view value;
};

// Reads each line on its own, in linear time; `text` must outlive the fields. Throws InputError for a binary
// asset.
std::vector<AssetField> asset_fields(std::string_view text, const std::string& file);

// Throws InputError with the field's line unless its value is an integer from 0 to `highest`.
int number_in(const AssetField& field, int highest, const std::string& file);

// Returns the guid in "{fileID: 4800000, guid: 0123..., type: 3}"; empty if there is none.
std::string guid_in(std::string_view value);

}  // namespace penumbra::variants
