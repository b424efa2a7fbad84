# `find_package(heed)` gives heed::<room>; the program goes beside it.
include(CMakePackageConfigHelpers)
get_property(rooms GLOBAL PROPERTY HEED_ROOMS)
list(TRANSFORM rooms PREPEND heed_ OUTPUT_VARIABLE room_targets)
install(TARGETS ${room_targets} EXPORT heedTargets)
install(DIRECTORY include/heed DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT heedTargets NAMESPACE heed:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/heed)
configure_package_config_file(cmake/heedConfig.cmake.in ${PROJECT_BINARY_DIR}/heedConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/heed)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/heedConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/heedConfig.cmake ${PROJECT_BINARY_DIR}/heedConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/heed)
if(TARGET heed)
  install(TARGETS heed)
endif()
