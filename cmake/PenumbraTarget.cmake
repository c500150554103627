include(PenumbraPrecompiled)
include(PenumbraUnity)

# Warnings are errors.
function(penumbra_warnings target)
  if(PENUMBRA_FUZZ)
    target_compile_options(${target} PRIVATE -w)  # GCC and clang-tidy judge the same sources
  elseif(MSVC)
    target_compile_options(${target} PRIVATE /W4 /WX /permissive-)
  else()
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                             -Wno-sign-conversion -Werror)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # GCC 12 reports overlapping copies inside std::string's operator+ that cannot happen (GCC bug 105651).
      target_compile_options(${target} PRIVATE -Wno-restrict)
      if(PENUMBRA_PRECOMPILED_HEADERS)
        # It also does not recognise a system header in a precompiled one, and warns about code inlined from it.
        target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
      endif()
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
      # Instrumented standard headers (std::regex among them) look uninitialised to GCC (GCC bug 105562).
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
  endif()
endfunction()

# penumbra_room(NAME SOURCES ... USES ... PUBLIC_LIBRARIES ... PRIVATE_LIBRARIES ... [LIGHTLY_OPTIMISED])
#
# Declares the static library penumbra_NAME (alias penumbra::NAME) of one folder in tools/ or one of its groups.
# USES lists the rooms it may include; tests/architecture checks them against the one-way order.
# LIGHTLY_OPTIMISED for code without influence on run time, such as options and output: it compiles faster.
set(penumbra_include_directories
    ${PROJECT_SOURCE_DIR}/tools ${PROJECT_SOURCE_DIR}/tools/base ${PROJECT_SOURCE_DIR}/tools/programs
    ${PROJECT_SOURCE_DIR}/tools/checking ${PROJECT_SOURCE_DIR}/tools/measurement)
function(penumbra_room name)
  cmake_parse_arguments(ROOM "LIGHTLY_OPTIMISED" "" "SOURCES;USES;PUBLIC_LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  add_library(penumbra_${name} STATIC ${ROOM_SOURCES})
  add_library(penumbra::${name} ALIAS penumbra_${name})
  penumbra_warnings(penumbra_${name})
  penumbra_precompiled(penumbra_${name})
  penumbra_unity(penumbra_${name})
  if(ROOM_LIGHTLY_OPTIMISED AND NOT MSVC)
    target_compile_options(penumbra_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  target_include_directories(penumbra_${name} PUBLIC
    "$<BUILD_INTERFACE:${penumbra_include_directories}>"
    $<INSTALL_INTERFACE:include/penumbra>)
  foreach(used IN LISTS ROOM_USES)
    target_link_libraries(penumbra_${name} PUBLIC penumbra::${used})
  endforeach()
  target_link_libraries(penumbra_${name} PUBLIC ${ROOM_PUBLIC_LIBRARIES} PRIVATE ${ROOM_PRIVATE_LIBRARIES})
endfunction()

# mimalloc instead of the C library's allocator, if available: compilers make very many small allocations. Sanitizers
# have their own. On Windows the C library's is used.
function(penumbra_allocator target)
  if(WIN32 OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
    return()
  endif()
  find_package(mimalloc 2.0 QUIET)
  if(NOT mimalloc_FOUND)
    return()
  endif()
  if(NOT APPLE)
    target_link_options(${target} PRIVATE LINKER:--no-as-needed)  # no symbol of it is referenced directly
  endif()
  target_link_libraries(${target} PRIVATE mimalloc)
endfunction()

# penumbra_sanitized_test(SOURCES ... LIBRARIES ...): cases of the one program, and the one test, that runs the readers'
# unit tests under the sanitizers. Linking a program for each room and starting one for each case takes longer.
function(penumbra_sanitized_test)
  cmake_parse_arguments(TEST "" "" "SOURCES;LIBRARIES" ${ARGN})
  set(name penumbra_reader_tests)
  if(NOT TARGET ${name})
    add_executable(${name})
    penumbra_warnings(${name})
    penumbra_precompiled_tests(${name})
    target_link_libraries(${name} PRIVATE GTest::gtest GTest::gmock GTest::gtest_main)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(${name} PRIVATE PENUMBRA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    penumbra_unoptimised_tests(${name})
    add_test(NAME sanitize.${name} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(sanitize.${name} PROPERTIES LABELS sanitize COST 100)
  endif()
  target_sources(${name} PRIVATE ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE ${TEST_LIBRARIES})
endfunction()

# penumbra_test(NAME SOURCES ... LIBRARIES ... [LABELS ...] [COST n] [DEVICE] [OPTIMISED] [SEPARATE])
#
# One GoogleTest program, whose suites are CTest's tests (PenumbraSuites.cmake). DEVICE where cases run on the software
# device, OPTIMISED where the tests' own loops would take longer without, SEPARATE where sources have names in common
# (PenumbraUnity.cmake). Tests of a higher COST start first. There is no time limit but CTest's own of 25 minutes, which
# only a hang reaches: the duration of a test is not tested. Drivers cache compiled shaders in the build tree, so that
# tests share them.
function(penumbra_test name)
  cmake_parse_arguments(TEST "DEVICE;OPTIMISED;SEPARATE" "COST" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if(PENUMBRA_FUZZ)
    penumbra_sanitized_test(SOURCES ${TEST_SOURCES} LIBRARIES ${TEST_LIBRARIES})
    return()
  endif()
  if(NOT TEST_COST)
    set(TEST_COST 0)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  penumbra_warnings(${name})
  if(TEST_OPTIMISED)
    penumbra_precompiled(${name})
  else()
    penumbra_unoptimised_tests(${name})
    penumbra_precompiled_tests(${name})
  endif()
  if(NOT TEST_SEPARATE)
    penumbra_unity(${name})
  endif()
  target_link_libraries(${name} PRIVATE ${TEST_LIBRARIES} GTest::gtest GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE PENUMBRA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  set(properties COST ${TEST_COST} ENVIRONMENT MESA_SHADER_CACHE_DIR=${PROJECT_BINARY_DIR}/mesa-shader-cache)
  if(TEST_LABELS)
    list(APPEND properties LABELS "${TEST_LABELS}")
  endif()
  # Most of a test on the software device is its compiler's time, which vectors of 4 lanes in place of 8 shorten by a
  # third, since code is written out for each lane. Its images of megabytes are allocated and freed in each run, too.
  if(TEST_DEVICE)
    penumbra_allocator(${name})
    list(APPEND properties ENVIRONMENT_MODIFICATION LP_NATIVE_VECTOR_WIDTH=set:128)
  endif()
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
  file(GENERATE OUTPUT ${script} CONTENT
    "include([[${PROJECT_SOURCE_DIR}/cmake/PenumbraSuites.cmake]])
penumbra_add_suites(${name} [[$<TARGET_FILE:${name}>]] ${properties})
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${script})
endfunction()
