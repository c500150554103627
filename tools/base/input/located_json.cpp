#include "input/located_json.h"

#include <algorithm>
#include <iterator>

#include "input/input_error.h"
#include "input/locating_parser.h"
#include "input/text_file.h"

namespace penumbra {
namespace {

using nlohmann::json;

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

}  // namespace

std::shared_ptr<json> empty_json() {
  return {new json, [](json* document) {
            release(*document);
            delete document;
          }};
}

bool LocatingParser::parse_error(std::size_t, const std::string& token, const json::exception& error) {
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

void parse_json(std::string_view text, ReadSoFar& place, LocatingParser& parser) {
  json::sax_parse(CountingIterator(text.data(), &place), CountingIterator(text.data() + text.size(), &place),
                  &parser);
}

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
  parse_json(text, place, parser);
  return LocatedJson(std::move(parser), name);
}

LocatedJson::LocatedJson(LocatingParser&& parser, const std::string& name)
    : value_(std::move(parser.document)),
      name_(name),
      root_(parser.root),
      places_(std::move(parser.places)) {}

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

std::uint32_t LocatedJson::order(const Pointer& pointer) const {
  const std::optional<Place> place = place_of(pointer);
  return place ? place->number : 0;
}

}  // namespace penumbra
