#include "scene/reading_process.h"

#include <stdexcept>

#include "input/input_error.h"
#include "platform/byte_stream.h"
#include "platform/worker_answer.h"
#include "scene/image_file.h"
#include "scene/scene.h"
#include "scene/scene_message.h"

namespace penumbra::scene {
namespace {

constexpr char kModel = 'm';
constexpr char kPicture = 'p';
constexpr char kHeights = 'h';

std::string read_as_told(const std::string& message, platform::WorkerLink&) {
  return platform::answer_or_input_error([&] {
    platform::ByteReader in(message);
    const std::string what = in.text();
    const std::filesystem::path file = in.text();
    if (what == std::string(1, kPicture)) return encode(read_image(file));
    if (what == std::string(1, kHeights)) {
      const int told = in.value<int>(), width = in.value<int>(), height = in.value<int>();
      return encode(
          read_height_image(file, told == 0 ? std::nullopt : std::optional(ImageSize{width, height})));
    }
    return encode(import(file, read_import_options(in)));
  });
}

[[noreturn]] void throw_failure(const std::filesystem::path& file, const platform::WorkerOutcome& outcome) {
  std::string problem = "cannot be read: the importer " + outcome.failure;
  if (!outcome.output_tail.empty()) problem += "; it said: " + outcome.output_tail;
  const bool limited = outcome.failure.starts_with("took ");
  throw InputError(
      file.string(), problem,
      limited ? "reduce it, or raise --time-limit and --memory-limit if it is meant to be that large"
              : "the file is damaged, or the importer does not cope with it: export it again, as glTF "
                "for example");
}

std::string answer_of(const ReadingProcess& process, const std::filesystem::path& file, std::string message) {
  platform::WorkerOutcome outcome =
      platform::ask_worker({process.arguments, 1, process.limits}, std::move(message));
  if (!outcome.failure.empty()) throw_failure(file, outcome);
  return platform::taken_answer(std::move(outcome.answer));
}

platform::ByteWriter message_about(char what, const std::filesystem::path& file) {
  platform::ByteWriter out;
  out.text({&what, 1});
  out.text(file.string());
  return out;
}

template <typename Decode>
auto decoded(const std::filesystem::path& file, const Decode& decode) {
  try {
    return decode();
  } catch (const std::invalid_argument& error) {
    throw InputError(file.string(), std::string("cannot be read: the importer gave ") + error.what());
  }
}

}  // namespace

Scene import_apart(const std::filesystem::path& file, const ImportOptions& options) {
  if (options.process.arguments.empty()) return import(file, options);
  platform::ByteWriter out = message_about(kModel, file);
  write(out, options);
  const std::string answer = answer_of(options.process, file, out.take());
  return decoded(file, [&] { return decode_scene(answer); });
}

Texture read_image_apart(const std::filesystem::path& file, const ReadingProcess& process) {
  if (process.arguments.empty()) return read_image(file);
  const std::string answer = answer_of(process, file, message_about(kPicture, file).take());
  return decoded(file, [&] { return decode_texture(answer); });
}

HeightImage read_height_image_apart(const std::filesystem::path& file, std::optional<ImageSize> raw_size,
                                    const ReadingProcess& process) {
  if (process.arguments.empty()) return read_height_image(file, raw_size);
  platform::ByteWriter out = message_about(kHeights, file);
  out.value(raw_size ? 1 : 0);
  out.value(raw_size ? raw_size->width : 0);
  out.value(raw_size ? raw_size->height : 0);
  const std::string answer = answer_of(process, file, out.take());
  return decoded(file, [&] { return decode_heights(answer); });
}

int serve_readings() {
  return platform::serve_worker(read_as_told);
}

}  // namespace penumbra::scene
