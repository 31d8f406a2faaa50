# Installation in parts. The package `pardel` needs the standard library, OpenMP and zlib only. Its component `properties`
# (the checker, the domains and their generators) also needs CGAL, so users of the mesher alone do not need CGAL. The
# component `distributed` has what several processes need to make one mesh, and the component `mpi`, which needs MPI, the
# ranks of an MPI job.
include(CMakePackageConfigHelpers)
set(PARDEL_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/pardel)

function(pardel_install_libraries export)
  install(TARGETS ${ARGN} EXPORT ${export} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT ${export} NAMESPACE pardel:: DESTINATION ${PARDEL_CMAKE_DIR})
endfunction()

pardel_install_libraries(pardelTargets pardel_settings pardel_core pardel_formats pardel_parallel pardel_off_the_shelf)
pardel_install_headers(${PARDEL_MESHER_FOLDERS} off_the_shelf)
if(TARGET pardel_distributed)
  pardel_install_libraries(pardelDistributedTargets pardel_distributed)
  pardel_install_headers(distributed)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/parallel/pardel.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pardel)

if(TARGET pardel_checker)
  pardel_install_libraries(pardelCheckerTargets pardel_checker pardel_domains pardel_generators pardel_properties)
  pardel_install_headers(${PARDEL_CHECKER_FOLDERS})
endif()

if(TARGET pardel_mpi)
  pardel_install_libraries(pardelMpiTargets pardel_mpi)
  install(FILES ${PROJECT_SOURCE_DIR}/mpi/mpi_ranks.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pardel/mpi)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pardelConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/pardelConfig.cmake INSTALL_DESTINATION ${PARDEL_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pardelConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pardelConfig.cmake ${PROJECT_BINARY_DIR}/pardelConfigVersion.cmake
        DESTINATION ${PARDEL_CMAKE_DIR})
