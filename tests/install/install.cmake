# cmake -DBUILD= -DPREFIX= -P install.cmake: installs the build tree BUILD to PREFIX, which is emptied first.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} COMMAND_ECHO STDOUT
                COMMAND_ERROR_IS_FATAL ANY)
