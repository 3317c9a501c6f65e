# Warnings, sanitizers and code generation that every target of the project shares.
add_library(symscene_flags INTERFACE)
target_compile_features(symscene_flags INTERFACE cxx_std_20)
target_compile_options(symscene_flags INTERFACE
  -Wall -Wextra -Wconversion $<$<BOOL:${SYMSCENE_WERROR}>:-Werror>
  # The same bits on every machine: no fused multiply-add behind our back.
  -ffp-contract=off)
if(SYMSCENE_SANITIZE)
  target_compile_options(symscene_flags INTERFACE
    -fsanitize=${SYMSCENE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(symscene_flags INTERFACE -fsanitize=${SYMSCENE_SANITIZE})
  target_compile_definitions(symscene_flags INTERFACE SYMSCENE_SANITIZED)
endif()

# symscene_library(NAME LINK public... PRIVATE_LINK private...)
# The static library symscene_NAME, alias symscene::NAME, of every source in src/NAME.
function(symscene_library name)
  cmake_parse_arguments(arg "" "" "LINK;PRIVATE_LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_library(symscene_${name} STATIC ${sources})
  add_library(symscene::${name} ALIAS symscene_${name})
  set_target_properties(symscene_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(symscene_${name}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_compile_features(symscene_${name} PUBLIC cxx_std_20)
  target_link_libraries(symscene_${name} PUBLIC ${arg_LINK} PRIVATE $<BUILD_INTERFACE:symscene_flags> ${arg_PRIVATE_LINK})
  target_precompile_headers(symscene_${name} PRIVATE <Eigen/Core> <Eigen/Geometry> <vector> <string> <algorithm>)
  set_property(GLOBAL APPEND PROPERTY SYMSCENE_LIBRARIES symscene_${name})
endfunction()
