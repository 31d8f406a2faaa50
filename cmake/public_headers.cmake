# Finds the public headers, for an installation and for the build tree. The headers directly in a folder are public; the
# headers in its subfolders are private. Public headers keep their paths below include/pardel, because they include each
# other by relative paths. parallel/pardel.hpp includes the whole mesher; it becomes <pardel/pardel.hpp>.
set(PARDEL_MESHER_FOLDERS core parallel)
set(PARDEL_CHECKER_FOLDERS properties/checker properties/domains properties/domains/generators)

# Sets OUT to the public headers of a folder, as absolute paths.
function(pardel_public_headers folder out)
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  list(REMOVE_ITEM headers ${PROJECT_SOURCE_DIR}/parallel/pardel.hpp)
  set(${out} ${headers} PARENT_SCOPE)
endfunction()

# Makes the folder for #include <pardel/...> in the build tree. It contains a link to every public header and nothing
# else.
function(pardel_link_public_headers include)
  file(REMOVE_RECURSE ${include}/pardel)  # mpi/ adds its header later
  foreach(folder ${PARDEL_MESHER_FOLDERS} off_the_shelf distributed ${PARDEL_CHECKER_FOLDERS})
    file(MAKE_DIRECTORY ${include}/pardel/${folder})
    pardel_public_headers(${folder} headers)
    foreach(header ${headers})
      get_filename_component(name ${header} NAME)
      file(CREATE_LINK ${header} ${include}/pardel/${folder}/${name} SYMBOLIC)
    endforeach()
  endforeach()
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/parallel/pardel.hpp ${include}/pardel/pardel.hpp SYMBOLIC)
endfunction()

# Installs the public headers of these folders.
function(pardel_install_headers)
  foreach(folder ${ARGN})
    pardel_public_headers(${folder} headers)
    install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pardel/${folder})
  endforeach()
endfunction()
