// The library is called in this process on Windows, because there are no confined workers.
#include <d3dcompiler.h>

#include "fxc/judge.h"
#include "fxc/worker/unity_types.h"
#include "input/input_error.h"
#include "platform/shared_library.h"

namespace penumbra::fxc {

namespace {

using Compile = decltype(&D3DCompile);

std::string take(ID3DBlob* blob) {
  if (blob == nullptr) return {};
  std::string bytes(static_cast<const char*>(blob->GetBufferPointer()), blob->GetBufferSize());
  blob->Release();
  return bytes;
}

}  // namespace

struct Judge::Process {
  Compile compile = nullptr;
};

Judge::Judge(const Installation& installation, const JudgeLimits&) : process_(std::make_unique<Process>()) {
  process_->compile = reinterpret_cast<Compile>(platform::function_of(installation.library, "D3DCompile"));
  if (process_->compile == nullptr)
    throw EnvironmentError("FXC does not start: '" + installation.library.string() + "' has no D3DCompile");
}

Judge::~Judge() = default;

Verdict Judge::compile(const Program& program) {
  const UINT level = program.optimise ? D3DCOMPILE_OPTIMIZATION_LEVEL3 : D3DCOMPILE_SKIP_OPTIMIZATION;
  ID3DBlob* bytecode = nullptr;
  ID3DBlob* messages = nullptr;
  Verdict verdict;
  verdict.compiled = SUCCEEDED(process_->compile(
      program.text.data(), program.text.size(), nullptr, types_of_unity, nullptr, program.entry.c_str(),
      program.profile.c_str(), level | D3DCOMPILE_ENABLE_BACKWARDS_COMPATIBILITY, 0, &bytecode, &messages));
  verdict.bytecode = take(bytecode);
  verdict.messages = take(messages);
  while (verdict.messages.ends_with('\0')) verdict.messages.pop_back();
  return verdict;
}

}  // namespace penumbra::fxc
