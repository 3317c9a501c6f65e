# Sets SYMSCENE_SQLITE_, SYMSCENE_LZ4_ and SYMSCENE_ZSTD_LIBRARIES and _INCLUDE to what recordings of ROS 2 need, or to nothing
# where it is not installed.
include(SymsceneCompiles)

# symscene_find_recording_library(NAME PACKAGE HEADER LIBRARY CALL)
macro(symscene_find_recording_library name package header library call)
  find_path(SYMSCENE_${name}_INCLUDE ${header})
  find_library(SYMSCENE_LIBRARY_${library} ${library})
  mark_as_advanced(SYMSCENE_${name}_INCLUDE SYMSCENE_LIBRARY_${library})
  symscene_check_compiles(SYMSCENE_${name}_WORKS "#include <${header}>\nint main() { ${call}; }"
    INCLUDES ${SYMSCENE_${name}_INCLUDE} LIBRARIES ${SYMSCENE_LIBRARY_${library}})
  set(SYMSCENE_${name}_LIBRARIES "")
  if(SYMSCENE_${name}_WORKS)
    set(SYMSCENE_${name}_LIBRARIES ${SYMSCENE_LIBRARY_${library}})
  else()
    message(STATUS "Recordings of ROS 2 without ${library}: ${package} would add it")
  endif()
endmacro()

symscene_find_recording_library(SQLITE libsqlite3-dev sqlite3.h sqlite3 "return sqlite3_deserialize(nullptr, nullptr, nullptr, 0, 0, 0)")
symscene_find_recording_library(LZ4 liblz4-dev lz4frame.h lz4 "LZ4F_isError(0)")
symscene_find_recording_library(ZSTD libzstd-dev zstd.h zstd "ZSTD_isError(0)")
