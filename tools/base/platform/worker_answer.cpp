#include "platform/worker_answer.h"

#include <stdexcept>

#include "input/input_error.h"

namespace penumbra::platform {
namespace {

constexpr char kAnswer = 'a';
constexpr char kInputError = 'i';
constexpr const char* kRemedy = "\n  ";  // separates the two texts of an InputError

}  // namespace

std::string answer_or_input_error(const std::function<std::string()>& work) {
  try {
    std::string answer = work();
    answer.push_back(kAnswer);  // the mark is at the end, so that a large answer is not moved
    return answer;
  } catch (const InputError& error) {
    return std::string(error.what()) + kInputError;
  }
}

std::string taken_answer(std::string bytes) {
  const char kind = bytes.empty() ? '\0' : bytes.back();
  if (!bytes.empty()) bytes.pop_back();
  if (kind == kAnswer) return bytes;
  const std::size_t remedy = bytes.find(kRemedy);
  if (kind != kInputError || bytes.empty() || remedy == 0)
    throw std::invalid_argument("a worker process sent a malformed response");
  if (remedy == std::string::npos) throw InputError("", bytes);
  throw InputError("", bytes.substr(0, remedy), bytes.substr(remedy + std::string_view(kRemedy).size()));
}

}  // namespace penumbra::platform
