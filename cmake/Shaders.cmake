# Compiles GLSL to SPIR-V for Vulkan 1.1, checks it, and puts <name>.inc (a C initializer list of words)
# on the private include path of <target>. Rebuilds when any included .glsl changes.
find_program(LOBELIA_GLSLANG glslangValidator REQUIRED)
find_program(LOBELIA_SPIRV_VAL spirv-val REQUIRED)

# lobelia_embed_shader(<target> <shader> <name> [<macro>...]): with the macros defined.
function(lobelia_embed_shader target shader name)
    cmake_path(ABSOLUTE_PATH shader)
    set(out_dir ${CMAKE_CURRENT_BINARY_DIR}/spirv)
    set(out ${out_dir}/${name})
    file(MAKE_DIRECTORY ${out_dir})
    list(TRANSFORM ARGN PREPEND -D)
    set(compile ${LOBELIA_GLSLANG} --quiet --target-env vulkan1.1 -I${PROJECT_SOURCE_DIR}/shaders ${ARGN})
    add_custom_command(
        OUTPUT ${out}.inc
        COMMAND ${compile} ${shader} -o ${out}.spv
        COMMAND ${LOBELIA_SPIRV_VAL} --target-env vulkan1.1 ${out}.spv
        COMMAND ${compile} --depfile ${out}.d -x ${shader} -o ${out}.inc
        DEPENDS ${shader} DEPFILE ${out}.d VERBATIM)
    target_sources(${target} PRIVATE ${out}.inc)
    target_include_directories(${target} PRIVATE ${out_dir})
endfunction()

# lobelia_embed_shaders(<target> <shader>...): each under its own name.
function(lobelia_embed_shaders target)
    foreach(shader IN LISTS ARGN)
        cmake_path(GET shader FILENAME name)
        lobelia_embed_shader(${target} ${shader} ${name})
    endforeach()
endfunction()
