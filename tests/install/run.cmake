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
if(evaluation)
  run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/evaluation/prefix)
  consume(evaluation)
endif()
