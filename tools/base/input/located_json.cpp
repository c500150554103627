#include "input/located_json.h"

#include <algorithm>
#include <iterator>

#include "input/input_error.h"
#include "input/text_file.h"

namespace penumbra {
namespace {

using nlohmann::json;

// The position that the parser has reached, shared by every copy of the iterator it reads through.
struct ReadSoFar {
  int line = 1;
  int column = 0;

  std::string after(const std::string& name) const {
    return name + ":" + std::to_string(line) + ":" + std::to_string(std::max(column, 1));
  }
};

class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, ReadSoFar* place) : at_(at), place_(place) {}

  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (*at_ == '\n') {
      ++place_->line;
      place_->column = 0;
    } else {
      ++place_->column;
    }
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  ReadSoFar* place_;
};

// The document does not own memory: the library's destructor allocates, and ends the program if that fails.
void release(json& value) noexcept {
  for (json& element : value) {
    if (element.is_structured()) release(element);
  }
  if (value.is_structured()) value.clear();
}

std::shared_ptr<json> empty_document() {
  return {new json, [](json* document) {
            release(*document);
            delete document;
          }};
}

// Builds the document and notes, for every value, where it (or its key) ends.
class LocatingParser : public json::json_sax_t {
 public:
  LocatingParser(const std::string& name, const ReadSoFar& place) : name_(name), place_(place) {}

  std::shared_ptr<json> document = empty_document();
  LocatedJson::Place root;
  LocatedJson::Places places;

  bool null() override { return value(nullptr); }
  bool boolean(bool v) override { return value(v); }
  bool number_integer(number_integer_t v) override { return value(v); }
  bool number_unsigned(number_unsigned_t v) override { return value(v); }
  bool number_float(number_float_t v, const string_t&) override { return value(v); }
  bool string(string_t& v) override { return value(v); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(json::object()); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    key_ = name;
    key_place_ = {place_.line, std::max(1, place_.column - static_cast<int>(name.size()) - 1)};
    if (levels_.back().container->contains(name)) {
      throw InputError(
          name_ + ":" + std::to_string(key_place_.line) + ":" + std::to_string(key_place_.column),
          "the key '" + name + "' appears twice in one object", "remove one of them");
    }
    return true;
  }

  bool parse_error(std::size_t, const std::string& token, const json::exception& error) override {
    std::string reason = error.what();
    if (const std::size_t tag = reason.find("] "); reason.starts_with("[json.") && tag != std::string::npos)
      reason = reason.substr(tag + 2);
    const std::size_t colon = reason.find(": ");
    if (colon != std::string::npos) reason = reason.substr(colon + 2);
    const std::size_t detail = reason.find(" - ");
    if (detail != std::string::npos) reason = reason.substr(detail + 3);
    const std::size_t last_read = reason.find("; last read");
    if (last_read != std::string::npos) reason = reason.substr(0, last_read);
    std::string shown = token.size() > 40 ? token.substr(token.size() - 40) : token;
    for (char& c : shown) {
      if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    throw InputError(place_.after(name_),
                     "not valid JSON: " + reason + (shown.empty() ? "" : " at '" + shown + "'"));
  }

 private:
  bool value(json v) {
    insert(std::move(v));
    return true;
  }

  bool open(json empty) {
    json* stored = insert(std::move(empty));
    levels_.push_back({stored, last_number_});
    if (levels_.size() > 200) throw InputError(place_.after(name_), "nested deeper than 200 levels");
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  json* insert(json v) {
    const Location here{place_.line, std::max(1, place_.column)};
    if (levels_.empty()) {
      *document = std::move(v);
      root = {here.line, here.column, 0};
      return document.get();
    }
    const Level level = levels_.back();
    if (level.container->is_object()) {
      note(level, key_, key_place_);
      return &((*level.container)[key_] = std::move(v));
    }
    note(level, std::to_string(level.container->size()), here);
    level.container->push_back(std::move(v));
    return &level.container->back();
  }

  struct Location {
    int line = 1;
    int column = 1;
  };
  struct Level {
    json* container = nullptr;
    std::uint32_t number = 0;
  };

  void note(const Level& level, const std::string& token, const Location& place) {
    places[{level.number, token}] = {place.line, place.column, ++last_number_};
  }

  std::string name_;
  const ReadSoFar& place_;
  std::vector<Level> levels_;
  std::uint32_t last_number_ = 0;
  std::string key_;
  Location key_place_;
};

}  // namespace

LocatedJson LocatedJson::read(const std::filesystem::path& file) {
  return parse(read_text_file(file), file.string());
}

LocatedJson LocatedJson::read_found(const std::filesystem::path& file) {
  return parse(read_found_text_file(file), file.string());
}

LocatedJson LocatedJson::parse(std::string_view text, const std::string& name) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError(name, "is empty", "the smallest valid content is {}");
  }
  ReadSoFar place;
  LocatingParser parser(name, place);
  json::sax_parse(CountingIterator(text.data(), &place), CountingIterator(text.data() + text.size(), &place),
                  &parser);
  LocatedJson result;
  result.value_ = std::move(parser.document);
  result.name_ = name;
  result.root_ = parser.root;
  result.places_ = std::move(parser.places);
  return result;
}

std::optional<LocatedJson::Place> LocatedJson::place_of(const Pointer& pointer) const {
  if (pointer.empty()) return root_;
  const std::optional<Place> container = place_of(pointer.parent_pointer());
  if (!container) return std::nullopt;
  const auto found = places_.find({container->number, pointer.back()});
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

std::string LocatedJson::where(const Pointer& pointer) const {
  const std::optional<Place> place = place_of(pointer);
  return place ? name_ + ":" + std::to_string(place->line) + ":" + std::to_string(place->column) : name_;
}

}  // namespace penumbra
