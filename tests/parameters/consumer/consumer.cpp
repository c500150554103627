// This is a program of someone else's, built against the installed package.
#include <input/input_error.h>
#include <parameters/cascades.h>
#include <parameters/disk.h>

#include <cstdio>

int main() {
  const auto set = penumbra::parameters::fit_cascades({}, {}, {.cascades = 4});
  std::printf("%zu cascades, depth to radial %g, %zu taps\n", set.cascades.size(),
              set.cascades[0].depth_to_radial, penumbra::parameters::poisson_disk(64).size());
  try {
    penumbra::parameters::fit_cascades({}, {}, {.cascades = 5});
  } catch (const penumbra::InputError& error) {
    std::printf("%s\n", error.what());
    return 0;
  }
  return 1;
}
