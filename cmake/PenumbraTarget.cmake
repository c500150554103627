# penumbra_room(NAME SOURCES ... USES ... PUBLIC_LIBRARIES ... PRIVATE_LIBRARIES ...)
#
# Declares the static library penumbra_NAME (alias penumbra::NAME) of one folder under tools/.
# USES lists the rooms it may include; tests/architecture checks them against the one-way order.
function(penumbra_warnings target)
  if(MSVC)
    target_compile_options(${target} PRIVATE /W4 /WX /permissive-)
  else()
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                             -Wno-sign-conversion -Werror)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # GCC 12 reports overlapping copies inside std::string's operator+ that cannot happen (GCC bug 105651).
      target_compile_options(${target} PRIVATE -Wno-restrict)
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
      # Instrumented standard headers (std::regex among them) look uninitialised to GCC (GCC bug 105562).
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
  endif()
endfunction()

function(penumbra_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;USES;PUBLIC_LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  add_library(penumbra_${name} STATIC ${ROOM_SOURCES})
  add_library(penumbra::${name} ALIAS penumbra_${name})
  penumbra_warnings(penumbra_${name})
  target_include_directories(penumbra_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/tools>
    $<INSTALL_INTERFACE:include/penumbra>)
  foreach(used IN LISTS ROOM_USES)
    target_link_libraries(penumbra_${name} PUBLIC penumbra::${used})
  endforeach()
  target_link_libraries(penumbra_${name} PUBLIC ${ROOM_PUBLIC_LIBRARIES} PRIVATE ${ROOM_PRIVATE_LIBRARIES})
endfunction()

# mimalloc in place of the C library's allocator, where it is at hand: compilers ask for small pieces of memory
# without end. The sanitizers bring their own. On Windows the C library's stays.
function(penumbra_allocator target)
  if(WIN32 OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
    return()
  endif()
  find_package(mimalloc 2.0 QUIET)
  if(NOT mimalloc_FOUND)
    return()
  endif()
  if(NOT APPLE)
    target_link_options(${target} PRIVATE LINKER:--no-as-needed)  # it is used by no name of its own
  endif()
  target_link_libraries(${target} PRIVATE mimalloc)
endfunction()

# penumbra_test(NAME SOURCES ... LIBRARIES ... [LABELS ...] [TIMEOUT s] [WHOLE])
#
# One GoogleTest program whose cases CTest lists one by one; with WHOLE as one test, for suites whose cases share
# a device and pipelines that take longer to make than to use.
function(penumbra_test name)
  cmake_parse_arguments(TEST "WHOLE" "TIMEOUT" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 120)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  penumbra_warnings(${name})
  target_link_libraries(${name} PRIVATE ${TEST_LIBRARIES} GTest::gtest GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE PENUMBRA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(TEST_WHOLE)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES TIMEOUT ${TEST_TIMEOUT} LABELS "${TEST_LABELS}")
    return()
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST
    PROPERTIES TIMEOUT ${TEST_TIMEOUT} LABELS "${TEST_LABELS}")
endfunction()
