# What find_package(penumbra) finds: penumbra::input and penumbra::parameters, headers under include/penumbra.
# Install it alone, without the programs, by: cmake --install BUILD --component penumbra_parameters
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(penumbra_package ${CMAKE_INSTALL_LIBDIR}/cmake/penumbra)

foreach(room input parameters)
  set_target_properties(penumbra_${room} PROPERTIES EXPORT_NAME ${room})
  target_compile_features(penumbra_${room} PUBLIC cxx_std_20)
  install(TARGETS penumbra_${room} EXPORT penumbraTargets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT penumbra_parameters)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/base/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/penumbra
          COMPONENT penumbra_parameters FILES_MATCHING PATTERN "*.h")
endforeach()
install(EXPORT penumbraTargets NAMESPACE penumbra:: DESTINATION ${penumbra_package}
        COMPONENT penumbra_parameters)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/penumbraConfig.cmake.in
  ${PROJECT_BINARY_DIR}/penumbraConfig.cmake INSTALL_DESTINATION ${penumbra_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/penumbraConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/penumbraConfig.cmake ${PROJECT_BINARY_DIR}/penumbraConfigVersion.cmake
        DESTINATION ${penumbra_package} COMPONENT penumbra_parameters)
