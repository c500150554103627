// Writers of reports without memory write the whole report or throw std::bad_alloc.
#include "faults/every_fault.h"
#include "reference/scratch_folder.h"
#include "validation/report_fixture.h"
#include "validation/report_merge.h"

namespace penumbra::faults {
namespace {

using namespace validation;

ValidationReport report() {
  ValidationReport made;
  made.records = {water({}),
                  failed(water({"_FOAM"}), error_at("Assets/Water.shader", 3, 5, "unknown identifier 'x'"))};
  made.records[1].place = 1;
  made.checks = {{"spirv", "SPIRV-Tools"}};
  made.minimal = {{made.records[1].diagnostics[0], {"_FOAM"}}};
  made.fingerprint = "f";
  made.unique = 1;
  return made;
}

// The forms made of JSON are not tested: the destructor of nlohmann's documents needs memory. penumbra
// answers that with its exit code (answer_uncaught_exceptions() in cli/command_line.h).
TEST(ReportFaults, AReportIsWholeOrNotWritten) {
  const ValidationReport made = report();
  for (const ReportForm form : {ReportForm::text, ReportForm::junit, ReportForm::github}) {
    SCOPED_TRACE(form_name(form));
    const std::string whole = format_report(made, form);
    std::string written;
    for (const Extent extent : {Extent::once, Extent::from_there})
      with_every_fault(Kind::memory, extent,
                       {[&] { written.clear(); }, [&] { written = format_report(made, form); },
                        [&](End end, bool) { EXPECT_EQ(written, end == End::done ? whole : ""); }});
  }
}

TEST(ReportFaults, AReportIsReadWholeOrRefused) {
  const reference::ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "report.json";
  const std::string whole = report_json(report());
  std::ofstream(file) << whole;
  std::optional<ValidationReport> read;
  for (const Extent extent : {Extent::once, Extent::from_there})
    with_every_fault(Kind::broken, extent,
                     {[&] { read.reset(); },
                      [&] {
                        read = merge_reports({{"a", read_report_json(file)}});
                      },
                      [&](End end, bool) {
                        EXPECT_EQ(read.has_value(), end == End::done);
                        EXPECT_TRUE(!read || report_json(*read) == whole);
                      }});
}

}  // namespace
}  // namespace penumbra::faults
