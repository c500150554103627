#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "input/input_error.h"
#include "input/json_table.h"
#include "input/located_json.h"
#include "input/text_file.h"
#include "parameters/settings_input.h"
#include "study/record_fields.h"

namespace penumbra::study {
namespace {

using Pointer = LocatedJson::Pointer;

// The archive (record_fields.h) that reads one object: what is not optional must be there.
class RecordReader {
 public:
  static constexpr bool reads = true;

  RecordReader(const LocatedJson& document, const Pointer& at)
      : document_(document), at_(at), object_(document, at) {}

  bool present(const std::string& key, bool /*is_given*/) { return object_.has(key); }
  void require(bool holds, const std::string& key, const std::string& problem) const {
    if (!holds) object_.fail(key, problem);
  }

  void text(const std::string& key, std::string& value) {
    find(key);
    value = object_.text(key, {});
  }
  void texts(const std::string& key, std::vector<std::string>& values) {
    find(key);
    values = object_.texts(key);
  }
  void constant(const std::string& key, std::string_view value, const char* reason) {
    std::string found;
    text(key, found);
    if (found != value) object_.fail(key, fmt::format("must be \"{}\", {}", value, reason));
  }
  void boolean(const std::string& key, bool& value) {
    find(key);
    value = object_.boolean(key, false);
  }
  void either(const std::string& key, bool& value, const char* yes, const char* no) {
    std::string found;
    text(key, found);
    if (found != yes && found != no) object_.fail(key, fmt::format("it is either '{}' or '{}'", yes, no));
    value = found == yes;
  }
  template <typename Integer>
  void count(const std::string& key, Integer& value) {
    find(key);
    const int found = object_.integer(key, 0);
    if (found < 0) object_.fail(key, fmt::format("'{}' must not be negative, found {}", key, found));
    value = static_cast<Integer>(found);
  }
  void number(const std::string& key, double& value, double least, double most) {
    find(key);
    value = object_.number(key, 0.0);
    if (value < least || value > most)
      object_.fail(key, fmt::format("'{}' must be between {} and {}, found {}", key, least, most, value));
  }
  void numbers(const std::string& key, std::vector<double>& values, std::size_t count) {
    find(key);
    values = object_.numbers(key, count);
  }
  void number_lists(const std::string& key, std::map<std::string, std::vector<double>>& lists) {
    find(key);
    JsonObject found(document_, at_ / key);
    for (const std::string& name : found.keys()) {
      const nlohmann::json& list = document_.at(at_ / key / name);
      lists[name] = found.numbers(name, list.is_array() ? list.size() : 1);
    }
  }
  void vector(const std::string& key, glm::dvec3& value) {
    std::vector<double> found;
    numbers(key, found, 3);
    value = {found[0], found[1], found[2]};
  }
  void soft_quality(const std::string& key, parameters::SoftQuality& value) {
    find(key);
    value = parameters::read_soft_quality(object_, key, {});
  }
  void light_fit(const std::string& key, parameters::LightFit& value) {
    std::string name;
    text(key, name);
    const std::optional<parameters::LightFit> fit = parameters::light_fit_named(name);
    if (!fit) object_.fail(key, "there is no fit '" + name + "'");
    value = *fit;
  }
  void figure(const std::string& key, std::optional<double>& value, double least, double most) {
    if (!is_null(key)) number(key, value.emplace(), least, most);
  }
  void nullable(const std::string& key, std::optional<std::string>& value) {
    if (!is_null(key)) text(key, value.emplace());
  }
  void optional(const std::string& key, std::optional<std::string>& value) {
    if (object_.has(key)) text(key, value.emplace());
  }
  void optional(const std::string& key, std::optional<double>& value, double least, double most) {
    if (object_.has(key)) number(key, value.emplace(), least, most);
  }

