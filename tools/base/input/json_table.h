// JSON documents with a list of many similar objects, as tables that spreadsheets read too.
//
// The first lines begin with '#' and hold the document as JSON, in which the list is replaced by an object
// with the values that all its elements share. The next line names the columns, and each line after it is one
// element. Columns are separated by tabs. A column's name is the path of its value in the element, with '/'
// between keys and indices: `per_cascade/0/bias`; a '/' of a key is "~1", and a '~' "~0". A cell is a JSON
// value, or a text without quotes where it cannot be taken for one. An empty cell says that the element has
// no such value.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "input/located_json.h"

namespace penumbra {

// The significant digits of the number at a path, which is no integer.
using DigitsOfPath = std::function<int(const std::string& path)>;
inline constexpr int kAllDigits = 0;

// `document` is JSON, and `list` the key of the list in it, whose elements are objects. No cell begins a
// formula of a spreadsheet.
std::string json_table(std::string_view document, const std::string& list, const DigitsOfPath& digits);

bool is_json_table(std::string_view text);  // by its first character

// The document. Throws InputError as LocatedJson::parse(), and for rows with other columns than the named
// ones.
LocatedJson parse_json_table(std::string_view text, const std::string& name, const std::string& list);

}  // namespace penumbra
