# Sets SYMSCENE_PYTHON_FOUND to whether Python, its headers, NumPy and pybind11 are installed. Without them everything else
# is built. Python_EXECUTABLE names an interpreter; otherwise the first that has NumPy is taken.
set(SYMSCENE_PYTHON_FOUND OFF)

if(NOT Python_EXECUTABLE)
  find_program(python_on_path NAMES python3 NO_CACHE)
  foreach(candidate ${python_on_path} /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(NOT failed)
      set(Python_EXECUTABLE ${candidate})
      break()
    endif()
  endforeach()
endif()

set(missing "")
if(NOT Python_EXECUTABLE)
  set(missing "python3-numpy")
else()
  set(Python_FIND_VIRTUALENV FIRST)
  find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module NumPy)
  if(NOT Python_Development.Module_FOUND)
    list(APPEND missing python3-dev)
  endif()
  if(NOT Python_NumPy_FOUND)
    list(APPEND missing python3-numpy)
  endif()
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.10 QUIET CONFIG)
endif()
if(NOT pybind11_FOUND)
  list(APPEND missing pybind11-dev)
endif()
if(missing)
  list(REMOVE_DUPLICATES missing)
  list(JOIN missing ", " missing)
  set(SYMSCENE_PYTHON_MISSING ${missing})
  message(STATUS "No Python module: ${missing} would add it")
else()
  set(SYMSCENE_PYTHON_FOUND ON)
  set(SYMSCENE_PYTHON_EXECUTABLE ${Python_EXECUTABLE} CACHE FILEPATH "The interpreter for which the module is built" FORCE)
endif()

# Where `cmake --install` puts packages, relative to its prefix: the folder that the interpreter searches under the default
# prefix, /usr/local. Debian's interpreters call it dist-packages there.
if(SYMSCENE_PYTHON_FOUND)
  execute_process(COMMAND ${Python_EXECUTABLE} -c [[
import sys, sysconfig
name = "dist-packages" if "posix_local" in sysconfig.get_scheme_names() else "site-packages"
print(f"lib/python{sys.version_info[0]}.{sys.version_info[1]}/{name}")
]] OUTPUT_VARIABLE site OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(SYMSCENE_PYTHON_DIR ${site} CACHE STRING "Folder under the prefix for the Python package")
endif()
