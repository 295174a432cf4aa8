# find_package(lobelia CONFIG) gives lobelia::lobelia: the core library, its headers, and the GLSL on the
# same include path (#include "lobelia/taps.glsl").
include(CMakeFindDependencyMacro)
find_dependency(Vulkan)
include(${CMAKE_CURRENT_LIST_DIR}/lobeliaTargets.cmake)
