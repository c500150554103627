# Headers that are parsed once for many sources, with PENUMBRA_PRECOMPILED_HEADERS; the release preset sets it. The
# other presets build every source with its own includes alone, so that a missing include is found there.
# With ccache, set CCACHE_SLOPPINESS=pch_defines,time_macros, or nothing is cached.
#
# penumbra_precompiled(TARGET)        the standard library, one file for all rooms
# penumbra_precompiled_tests(TARGET)  GoogleTest besides, one file for all test programs
option(PENUMBRA_PRECOMPILED_HEADERS "Parse the standard library's headers once, not once for each source" OFF)

set(penumbra_standard_headers
  <algorithm> <array> <chrono> <cmath> <cstddef> <cstdint> <filesystem> <functional> <iterator> <map> <memory>
  <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <tuple> <unordered_map> <utility> <vector>)

# Tests' own sources compile twice as fast without optimisation; what they test is optimised.
function(penumbra_unoptimised_tests target)
  if(NOT MSVC)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
  endif()
endfunction()

# The target that owns the precompiled header that others use.
function(penumbra_precompiled_owner owner)
  set(source ${PROJECT_BINARY_DIR}/${owner}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// CMake precompiles headers for targets with a source only.\n")
  add_library(${owner} OBJECT ${source})
  penumbra_warnings(${owner})
  target_precompile_headers(${owner} PRIVATE ${penumbra_standard_headers} ${ARGN})
endfunction()

function(penumbra_precompiled target)
  if(NOT PENUMBRA_PRECOMPILED_HEADERS)
    return()
  endif()
  if(NOT TARGET penumbra_precompiled_standard)
    penumbra_precompiled_owner(penumbra_precompiled_standard)
  endif()
  target_precompile_headers(${target} REUSE_FROM penumbra_precompiled_standard)
endfunction()

function(penumbra_precompiled_tests target)
  if(NOT PENUMBRA_PRECOMPILED_HEADERS)
    return()
  endif()
  if(NOT TARGET penumbra_precompiled_googletest)
    penumbra_precompiled_owner(penumbra_precompiled_googletest <gmock/gmock.h> <gtest/gtest.h>)
    target_link_libraries(penumbra_precompiled_googletest PRIVATE GTest::gtest GTest::gmock)
    penumbra_unoptimised_tests(penumbra_precompiled_googletest)
  endif()
  target_precompile_headers(${target} REUSE_FROM penumbra_precompiled_googletest)
endfunction()
