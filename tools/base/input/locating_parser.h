// The parser behind LocatedJson, also for other formats that become JSON values. Internal to this folder.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/input_error.h"
#include "input/located_json.h"

namespace penumbra {

// The position that the parser has reached, shared by every copy of the iterator it reads through.
struct ReadSoFar {
  int line = 1;
  int column = 0;

  std::string after(const std::string& name) const {
    return name + ":" + std::to_string(line) + ":" + std::to_string(std::max(column, 1));
  }
};

std::shared_ptr<nlohmann::json> empty_json();  // which is destroyed without allocating

// Builds the document and notes, for every value, where it (or its key) ends.
class LocatingParser : public nlohmann::json::json_sax_t {
 public:
  LocatingParser(const std::string& name, const ReadSoFar& place) : name_(name), place_(place) {}

  std::shared_ptr<nlohmann::json> document = empty_json();
  LocatedJson::Place root;
  LocatedJson::Places places;

  bool null() override { return value(nullptr); }
  bool boolean(bool v) override { return value(v); }
  bool number_integer(number_integer_t v) override { return value(v); }
  bool number_unsigned(number_unsigned_t v) override { return value(v); }
  bool number_float(number_float_t v, const string_t&) override { return value(v); }
  bool string(string_t& v) override { return value(v); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(nlohmann::json::object()); }
  bool start_array(std::size_t) override { return open(nlohmann::json::array()); }
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

  bool parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& error) override;

 protected:
  bool value(nlohmann::json v) {
    insert(std::move(v));
    return true;
  }

  bool open(nlohmann::json empty) {
    nlohmann::json* stored = insert(std::move(empty));
    levels_.push_back({stored, last_number_});
    if (levels_.size() > 200) throw InputError(place_.after(name_), "nested deeper than 200 levels");
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  nlohmann::json* insert(nlohmann::json v) {
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
    nlohmann::json* container = nullptr;
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

// Feeds the text to the parser, and its place to `place`, which is the parser's own.
void parse_json(std::string_view text, ReadSoFar& place, LocatingParser& parser);

}  // namespace penumbra
