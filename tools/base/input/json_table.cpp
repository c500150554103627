#include "input/json_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "input/input_error.h"
#include "input/locating_parser.h"
#include "input/text_line.h"

namespace penumbra {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t kDeepest = 200;               // as LocatedJson
constexpr std::size_t kSmallTable = 100'000;        // values; a larger one has a character for each
constexpr std::string_view kFormulas = "=+-@#\"'";  // a spreadsheet's, its quotes, and a line of the head

constexpr std::string_view kHex = "0123456789abcdef";

// --- Writing ---

std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return "null";
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string json_text(const ordered_json& value, bool ascii = false) {
  return value.dump(-1, ' ', ascii);
}

bool reads_as_text(const std::string& text) {
  return !text.empty() && is_one_line(text) && kFormulas.find(text.front()) == std::string_view::npos &&
         text.front() != ' ' && text.back() != ' ' && !json::accept(text);
}

// A text in quotes that begins a formula would be one in a spreadsheet, which takes the quotes off.
std::string quoted(const std::string& text) {
  std::string cell = json_text(text, true);
  if (!text.empty() && kFormulas.find(text.front()) != std::string_view::npos && text.front() != '"')
    cell = std::string("\"\\u00") + kHex[text.front() / 16] + kHex[text.front() % 16] + cell.substr(2);
  return cell;
}

std::string cell_of(const ordered_json& value, int digits) {
  if (value.is_number_float())
    return digits == kAllDigits ? json_text(value) : rounded(value.get<double>(), digits);
  if (!value.is_string()) return json_text(value);
  const auto& text = value.get_ref<const std::string&>();
  return reads_as_text(text) ? text : quoted(text);
}

// A part of a column's name, as in JSON pointers (RFC 6901).
std::string token_of(const std::string& key) {
  const bool is_index = std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (is_index || !is_one_line(key))
    throw InputError("", "the name '" + key + "' cannot head a column of a table");
  std::string token;
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

std::string key_of(std::string_view token) {
  std::string key;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const bool escaped =
        token[i] == '~' && i + 1 < token.size() && (token[i + 1] == '0' || token[i + 1] == '1');
    key += !escaped ? token[i] : token[++i] == '1' ? '/' : '~';
  }
  return key;
}

// The values of one element, by their paths.
using Cells = std::map<std::string, std::string>;

void add_cells(const ordered_json& value, const std::string& path, const DigitsOfPath& digits, Cells& cells,
               std::vector<std::string>& columns, std::set<std::string>& known) {
  if (value.is_structured() && !value.empty()) {
    std::size_t index = 0;
    for (const auto& [key, child] : value.items()) {
      const std::string token = value.is_object() ? token_of(key) : std::to_string(index++);
      add_cells(child, path + "/" + token, digits, cells, columns, known);
    }
    return;
  }
  cells[path] = cell_of(value, digits(path));
  if (known.insert(path).second) columns.push_back(path);
}

bool is_shared(const std::vector<Cells>& rows, const std::string& column) {
  return rows.size() > 1 && std::all_of(rows.begin(), rows.end(), [&](const Cells& row) {
           const auto cell = row.find(column);
           const auto first = rows.front().find(column);
           return cell != row.end() && first != rows.front().end() && cell->second == first->second;
         });
}

// Objects that begin with the same member, such as the frames of a scene, share a line.
std::string head_value(const ordered_json& value) {
  if (!value.is_array() || value.empty() || !value.front().is_object()) return json_text(value);
  std::string text = "[";
  const ordered_json* before = nullptr;
  for (const ordered_json& element : value) {
    const bool goes_on = before != nullptr && element.is_object() && !element.empty() && !before->empty() &&
                         element.front() == before->front();
    text += (before == nullptr ? "" : ",") + std::string(goes_on ? " " : "\n#   ") + json_text(element);
    before = &element;
  }
  return text + "]";
}

}  // namespace

