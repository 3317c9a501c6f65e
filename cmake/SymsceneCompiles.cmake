include(CheckCXXSourceCompiles)

# symscene_check_compiles(RESULT SOURCE INCLUDES folder... LIBRARIES library...): whether all of an optional library was
# found and SOURCE builds with it. Remembered as RESULT.
function(symscene_check_compiles result source)
  cmake_parse_arguments(PARSE_ARGV 2 needs "" "" "INCLUDES;LIBRARIES")
  if("${needs_INCLUDES};${needs_LIBRARIES}" MATCHES "NOTFOUND")
    return()
  endif()
  set(CMAKE_REQUIRED_INCLUDES ${needs_INCLUDES})
  set(CMAKE_REQUIRED_LIBRARIES ${needs_LIBRARIES})
  set(CMAKE_REQUIRED_FLAGS -std=c++20)
  set(CMAKE_REQUIRED_QUIET ON)
  check_cxx_source_compiles("${source}" ${result})
endfunction()