  template <typename Value, typename... With>
  void object(const std::string& key, Value& value, const With&... with) {
    find(key);
    read(at_ / key, value, with...);
  }
  template <typename Value, typename... With>
  void nullable(const std::string& key, std::optional<Value>& value, const With&... with) {
    if (!is_null(key)) object(key, value.emplace(), with...);
  }
  template <typename Value>
  void optional(const std::string& key, std::optional<Value>& value) {
    if (object_.has(key)) object(key, value.emplace());
  }
  template <typename Value, typename... With>
  void list(const std::string& key, std::vector<Value>& values, const With&... with) {
    find(key);
    const nlohmann::json& array = document_.at(at_ / key);
    if (!array.is_array()) object_.fail(key, "'" + key + "' must be an array");
    for (std::size_t i = 0; i < array.size(); ++i) read(at_ / key / i, values.emplace_back(), with...);
  }

  void finish() const { object_.finish(); }
  [[noreturn]] void fail(const std::string& key, const std::string& problem,
                         const std::string& remedy = {}) const {
    object_.fail(key, problem, remedy);
  }

 private:
  void find(const std::string& key) {
    if (!object_.has(key)) object_.fail(key, "the key '" + key + "' is missing");
  }

  bool is_null(const std::string& key) {
    find(key);
    return document_.at(at_ / key).is_null();
  }

  template <typename Value, typename... With>
  void read(const Pointer& at, Value& value, const With&... with) const {
    RecordReader reader(document_, at);
    fields(reader, value, with...);
    reader.finish();
  }

  const LocatedJson& document_;
  Pointer at_;
  JsonObject object_;
};

std::string identity(const Record& record) {
  return fmt::format("{} × {} × {}° × {} {} × {} cascades", record.scene, record.technique,
                     record.light_degrees, record.map_size, record.map_format, record.cascades);
}

bool is_of(const MeasuredFrame& frame, const std::string& scene, double light_degrees) {
  return frame.scene == scene && frame.light_degrees == light_degrees;
}

void check_frames(const LocatedJson& document, const std::vector<MeasuredFrame>& frames) {
  for (auto frame = frames.begin(); frame != frames.end(); ++frame)
    if (std::any_of(frames.begin(), frame, [&](const MeasuredFrame& other) {
          return is_of(other, frame->scene, frame->light_degrees);
        }))
      throw InputError(document.where(Pointer("/frames") / static_cast<std::size_t>(frame - frames.begin())),
                       fmt::format("a second frame of {} × {}°", frame->scene, frame->light_degrees),
                       "remove one of them");
}

void check_records(const LocatedJson& document, const Results& results) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < results.records.size(); ++i) {
    const Record& record = results.records[i];
    const std::string where = document.where(Pointer("/records") / i);
    if (const std::string id = identity(record); !seen.insert(id).second)
      throw InputError(where, "a second record of " + id, "remove one of them");
    if (std::none_of(results.frames.begin(), results.frames.end(), [&](const MeasuredFrame& frame) {
          return is_of(frame, record.scene, record.light_degrees);
        }))
      throw InputError(where, fmt::format("'frames' has no entry of the record's {} × {}°", record.scene,
                                          record.light_degrees));
  }
}

Results read_document(const LocatedJson& document) {
  RecordReader top(document, Pointer());
  int version = 0;
  top.count("schema_version", version);
  if (version != kResultsSchemaVersion) {
    top.fail(
        "schema_version",
        fmt::format("schema version {} is not the {} this program reads", version, kResultsSchemaVersion),
        "write the file again with this version's 'penumbra measure'");
  }
  Results results;
  fields(top, results);
  top.finish();
  check_frames(document, results.frames);
  check_records(document, results);
  return results;
}

}  // namespace

Results parse_results(std::string_view text, const std::string& name) {
  return read_document(is_json_table(text) ? parse_json_table(text, name, "records")
                                           : LocatedJson::parse(text, name));
}

Results read_results(const std::filesystem::path& file) {
  return parse_results(read_text_file(file), file.string());
}

}  // namespace penumbra::study
