#include "cli/failure.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>

#include "input/input_error.h"
#include "platform/interrupt.h"

namespace penumbra::cli {
namespace {

constexpr const char* out_of_memory =
    "out of memory; use a smaller picture, map, scene or file, or fewer --jobs";

Failure mistake_of_ours(const std::string& what) {
  return {internal_error, "internal error: " + what +
                              "\n  this is a bug in penumbra " PENUMBRA_VERSION
                              ", not in your input; please report it with the command line"};
}

Failure described(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const platform::Interrupted&) {
    const int signal = platform::interrupting_signal();
    return {signal == 0 ? interrupted : static_cast<ExitCode>(128 + signal), platform::interrupted_message};
  } catch (const InputError& error) {
    return {bad_input, error.what()};
  } catch (const EnvironmentError& error) {
    return {bad_environment, error.what()};
  } catch (const std::filesystem::filesystem_error& error) {
    return {bad_input, error.what()};
  } catch (const std::bad_alloc&) {
    return {bad_environment, out_of_memory};
  } catch (const std::exception& error) {
    return mistake_of_ours(error.what());
  } catch (...) {
    return mistake_of_ours("of unknown kind");
  }
}

// The function allocates nothing.
[[noreturn]] void end_uncaught() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "penumbra: %s\n", out_of_memory);
    std::_Exit(bad_environment);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

void answer_uncaught_exceptions() {
  std::set_terminate(end_uncaught);
}

Failure failure_of(const std::exception_ptr& thrown) {
  try {
    return described(thrown);
  } catch (const std::bad_alloc&) {
    return {bad_environment, "out of memory"};  // short enough to need no memory
  }
}

}  // namespace penumbra::cli
