# lobelia_embed_shaders(<target> <shader>...)
# Compiles GLSL to SPIR-V for Vulkan 1.1, checks it, and puts <shader name>.inc (a C initializer
# list of words) on the private include path of <target>. Rebuilds when any included .glsl changes.
find_program(GLSLANG glslangValidator REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

function(lobelia_embed_shaders target)
    set(include_dir ${PROJECT_SOURCE_DIR}/shaders)
    set(out_dir ${CMAKE_CURRENT_BINARY_DIR}/spirv)
    file(MAKE_DIRECTORY ${out_dir})
    foreach(shader IN LISTS ARGN)
        cmake_path(ABSOLUTE_PATH shader)
        cmake_path(GET shader FILENAME name)
        set(out ${out_dir}/${name})
        set(compile ${GLSLANG} --quiet --target-env vulkan1.1 -I${include_dir})
        add_custom_command(
            OUTPUT ${out}.inc
            COMMAND ${compile} ${shader} -o ${out}.spv
            COMMAND ${SPIRV_VAL} --target-env vulkan1.1 ${out}.spv
            COMMAND ${compile} --depfile ${out}.d -x ${shader} -o ${out}.inc
            DEPENDS ${shader} DEPFILE ${out}.d VERBATIM)
        target_sources(${target} PRIVATE ${out}.inc)
    endforeach()
    target_include_directories(${target} PRIVATE ${out_dir})
endfunction()
