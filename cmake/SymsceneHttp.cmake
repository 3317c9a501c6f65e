# Sets SYMSCENE_HTTP_LIBRARIES to what the page of a live scene needs, or to nothing where it is not installed.
include(SymsceneCompiles)

# As the distribution compiles its library.
set(SYMSCENE_HTTP_DEFINITIONS CPPHTTPLIB_OPENSSL_SUPPORT CPPHTTPLIB_ZLIB_SUPPORT CPPHTTPLIB_BROTLI_SUPPORT)
find_path(SYMSCENE_HTTP_INCLUDE httplib.h)
find_library(SYMSCENE_LIBRARY_http cpp-httplib)
mark_as_advanced(SYMSCENE_HTTP_INCLUDE SYMSCENE_LIBRARY_http)
symscene_check_compiles(SYMSCENE_HTTP_WORKS
  "#define CPPHTTPLIB_OPENSSL_SUPPORT\n#define CPPHTTPLIB_ZLIB_SUPPORT\n#define CPPHTTPLIB_BROTLI_SUPPORT\n#include <httplib.h>\nint main() { httplib::Server server; return server.is_running() ? 1 : 0; }"
  INCLUDES ${SYMSCENE_HTTP_INCLUDE} LIBRARIES ${SYMSCENE_LIBRARY_http})
set(SYMSCENE_HTTP_LIBRARIES "")
if(SYMSCENE_HTTP_WORKS)
  set(SYMSCENE_HTTP_LIBRARIES ${SYMSCENE_LIBRARY_http})
else()
  message(STATUS "No page of live scenes: libcpp-httplib-dev would add it")
endif()
