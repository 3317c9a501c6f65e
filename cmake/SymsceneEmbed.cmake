# Embeds text files into libraries, so that these need no file at run time.
include_guard(GLOBAL)

# symscene_embed(TARGET FILE FUNCTION): adds `std::string_view symscene::FUNCTION()`, the text of FILE, to TARGET, which
# declares it itself.
function(symscene_embed target file function)
  set(script ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)
  set(embedded ${PROJECT_BINARY_DIR}/embedded/${function}.cpp)
  get_filename_component(name ${file} NAME)
  add_custom_command(OUTPUT ${embedded}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${file} -DFUNCTION=${function} -DOUTPUT=${embedded} -P ${script}
    DEPENDS ${file} ${script} COMMENT "Embedding ${name}" VERBATIM)
  set_source_files_properties(${embedded} PROPERTIES SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${embedded})
endfunction()