std::string json_table(std::string_view json, const std::string& list, const DigitsOfPath& digits) {
  const ordered_json document = ordered_json::parse(json);
  std::vector<Cells> rows;
  std::vector<std::string> columns;
  std::set<std::string> known;
  for (const ordered_json& element : document.at(list)) {
    Cells& row = rows.emplace_back();
    for (const auto& [key, value] : element.items())
      add_cells(value, token_of(key), digits, row, columns, known);
  }
  // The first column stays, so that no row is an empty line.
  const auto own = std::stable_partition(columns.begin() + (columns.empty() ? 0 : 1), columns.end(),
                                         [&](const std::string& column) { return !is_shared(rows, column); });
  std::string text = "# {";
  for (const auto& [key, value] : document.items())
    if (key != list) text += json_text(key) + ": " + head_value(value) + ",\n#  ";
  text += json_text(list) + ": {";
  for (auto column = own; column != columns.end(); ++column) {
    const std::string& cell = rows.front().at(*column);
    text += (column == own ? "" : ", ") + json_text(*column) + ": " +
            (nlohmann::json::accept(cell) ? cell : json_text(cell));
  }
  text += "}}\n";
  columns.erase(own, columns.end());
  for (std::size_t i = 0; i < columns.size(); ++i) text += (i > 0 ? "\t" : "") + columns[i];
  text += '\n';
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto cell = row.find(columns[i]);
      if (i > 0) text += '\t';
      if (cell != row.end()) text += cell->second;
    }
    text += '\n';
  }
  return text;
}

// --- Reading ---

