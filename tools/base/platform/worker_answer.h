// A worker's answer as bytes: what its work gave, or the InputError that it threw.
#pragma once

#include <functional>
#include <string>

namespace penumbra::platform {

// The worker's side. Every exception but InputError passes through.
std::string answer_or_input_error(const std::function<std::string()>& work);

// The other side: the answer. Throws the InputError, and std::invalid_argument for what is neither.
std::string taken_answer(std::string bytes);

}  // namespace penumbra::platform
