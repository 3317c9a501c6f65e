# Installs the build to a folder of its own, then configures, builds and runs projects that find it there.
#   cmake -D source=FOLDER -D build=BUILD -D generator=... -D compiler=... -D evaluation=TRUE|FALSE -P run.cmake
set(work ${build}/install-test)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# consume(PROJECT [-D...]): builds and runs tests/install/PROJECT.
function(consume project)
  run(${CMAKE_COMMAND} -S ${source}/${project} -B ${work}/${project}/build -G ${generator}
    -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${work}/${project}/prefix -D CMAKE_BUILD_TYPE=Debug ${ARGN})
  run(${CMAKE_COMMAND} --build ${work}/${project}/build)
  run(${work}/${project}/build/consumer)
endfunction()

# The robot's wing alone, and without what only the other needs.
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/robot/prefix --component robot)
consume(robot -D CMAKE_DISABLE_FIND_PACKAGE_embree=ON)

# No file that is installed for other builds names a folder of this machine, apart from where it was installed itself.
file(GLOB_RECURSE exported ${work}/robot/prefix/*.cmake ${work}/robot/prefix/*.pc)
foreach(file ${exported})
  file(STRINGS ${file} named REGEX "[\";]/[^\";]*\\.(so|a)|${source}|${build}/lib")
  if(named)
    message(FATAL_ERROR "expected no path of this machine in ${file}, found ${named}")
  endif()
endforeach()

# The same program by pkg-config.
find_program(pkg_config pkg-config)
if(pkg_config)
  file(GLOB_RECURSE description ${work}/robot/prefix/*/symscene.pc)
  get_filename_component(folder ${description} DIRECTORY)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} ${pkg_config} --cflags --libs symscene
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${compiler} ${source}/robot/main.cpp -o ${work}/robot/by_pkg_config ${flags})
  run(${work}/robot/by_pkg_config)
else()
  message(STATUS "skipped: no pkg-config")
endif()
if(evaluation)
  run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/evaluation/prefix)
  consume(evaluation)
endif()
