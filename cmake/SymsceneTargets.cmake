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
if(SYMSCENE_STD_THREADS)
  target_include_directories(symscene_flags BEFORE INTERFACE ${PROJECT_SOURCE_DIR}/tests/std_threads)
endif()
target_compile_options(symscene_flags INTERFACE
  -Wall -Wextra -Wconversion $<$<AND:$<BOOL:${SYMSCENE_WERROR}>,$<BOOL:${tested_compiler}>>:-Werror>
  # GCC 12 invents these in its own std::string (its bugs 105329, 105651); the sanitizers see true ones.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:
    -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread>
  # The heap of a unit grows before it is searched for garbage: a sixth less time for a fifth more memory.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=2097152>
  # The same bits on every machine: no fused multiply-add behind our back.
  -ffp-contract=off
  # No code asks for floating-point exceptions; without them GCC vectorises selections.
  -fno-trapping-math)
if(SYMSCENE_SANITIZE)
  target_compile_options(symscene_flags INTERFACE
    -fsanitize=${SYMSCENE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/undefined_ignored.txt>)
  target_link_options(symscene_flags INTERFACE -fsanitize=${SYMSCENE_SANITIZE})
  target_compile_definitions(symscene_flags INTERFACE SYMSCENE_SANITIZED _GLIBCXX_ASSERTIONS)
else()
  # Hardened as the distribution's packages are (docs/security.md; tests/build/hardened.sh).
  include(CheckPIESupported)
  check_pie_supported()
  target_compile_options(symscene_flags INTERFACE -fstack-protector-strong -fstack-clash-protection
    $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2>)
  target_link_options(symscene_flags INTERFACE -Wl,-z,relro,-z,now)
endif()

# symscene_library(ROOM [EVALUATION] LINK public... PRIVATE_LINK private...)
# The static library symscene_ROOM, alias symscene::ROOM, of every source in src/ROOM (evaluation/ROOM). Its headers:
#   ROOM/include/symscene/ROOM   the interface, installed
#   ROOM/internal/ROOM           what other rooms of this project read too, not installed
#   ROOM                         what no other room sees
# A room sees the headers of the rooms that it links, and no others. It links only rooms declared above it, so that the
# robot's wing, which comes first, depends on no room of the other.
function(symscene_library name)
  cmake_parse_arguments(arg "EVALUATION" "" "LINK;PRIVATE_LINK" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/src/${name})
  set(wing SYMSCENE_LIBRARIES)
  if(arg_EVALUATION)
    set(folder ${PROJECT_SOURCE_DIR}/evaluation/${name})
    set(wing SYMSCENE_EVALUATION_LIBRARIES)
  endif()
  foreach(library IN LISTS arg_LINK arg_PRIVATE_LINK)
    if(library MATCHES "^symscene::" AND NOT TARGET ${library})
      message(FATAL_ERROR "${name} links ${library}: a room links only rooms declared above it")
    endif()
  endforeach()
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  add_library(symscene_${name} STATIC ${sources})
  add_library(symscene::${name} ALIAS symscene_${name})
  set_target_properties(symscene_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    UNITY_BUILD ${SYMSCENE_UNITY} UNITY_BUILD_BATCH_SIZE 24 SYMSCENE_FOLDER ${folder})
  target_include_directories(symscene_${name} PUBLIC
    $<BUILD_INTERFACE:${folder}/include> $<BUILD_INTERFACE:${folder}/internal>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
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
  set_property(GLOBAL APPEND PROPERTY ${wing} symscene_${name})
endfunction()

# symscene_optional(ROOM SOURCE DEFINITION INCLUDES folder... LIBRARIES library...)
# What one source of a room does with an optional library: only it is compiled anew where that comes or goes.
function(symscene_optional name source definition)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "INCLUDES;LIBRARIES")
  if(NOT arg_LIBRARIES)
    return()
  endif()
  get_target_property(folder symscene_${name} SYMSCENE_FOLDER)
  list(REMOVE_ITEM arg_INCLUDES /usr/include)
  list(TRANSFORM arg_INCLUDES PREPEND "-isystem")
  set_source_files_properties(${folder}/${source} PROPERTIES
    COMPILE_DEFINITIONS ${definition} COMPILE_OPTIONS "${arg_INCLUDES}" SKIP_UNITY_BUILD_INCLUSION ON)
  foreach(library IN LISTS arg_LIBRARIES)
    symscene_link_optional(${name} ${library})
  endforeach()
endfunction()

# symscene_link_optional(ROOM LIBRARY): the file here, its name for those who link what is installed: on their machine it
# may lie elsewhere.
function(symscene_link_optional name library)
  get_filename_component(short ${library} NAME_WLE)
  string(REGEX REPLACE "^lib" "" short ${short})
  target_link_libraries(symscene_${name} PRIVATE $<BUILD_INTERFACE:${library}> $<INSTALL_INTERFACE:${short}>)
  set_property(TARGET symscene_${name} APPEND PROPERTY SYMSCENE_OPTIONAL_LIBRARIES ${short})
endfunction()

# symscene_see_private_headers(TARGET FOLDER)
# TARGET, which tests the room in src/ROOM, evaluation/ROOM, includes what stands beside the room's sources as
# "ROOM/header.hpp". It sees those of no other room: hence not all of src/, but a folder with this one in it.
function(symscene_see_private_headers target folder)
  get_filename_component(room ${folder} NAME)
  set(only ${PROJECT_BINARY_DIR}/private_headers/${room})
  file(MAKE_DIRECTORY ${only})
  file(CREATE_LINK ${folder} ${only}/${room} SYMBOLIC)
  target_include_directories(${target} PRIVATE ${only})
endfunction()
