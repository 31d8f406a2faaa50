# Installation in two parts. `pardel` is what links nothing but the standard library and OpenMP; the component
# `properties` (the checker, the domains and their generators) needs CGAL as well, so that a user of the mesher alone
# does not. Public headers only: what is private stays in the source tree.
include(CMakePackageConfigHelpers)
set(PARDEL_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/pardel)

function(pardel_install_libraries export)
  install(TARGETS ${ARGN} EXPORT ${export} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT ${export} NAMESPACE pardel:: DESTINATION ${PARDEL_CMAKE_DIR})
endfunction()

# The headers of these folders, without those of the folders below: include/pardel/FOLDER, as in the repository, since
# headers include each other by relative paths.
function(pardel_install_headers)
  foreach(folder ${ARGN})
    file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
    install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pardel/${folder})
  endforeach()
endfunction()

pardel_install_libraries(pardelTargets pardel_settings pardel_core pardel_parallel)
pardel_install_headers(core parallel)

if(TARGET pardel_checker)
  pardel_install_libraries(pardelCheckerTargets pardel_checker pardel_domains pardel_generators pardel_properties)
  pardel_install_headers(properties/checker properties/domains properties/domains/generators)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pardelConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/pardelConfig.cmake INSTALL_DESTINATION ${PARDEL_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pardelConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pardelConfig.cmake ${PROJECT_BINARY_DIR}/pardelConfigVersion.cmake
        DESTINATION ${PARDEL_CMAKE_DIR})
