// A worker's serialised response: the result of its work, or the InputError that it threw.
#pragma once

#include <functional>
#include <string>

namespace penumbra::platform {

// Makes the response on the worker's side. Every exception but InputError passes through.
std::string answer_or_input_error(const std::function<std::string()>& work);

// Returns the result on the parent's side. Throws the InputError, and std::invalid_argument for a malformed
// response.
std::string taken_answer(std::string bytes);

}  // namespace penumbra::platform
