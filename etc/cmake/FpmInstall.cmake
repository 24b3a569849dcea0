# What `cmake --install build --prefix <folder>` puts there. Component `libraries`: lib/, include/fpm/ and
# the package for find_package(fpm), which gives fpm::solver and what it stands on (tests/external/embed).
# Component `programs`: bin/ and the annotated dictionaries of -writeDefaults.
include(CMakePackageConfigHelpers)
set(package lib/cmake/fpm)

set_property(TARGET fpmFlags PROPERTY EXPORT_NAME flags)
install(TARGETS fpmFlags EXPORT fpmTargets)
install(EXPORT fpmTargets NAMESPACE fpm:: DESTINATION ${package} COMPONENT libraries)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/fpmConfig.cmake.in
    ${CMAKE_BINARY_DIR}/fpmConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/fpmConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/fpmConfig.cmake ${CMAKE_BINARY_DIR}/fpmConfigVersion.cmake
    DESTINATION ${package} COMPONENT libraries)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/etc/caseDicts DESTINATION share/fpm/etc COMPONENT programs)
