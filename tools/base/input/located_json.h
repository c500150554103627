// JSON values with the line and column at which they were read, so that "unknown key" points at the key.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace penumbra {

class LocatingParser;  // locating_parser.h

class LocatedJson {
 public:
  using Pointer = nlohmann::json::json_pointer;

  // The place at which a value (in objects: its key) was read; `number` counts values in the order of the
  // text.
  struct Place {
    int line = 1;
    int column = 1;
    std::uint32_t number = 0;
  };
  // The key is the number of the container and the key or index in it, so that the size of an entry does not
  // depend on its depth.
  using Places = std::map<std::pair<std::uint32_t, std::string>, Place>;

  // Throws InputError for a file that is unreadable, longer than read_text_file() reads, empty, not JSON
  // (with line and column), has a duplicate key, or is nested deeper than 200 levels.
  static LocatedJson read(const std::filesystem::path& file);
  static LocatedJson read_found(const std::filesystem::path& file);  // reads as read_found_text_file()
  static LocatedJson parse(std::string_view text, const std::string& name);
  LocatedJson(LocatingParser&& parser, const std::string& name);  // what has been parsed, named `name`

  const nlohmann::json& value() const { return *value_; }
  const nlohmann::json& at(const Pointer& pointer) const { return value_->at(pointer); }
  std::string where(const Pointer& pointer) const;  // "name:line:column" of the value; in objects, of its key
  std::uint32_t order(const Pointer& pointer) const;  // the value's place in the order of the text

 private:
  std::optional<Place> place_of(const Pointer& pointer) const;

  std::shared_ptr<const nlohmann::json> value_;
  std::string name_;
  Place root_;
  Places places_;
};

std::string json_type(const nlohmann::json& value);  // for messages: "a number"

// An object of a LocatedJson, read field by field. Every accessor throws InputError at the value's location
// if the type is wrong; finish() throws for keys that were not read, suggesting the nearest one that was.
class JsonObject {
 public:
  explicit JsonObject(const LocatedJson& document, LocatedJson::Pointer at = LocatedJson::Pointer());

  bool has(const std::string& key);
  double number(const std::string& key, double fallback);
  int integer(const std::string& key, int fallback);
  bool boolean(const std::string& key, bool fallback);
  std::string text(const std::string& key, const std::string& fallback);
  std::vector<double> numbers(const std::string& key, std::size_t count);  // exactly `count` finite numbers
  std::vector<std::string> texts(const std::string& key);  // array of strings; empty if absent
  // An array of numbers from 0 to below `end`; empty if absent.
  std::vector<std::size_t> indices(const std::string& key, std::size_t end);
  JsonObject object(const std::string& key);                // an empty object if absent
  std::vector<JsonObject> objects(const std::string& key);  // array of objects; empty if absent
  std::vector<std::string> keys() const;                    // all keys, not in file order
  void finish() const;

  std::string where(const std::string& key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& problem,
                         const std::string& remedy = {}) const;

 private:
  const nlohmann::json* find(const std::string& key);

  const LocatedJson* document_;
  LocatedJson::Pointer at_;
  bool present_ = true;
  std::vector<std::string> asked_;
};

}  // namespace penumbra
