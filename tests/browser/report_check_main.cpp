// penumbra_report_check FILE: opens a report in headless Chromium. Exit 0 when nothing is wrong and it shows
// at least one picture and one chart, 1 with a list of what is wrong, 2 for bad usage or input, 3 without
// Chromium.
#include <cstdio>
#include <exception>

#include "browser/report_check.h"
#include "input/input_error.h"

namespace {

int check(const char* file) {
  const penumbra::browser::PageCheck page = penumbra::browser::check_page(file);
  for (const std::string& problem : page.problems) std::fprintf(stderr, "%s: %s\n", file, problem.c_str());
  std::printf("%s: %d pictures, %d charts, %d buttons, %zu problems\n", file, page.images, page.charts,
              page.buttons, page.problems.size());
  if (page.images == 0 || page.charts == 0) {
    std::fprintf(stderr, "%s: a report without pictures or charts\n", file);
    return 1;
  }
  return page.passed() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: penumbra_report_check FILE\n", stderr);
    return 2;
  }
  try {
    return check(argv[1]);
  } catch (const penumbra::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
