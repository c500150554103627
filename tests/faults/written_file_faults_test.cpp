// Files that reports and figures are written to when memory or the disk fails.
#include "faults/every_fault.h"
#include "platform/atomic_file.h"
#include "reference/scratch_folder.h"

namespace penumbra::faults {
namespace {

namespace fs = std::filesystem;

const std::string new_text(20'000, 'n');

TEST(WrittenFileFaults, TheOldFileStaysUntilTheNewOneIsWhole) {
  const reference::ScratchFolder scratch;
  const fs::path file = scratch.path() / "report.json";
  with_every_fault(
      {[&] { std::ofstream(file) << "old"; }, [&] { platform::write_file_atomically(file, new_text); },
       [&](End end, bool) { EXPECT_EQ(content_of(file), end == End::done ? new_text : "old"); }});
}

TEST(WrittenFileFaults, FilesThatBelongTogetherAreOldOrNewTogether) {
  const reference::ScratchFolder scratch;
  const fs::path first = scratch.path() / "picture.png";
  const fs::path second = scratch.path() / "names.json";
  for (const bool exist : {true, false})
    for (const Kind kind : {Kind::memory, Kind::full, Kind::broken})
      with_every_fault(kind, Extent::once,
                       {[&] {
                          for (const fs::path& file : {first, second}) {
                            fs::remove(file);
                            if (exist) std::ofstream(file) << "old";
                          }
                        },
                        [&] {
                          platform::write_files_atomically({{first, new_text}, {second, new_text}});
                        },
                        [&](End end, bool) {
                          const std::optional<std::string> old =
                              exist ? std::optional<std::string>("old") : std::nullopt;
                          for (const fs::path& file : {first, second})
                            EXPECT_EQ(content_of(file), end == End::done ? new_text : old);
                        }});
}

TEST(WrittenFileFaults, NoStepThatFailsGoesUnnoticed) {
  const reference::ScratchFolder scratch;
  const fs::path file = scratch.path() / "report.json";
  for (const Extent extent : {Extent::once, Extent::from_there})
    with_every_fault(Kind::full, extent,
                     {[] {}, [&] { platform::write_file_atomically(file, new_text); },
                      [&](End end, bool failed) { EXPECT_EQ(end, failed ? End::refused : End::done); }});
}

TEST(WrittenFileFaults, OneFaultLeavesNothingBehind) {
  const reference::ScratchFolder scratch;
  const fs::path file = scratch.path() / "report.json";
  for (const Kind kind : {Kind::memory, Kind::full, Kind::broken})
    with_every_fault(
        kind, Extent::once,
        {[&] { std::ofstream(file) << "old"; }, [&] { platform::write_file_atomically(file, new_text); },
         [&](End, bool) { EXPECT_EQ(files_in(scratch.path()), 1U); }});
}

TEST(WrittenFileFaults, TryingAPlaceLeavesNothingBehind) {
  const reference::ScratchFolder scratch;
  const fs::path file = scratch.path() / "report.json";
  for (const Kind kind : {Kind::memory, Kind::full, Kind::broken})
    with_every_fault(kind, Extent::once,
                     {[&] {  // where removing failed, one is left
                        for (const auto& left : fs::directory_iterator(scratch.path()))
                          fs::remove(left.path());
                      },
                      [&] { platform::check_file_can_be_written(file); },
                      [&](End, bool) { EXPECT_LE(files_in(scratch.path()), 1U); }});
}

TEST(WrittenFileFaults, AMessageNamesTheFileAndTheReason) {
  const reference::ScratchFolder scratch;
  const fs::path file = scratch.path() / "report.json";
  const InjectedFault fault(Kind::full, Extent::from_there, 0);
  try {
    platform::write_file_atomically(file, new_text);
    FAIL() << "nothing failed";
  } catch (const std::exception& error) {
    const NoFault shelter;
    const std::string message = error.what();
    EXPECT_NE(message.find("report.json: cannot be written: No space left on device"), std::string::npos)
        << message;
    EXPECT_NE(message.find("the file was not changed"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace penumbra::faults