namespace {

std::string in_quotes(std::string_view text) {
  return "'" + std::string(text) + "'";
}

struct Line {
  std::string_view text;
  int number = 1;
};

Line take_line(std::string_view& rest, int& number) {
  const std::size_t end = rest.find('\n');
  Line line{rest.substr(0, end), number++};
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (!line.text.empty() && line.text.back() == '\r') line.text.remove_suffix(1);
  return line;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

// A value of the elements: in a column, or shared by all.
struct Source {
  std::optional<std::size_t> column{};
  json shared{};
  LocatedJson::Place place{};  // of a shared one
};

// The values below one path.
struct Node {
  std::optional<Source> source;
  std::map<std::string, Node> children;
  bool is_array = false;
  bool has_value = false;  // of its own, in the row that is being read
  std::size_t parts = 0;   // children that the row fills

  bool filled() const { return has_value || parts > 0; }
};

struct Row {
  int line = 1;
  std::vector<std::string_view> cells;
  std::vector<int> starts;  // the columns in the line of text, in bytes from 1
};

class TableParser : public LocatingParser {
 public:
  TableParser(const std::string& name, ReadSoFar& place, std::string list, std::string_view rest, int line)
      : LocatingParser(name, place), at_(place), list_(std::move(list)), rest_(rest), line_(line) {}

  // The head ends with its object: the rows follow.
  bool end_object() override {
    if (levels_.size() == 1) add_rows();
    return LocatingParser::end_object();
  }

 private:
  [[noreturn]] void fail(int line, int column, const std::string& problem) const {
    throw InputError(name_ + ":" + std::to_string(line) + ":" + std::to_string(column), problem);
  }

  void add_path(std::string_view path, Source source, int line, int column) {
    const std::vector<std::string_view> tokens = split(path, '/');
    if (tokens.size() > kDeepest) fail(line, column, "nested deeper than 200 levels");
    Node* node = &elements_;
    for (const std::string_view token : tokens) {
      if (token.empty()) fail(line, column, in_quotes(path) + " is no path of a value");
      node = &node->children[key_of(token)];
    }
    if (node->source) fail(line, column, "the column " + in_quotes(path) + " appears twice");
    node->source = std::move(source);
    ++values_;
  }

  // A node is a list where its first child is 0; its children are then the numbers from 0 on.
  void find_lists(Node& node, const std::string& path) {
    node.is_array = node.children.count("0") > 0;
    for (auto& [token, child] : node.children) {
      const bool is_index =
          !token.empty() && token.size() < 10 &&
          std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
      if (node.is_array && (!is_index || std::to_string(std::stoul(token)) != token ||
                            std::stoul(token) >= node.children.size()))
        fail(line_, 1, in_quotes(path + token) + " cannot stand beside " + in_quotes(path + "0"));
      find_lists(child, path + token + "/");
    }
  }

  void take_shared() {
    const auto found = document->find(list_);
    if (found == document->end() || !found->is_object())
      throw InputError(name_, "the head has no object " + in_quotes(list_) + " with what all rows share");
    const std::uint32_t container = places.at({0, list_}).number;
    for (const auto& [path, value] : found->items()) {
      const LocatedJson::Place place = places.at({container, path});
      if (value.is_structured() && !value.empty())
        fail(place.line, place.column, in_quotes(path) + " must be one value");
      add_path(path, {std::nullopt, value, place}, place.line, place.column);
    }
    document->erase(list_);
  }

  void add_rows() {
    const ReadSoFar end = at_;
    take_shared();
    if (rest_.empty()) fail(line_, 1, "the line with the names of the columns is missing");
    if (rest_.back() != '\n')
      fail(line_ + static_cast<int>(std::count(rest_.begin(), rest_.end(), '\n')), 1,
           "the file ends within this line, which has no line break: it was cut off");
    const Line names = take_line(rest_, line_);
    std::vector<std::string_view> columns = split(names.text, '\t');
    if (names.text.empty() && rest_.empty()) columns.clear();  // an empty list
    for (std::size_t i = 0; i < columns.size(); ++i)
      add_path(columns[i], {i}, names.number, static_cast<int>(columns[i].data() - names.text.data()) + 1);
    find_lists(elements_, "");
    const std::size_t most = std::max(rest_.size(), kSmallTable);
    std::string key = list_;
    LocatingParser::key(key);
    start_array(json::size_type(-1));
    for (std::size_t count = 1; !rest_.empty(); ++count) {
      const Line line = take_line(rest_, line_);
      if (line.text.empty() && columns.size() > 1) fail(line.number, 1, "an empty line in the table");
      if (values_ * count > most) fail(line.number, 1, "the table has more values than characters");
      row_ = {line.number, split(line.text, '\t'), {}};
      if (row_.cells.size() != columns.size())
        fail(line.number, 1,
             "the line has " + std::to_string(row_.cells.size()) + " cells, and " +
                 std::to_string(columns.size()) + " columns are named");
      for (const std::string_view cell : row_.cells)
        row_.starts.push_back(static_cast<int>(cell.data() - line.text.data()) + 1);
      at_ = {line.number, 1};
      fill(elements_);
      emit(elements_, "");
    }
    end_array();
    at_ = end;
  }

  bool has_value(const Source& source) const { return !source.column || !row_.cells[*source.column].empty(); }

  // Notes which nodes the row fills, each once: a path may be long.
  bool fill(Node& node) const {
    node.has_value = node.source && has_value(*node.source);
    node.parts = 0;
    for (auto& [token, child] : node.children) node.parts += fill(child) ? 1 : 0;
    return node.filled();
  }

  ReadSoFar place_of(const Source& source) const {
    if (source.column) return {row_.line, row_.starts[*source.column]};
    return {source.place.line, source.place.column};
  }

  json value_of(const Source& source) const {
    if (!source.column) return source.shared;
    const std::string cell(row_.cells[*source.column]);
    const ReadSoFar place = place_of(source);
    if (!is_one_line(cell)) fail(place.line, place.column, "the cell is not UTF-8, or not one line of text");
    json value = json::parse(cell, nullptr, false);
    if (value.is_discarded()) {
      if (cell.front() == '"')
        fail(place.line, place.column, "the cell begins with a quote and is no JSON text");
      return cell;
    }
    if (value.is_structured() && !value.empty())
      fail(place.line, place.column, "the cell must be one value; parts of values have columns of their own");
    return value;
  }

  void emit(const Node& node, const std::string& path) {
    if (node.has_value) {
      at_ = place_of(*node.source);
      if (node.parts > 0) fail(at_.line, at_.column, in_quotes(path) + " has a value and parts");
      value(value_of(*node.source));
      return;
    }
    if (node.is_array) {
      start_array(json::size_type(-1));
      for (std::size_t i = 0; i < node.parts; ++i) {
        const std::string token = std::to_string(i);
        const Node& child = node.children.at(token);
        if (!child.filled())
          fail(row_.line, 1,
               in_quotes(path) + " lacks element " + token + " of " + std::to_string(node.parts));
        emit(child, path + "/" + token);
      }
      end_array();
      return;
    }
    start_object(json::size_type(-1));
    for (const auto& [token, child] : node.children) {
      if (!child.filled()) continue;
      std::string key = token;
      if (child.has_value) at_ = place_of(*child.source);
      at_.column += static_cast<int>(key.size()) + 1;  // key() takes the length of the key off
      LocatingParser::key(key);
      emit(child, path.empty() ? token : path + "/" + token);
    }
    LocatingParser::end_object();
  }

  ReadSoFar& at_;
  std::string list_;
  std::string_view rest_;
  int line_ = 1;
  Node elements_;
  std::size_t values_ = 0;
  Row row_;
};

}  // namespace

bool is_json_table(std::string_view text) {
  return text.substr(0, 1) == "#";
}

LocatedJson parse_json_table(std::string_view text, const std::string& name, const std::string& list) {
  std::string head;
  int line = 1;
  std::string_view rest = text;
  while (is_json_table(rest)) {
    head += " " + std::string(take_line(rest, line).text.substr(1)) + "\n";
  }
  ReadSoFar place;
  TableParser parser(name, place, list, rest, line);
  parse_json(head, place, parser);
  if (!parser.document->is_object()) throw InputError(name + ":1:1", "the head must be one JSON object");
  return LocatedJson(std::move(parser), name);
}

}  // namespace penumbra
