# cmake -DBUILD=... -DPREFIX=... -P install.cmake: installs, and moves what was installed to PREFIX, so that
# nothing that knows the first place is of use.
file(REMOVE_RECURSE ${PREFIX} ${PREFIX}.first)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}.first
                COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${PREFIX}.first ${PREFIX})
