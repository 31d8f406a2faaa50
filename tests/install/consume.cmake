# cmake -DPREFIX= -DSOURCE= -DWORK= ... -P consume.cmake: configures, builds and runs the project SOURCE against the
# installation in PREFIX. PROGRAM ARGUMENTS... is its command line. The output must match EXPECTED.
function(step)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK} -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${PREFIX}
     -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${TYPE}
     "-DCMAKE_CXX_FLAGS=${FLAGS}" ${WITHOUT})
step(${CMAKE_COMMAND} --build ${WORK})
separate_arguments(ARGUMENTS UNIX_COMMAND "${ARGUMENTS}")
execute_process(COMMAND ${WORK}/${PROGRAM} ${ARGUMENTS} OUTPUT_VARIABLE output COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
if(NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "expected '${EXPECTED}' in the program's output:\n${output}")
endif()
