# cmake --install: the core library for engines, its headers and the GLSL of lobes and shading, which C++
# headers include too, and the files that find_package(lobelia CONFIG) reads.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lobelia)
install(TARGETS lobelia EXPORT lobeliaTargets)
install(EXPORT lobeliaTargets NAMESPACE lobelia:: DESTINATION ${package_dir})
install(DIRECTORY include/lobelia DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} PATTERN host EXCLUDE)
install(DIRECTORY shaders/lobelia DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lobeliaConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES cmake/lobeliaConfig.cmake ${PROJECT_BINARY_DIR}/lobeliaConfigVersion.cmake
        DESTINATION ${package_dir})
