# Embeds text files as constants, for a program that runs from any folder.
#
# penumbra_embed_text(TARGET CONSTANT NAMESPACE HEADER FILE...) compiles the files, one after the other, into the
# target as the std::string_view CONSTANT of NAMESPACE, which HEADER declares. A change of a file rebuilds it.
#
# Bytes are written one by one: a compiler may reject long string literals (Microsoft's takes 16 kB).
if(CMAKE_SCRIPT_MODE_FILE)
  set(bytes "")
  string(REPLACE "|" ";" FILES "${FILES}")
  foreach(file IN LISTS FILES)
    file(READ ${file} content HEX)
    string(APPEND bytes "${content}")
  endforeach()
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(REPEAT "'[^']+'," 16 line)
  string(REGEX REPLACE "(${line})" "\\1\n" bytes "${bytes}")
  file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\nnamespace {\n\n"
    "constexpr char ${CONSTANT}Bytes[] = {\n${bytes}};\n\n}  // namespace\n\n"
    "const std::string_view ${CONSTANT}(${CONSTANT}Bytes, sizeof(${CONSTANT}Bytes));\n\n}  // namespace ${NAMESPACE}\n")
  return()
endif()

set(PENUMBRA_EMBED_TEXT_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(penumbra_embed_text target constant namespace header)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE files)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${constant}.cpp)
  list(JOIN files "|" joined)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DCONSTANT=${constant} -DNAMESPACE=${namespace} -DHEADER=${header}
            "-DFILES=${joined}" -P ${PENUMBRA_EMBED_TEXT_SCRIPT}
    DEPENDS ${files} ${PENUMBRA_EMBED_TEXT_SCRIPT} VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
