// Rows of the table of techniques that the renderer feature reads (Runtime/Techniques/Techniques.txt).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace penumbra::techniques {

// Returns the shortest text that is this float.
std::string table_number(double value);

// A row of columns separated by tabs. Throws std::invalid_argument where a column would not stay in its
// place: names and texts of manifests have no control characters (manifest_reader.h).
class TableRow {
 public:
  explicit TableRow(const std::string& kind);
  TableRow& add(std::string_view column);
  TableRow& add(int number) { return add(std::to_string(number)); }
  // The columns that only some rows have: name=value, or a name alone.
  TableRow& option(const std::string& name, const std::string& value);  // left out if the value is empty
  TableRow& option(const std::string& name, int value, int otherwise);
  TableRow& option(const std::string& name, bool is_set);
  std::string line() const { return text_ + "\n"; }

 private:
  std::string text_;
};

}  // namespace penumbra::techniques
