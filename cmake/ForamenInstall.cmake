# Installs and exports the library, so that find_package(foramen COMPONENTS model) works.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/foramen)
get_property(modules GLOBAL PROPERTY FORAMEN_INSTALLED_MODULES)
set(FORAMEN_CONFIG_MODULES "${modules}")
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/foramenConfig.cmake.in foramenConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(foramenConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/foramenConfig.cmake ${PROJECT_BINARY_DIR}/foramenConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/Findlibmd.cmake ${PROJECT_SOURCE_DIR}/cmake/Findlz4.cmake
        DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/include/foramen/foramen.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/foramen)
# One export set per module, so that a consumer of `model` does not need the libraries of `io`.
foreach(module IN LISTS modules)
  install(EXPORT foramen-${module} NAMESPACE foramen:: FILE foramen-${module}.cmake DESTINATION ${package_dir})
endforeach()
