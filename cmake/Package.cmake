# cmake --install: the core library, static and shared, its headers and the GLSL of lobes and shading, which C++
# headers include too; lobelia::host; the program; and what find_package(lobelia CONFIG) and pkg-config read.
# Nothing in it knows where it was installed to. cpack makes a Debian package of the same files.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lobelia)

set(core lobelia)
if(LOBELIA_SHARED)
    list(APPEND core lobelia_shared)
endif()
install(TARGETS ${core} EXPORT lobeliaTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT lobeliaTargets NAMESPACE lobelia:: DESTINATION ${package_dir})
install(DIRECTORY include/lobelia DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} PATTERN host EXCLUDE)
install(DIRECTORY shaders/lobelia DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(LOBELIA_HOST)
    install(TARGETS lobelia_host EXPORT lobeliaHostTargets)
    install(EXPORT lobeliaHostTargets NAMESPACE lobelia:: DESTINATION ${package_dir})
    install(DIRECTORY include/lobelia/host DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lobelia)
endif()

write_basic_package_version_file(${PROJECT_BINARY_DIR}/lobeliaConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES cmake/lobeliaConfig.cmake ${PROJECT_BINARY_DIR}/lobeliaConfigVersion.cmake
        DESTINATION ${package_dir})

cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}
           OUTPUT_VARIABLE libdir_in_prefix)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX
           BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig OUTPUT_VARIABLE prefix_from_file)
configure_file(cmake/lobelia.pc.in lobelia.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/lobelia.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Lobelia project")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # what the program links
set(CPACK_DEBIAN_PACKAGE_DEPENDS "mesa-vulkan-drivers | vulkan-icd")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox) # lobelia measure draws with it
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, glslang-tools, libvulkan-dev, libopenexr-dev, libpng-dev") # to link it
include(CPack)
