# Warnings for our own targets only; never part of what an embedder inherits.
# -Wno-missing-field-initializers: Vulkan structs begin with their sType alone.
# -Wno-subobject-linkage: GCC takes the files of a unity build for headers.
# -Wno-restrict: GCC 12 warns of std::string's own operator+ when optimising (its bug 105651).
add_library(lobelia_warnings INTERFACE)
target_compile_options(lobelia_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -Wno-missing-field-initializers
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-subobject-linkage>")

# For what is compiled more often than it works long: programs around the library, and tests.
# -Wno-...: at -O1 GCC 12 takes std::string's short buffer for all that it holds (its bug 105329).
add_library(lobelia_light_work INTERFACE)
target_compile_options(lobelia_light_work INTERFACE
    $<$<CONFIG:Release>:-O1> "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>")
