# penumbra_add_case_groups(NAME PROGRAM PROPERTIES...), called by ctest itself before the tests
#
# Lists the cases of a GoogleTest program and creates a test for each group that shares expensive fixtures, a device and
# compiled pipelines: the cases of one suite, or of one parameter of a parameterised suite. The
# tests are NAME.SUITE and NAME.SUITE/PARAMETER.
function(penumbra_add_case_groups name program)
  if(NOT EXISTS "${program}")
    add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)
    return()
  endif()
  execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listing RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    add_test("${name}.cannot_list_its_cases" "${program}" --gtest_list_tests)
    return()
  endif()

  string(REPLACE ";" "," listing "${listing}")
  string(REGEX REPLACE "\r?\n" ";" lines "${listing}")
  set(groups)
  foreach(line IN LISTS lines)
    string(REGEX REPLACE " *#.*" "" line "${line}")
    if(line MATCHES "^([^ ].*)\\.$")
      set(suite ${CMAKE_MATCH_1})
    elseif(line MATCHES "^  (DISABLED_|.*/DISABLED_)" OR suite MATCHES "DISABLED_")
      continue()
    elseif(line MATCHES "^  [^/]+(/.+)$")
      list(APPEND groups "${suite}.*${CMAKE_MATCH_1}")
    elseif(line MATCHES "^  ")
      list(APPEND groups "${suite}.*")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES groups)

  foreach(group IN LISTS groups)
    string(REPLACE ".*" "" short "${group}")
    add_test("${name}.${short}" "${program}" --gtest_brief=1 "--gtest_filter=${group}")
    set_tests_properties("${name}.${short}" PROPERTIES ${ARGN})
  endforeach()
endfunction()
