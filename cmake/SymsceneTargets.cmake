# Warnings, sanitizers and code generation that every target of the project shares.
include_guard(GLOBAL)

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# Warnings stop the build only under the compilers that continuous integration runs.
set(tested_compiler OFF)
if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13) OR
   (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15))
  set(tested_compiler ON)
endif()

add_library(symscene_flags INTERFACE)
target_compile_features(symscene_flags INTERFACE cxx_std_20)
target_compile_definitions(symscene_flags INTERFACE EIGEN_MPL2_ONLY)
target_compile_options(symscene_flags INTERFACE
  -Wall -Wextra -Wconversion $<$<AND:$<BOOL:${SYMSCENE_WERROR}>,$<BOOL:${tested_compiler}>>:-Werror>
  # GCC 12 invents these in its own std::string (its bugs 105329, 105651); the sanitizers see true ones.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:
    -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread>
  # The same bits on every machine: no fused multiply-add behind our back.
  -ffp-contract=off
  # No code asks for floating-point exceptions; without them GCC vectorises selections.
  -fno-trapping-math)
if(SYMSCENE_SANITIZE)
  target_compile_options(symscene_flags INTERFACE
    -fsanitize=${SYMSCENE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(symscene_flags INTERFACE -fsanitize=${SYMSCENE_SANITIZE})
  target_compile_definitions(symscene_flags INTERFACE SYMSCENE_SANITIZED)
endif()
if(SYMSCENE_BUILD_FUZZERS)
  target_compile_options(symscene_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# A second build of the same sources costs seconds where ccache is installed. Precompiled headers
# need its looser checks, and clang's need to be the same from build to build.
find_program(SYMSCENE_CCACHE ccache)
if(SYMSCENE_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    ${SYMSCENE_CCACHE})
  target_compile_options(symscene_flags INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
endif()

# symscene_library(NAME LINK public... PRIVATE_LINK private...)
# The static library symscene_NAME, alias symscene::NAME, of every source in src/NAME.
function(symscene_library name)
  cmake_parse_arguments(arg "" "" "LINK;PRIVATE_LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  add_library(symscene_${name} STATIC ${sources})
  add_library(symscene::${name} ALIAS symscene_${name})
  set_target_properties(symscene_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(symscene_${name}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_compile_features(symscene_${name} PUBLIC cxx_std_20)
  target_link_libraries(symscene_${name}
    PUBLIC ${arg_LINK} PRIVATE $<BUILD_INTERFACE:symscene_flags> ${arg_PRIVATE_LINK})
  # Core precompiles what all libraries read; the others take it from there.
  if(name STREQUAL "core")
    target_precompile_headers(symscene_core PRIVATE
      <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <functional> <optional> <span> <string> <vector>
      <fmt/format.h> <tbb/blocked_range.h> <tbb/global_control.h> <tbb/parallel_for.h>)
  else()
    target_precompile_headers(symscene_${name} REUSE_FROM symscene_core)
  endif()
  set_property(GLOBAL APPEND PROPERTY SYMSCENE_LIBRARIES symscene_${name})
endfunction()
