# What users get: headers under a prefix of their own, the library, and two ways to find them.
include(CMakePackageConfigHelpers)

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/pcl_attention-${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_attention)

install(TARGETS pcl_attention EXPORT pcl_attentionTargets
  LIBRARY COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development
  RUNTIME COMPONENT library
  INCLUDES DESTINATION ${headers})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ ${PROJECT_BINARY_DIR}/include/ DESTINATION ${headers}
  COMPONENT development)

install(EXPORT pcl_attentionTargets NAMESPACE pcl_attention:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/pcl_attentionConfig.cmake.in
  ${PROJECT_BINARY_DIR}/pcl_attentionConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pcl_attentionConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pcl_attentionConfig.cmake ${PROJECT_BINARY_DIR}/pcl_attentionConfigVersion.cmake
  DESTINATION ${package} COMPONENT development)

# What a static library is linked with has to be named to pkg-config as well.
set(pkg_config_openmp "")
if(OpenMP_CXX_FOUND)
  set(pkg_config_openmp ${OpenMP_CXX_FLAGS})
endif()
file(RELATIVE_PATH pkg_config_to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" pkg_config_to_prefix "${pkg_config_to_prefix}")
configure_file(${PROJECT_SOURCE_DIR}/cmake/pcl_attention.pc.in ${PROJECT_BINARY_DIR}/pcl_attention.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/pcl_attention.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
