# Installation in two parts. `pardel` is what links nothing but the standard library and OpenMP; `properties`
# (pardel::properties, pardel::ref where built) needs CGAL as well, so that a user of the mesher alone does not.
include(CMakePackageConfigHelpers)
set(PARDEL_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/pardel)

function(pardel_install_libraries export)
  install(TARGETS ${ARGN} EXPORT ${export} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT ${export} NAMESPACE pardel:: DESTINATION ${PARDEL_CMAKE_DIR})
endfunction()

# include/pardel/FOLDER, as in the repository: headers include each other by relative paths.
function(pardel_install_headers)
  foreach(folder ${ARGN})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pardel
            FILES_MATCHING PATTERN "*.hpp")
  endforeach()
endfunction()

pardel_install_libraries(pardelTargets pardel_settings pardel_core pardel_parallel)
pardel_install_headers(core parallel)

set(checker_targets)
foreach(folder properties ref)
  if(TARGET pardel_${folder})
    list(APPEND checker_targets pardel_${folder})
    pardel_install_headers(${folder})
  endif()
endforeach()
if(checker_targets)
  pardel_install_libraries(pardelCheckerTargets ${checker_targets})
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pardelConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/pardelConfig.cmake INSTALL_DESTINATION ${PARDEL_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pardelConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pardelConfig.cmake ${PROJECT_BINARY_DIR}/pardelConfigVersion.cmake
        DESTINATION ${PARDEL_CMAKE_DIR})
