# Writes OUTPUT, a C++ file that defines penumbra::platform's text of the commit of SOURCE: empty outside of a git
# checkout, followed by "-dirty" if the program's sources were changed since. Not rewritten if it is unchanged.
execute_process(COMMAND git -C ${SOURCE} rev-parse --show-toplevel
                OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
set(commit "")
if(NOT failed)
  file(REAL_PATH "${top}" top)
  file(REAL_PATH "${SOURCE}" source)
  if(top STREQUAL source)  # a tarball unpacked inside of another repository does not have that one's commit
    execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND git -C ${SOURCE} status --porcelain -- tools ShaderLibrary Shaders cmake CMakeLists.txt
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes AND commit)
      string(APPEND commit "-dirty")
    endif()
  endif()
endif()
set(text "namespace penumbra::platform {\nextern const char* const source_commit_text;\nconst char* const source_commit_text = \"${commit}\";\n}  // namespace penumbra::platform\n")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
  if(before STREQUAL text)
    return()
  endif()
endif()
file(WRITE ${OUTPUT} "${text}")
