#include "faults/every_fault.h"

#include "input/input_error.h"

namespace penumbra::faults {
namespace {

constexpr std::size_t most = 20'000;  // calls of one work; more is a loop

std::string name_of(Kind kind, Extent extent, std::size_t number) {
  const char* const kinds[] = {"out of memory", "a full disk", "a broken disk"};
  return std::string(kinds[static_cast<int>(kind)]) + (extent == Extent::once ? " at call " : " from call ") +
         std::to_string(number);
}

End end_of(const std::function<void()>& work, std::string& message) {
  try {
    work();
    return End::done;
  } catch (const std::bad_alloc&) {
    return End::out_of_memory;
  } catch (const InputError& error) {
    const NoFault shelter;
    message = error.what();
    return End::refused;
  }
}

}  // namespace

std::size_t with_every_fault(Kind kind, Extent extent, const Trial& trial) {
  for (std::size_t number = 0; number < most; ++number) {
    SCOPED_TRACE(name_of(kind, extent, number));
    trial.prepare();
    const std::size_t files_before = open_files();
    bool failed = false;
    std::string message;
    End end = End::done;
    {
      const InjectedFault fault(kind, extent, number);
      end = end_of(trial.work, message);
      failed = fault.happened();
    }
    EXPECT_EQ(open_files(), files_before);
    EXPECT_TRUE(end != End::out_of_memory || kind == Kind::memory);
    EXPECT_TRUE(end != End::refused || !message.empty());
    trial.check(end, failed);
    if (!failed) {
      EXPECT_EQ(end, End::done) << message;
      EXPECT_GT(number, 0U) << "nothing was made to fail";
      return number;
    }
    if (testing::Test::HasFailure()) return number;
  }
  ADD_FAILURE() << "still failing after " << most << " calls";
  return most;
}

void with_every_fault(const Trial& trial) {
  for (const Extent extent : {Extent::once, Extent::from_there})
    for (const Kind kind : {Kind::memory, Kind::full, Kind::broken}) with_every_fault(kind, extent, trial);
}

std::optional<std::string> content_of(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
}

std::size_t files_in(const std::filesystem::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    count += entry.is_regular_file() ? 1 : 0;
  return count;
}

}  // namespace penumbra::faults
