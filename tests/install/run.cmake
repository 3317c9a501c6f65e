# Installs the build to a folder of its own, then configures, builds and runs a project that finds it there.
set(prefix ${build}/install-test/prefix)
set(consumer ${build}/install-test/consumer)
file(REMOVE_RECURSE ${build}/install-test)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${source} -B ${consumer} -G ${generator}
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${consumer})
run(${consumer}/consumer)
