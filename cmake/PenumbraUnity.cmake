# Sources of a room that are compiled together, with PENUMBRA_UNITY_BUILD; the release and fuzz presets set it. Headers
# are then parsed and templates instantiated once for eight sources (PENUMBRA_UNITY_BATCH). The other presets compile
# each source by itself, so that a missing include is found there. Names with internal linkage must be unique
# within a room.
option(PENUMBRA_UNITY_BUILD "Compile several sources of a room together" OFF)
set(PENUMBRA_UNITY_BATCH 8 CACHE STRING "How many sources of a room are compiled together")

function(penumbra_unity target)
  if(NOT PENUMBRA_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${PENUMBRA_UNITY_BATCH})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # A local name shadows nothing that would be visible in a separately compiled source.
    target_compile_options(${target} PRIVATE -Wno-shadow -Wshadow=local)
  endif()
endfunction()
