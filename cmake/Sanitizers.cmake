# lobelia_keep_drivers_loaded(<program>)
# Under the address and the thread sanitizer, lets the program unload nothing: a Vulkan driver that is
# unloaded takes the pointers to its own memory with it, and what they held would count as leaked; and
# it could not be told any more what is not to be reported of it.
function(lobelia_keep_drivers_loaded program)
    if(CMAKE_CXX_FLAGS MATCHES "fsanitize=[a-z,]*(address|thread)")
        target_sources(${program} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/keep_drivers_loaded.cpp)
    endif()
endfunction()
