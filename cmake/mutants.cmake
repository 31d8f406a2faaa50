# A mutant is a known mistake that can be switched on. The mutated twin of a target is built from a copy of the same
# sources that contains all mutants (properties/mutants/patch.hpp). A mutant is off unless the environment variable
# PARDEL_MUTANT names it. A twin is linked to the mutated twins of the project's libraries.

# The folder of this copy, and the folders of the sources that it contains.
set(PARDEL_MUTATED_SOURCES ${PROJECT_BINARY_DIR}/mutated_sources)
set(PARDEL_MUTATED_FOLDERS core parallel distributed off_the_shelf properties ref cli fuzz tests)

# The libraries that have a mutated twin.
set(PARDEL_MUTATED "comparison|core|formats|parallel|distributed|off_the_shelf|checker|domains|defects|wrong_meshes|generators|ref|schemes|framework|samples")
# Libraries without the prefix `pardel_` that have one.
set(PARDEL_MUTATED_SUPPORT
    "fuzz_support|fuzz_cases|fuzz_input_faces|fuzz_known_files|fuzz_readers|fuzz_drawn_cells|fuzz_pieces|fuzz_exact_signs|fuzz_judgement|many_domains_parts")

# Defines the target mutated_sources, which makes the copy. The target runs again when a source, a patch or the registry
# changes. It writes only the files that differ, so the build recompiles nothing else.
function(pardel_copy_sources_with_mutants)
  set(mutants ${PROJECT_SOURCE_DIR}/properties/mutants)
  set(patterns)
  foreach(folder ${PARDEL_MUTATED_FOLDERS})
    list(APPEND patterns ${PROJECT_SOURCE_DIR}/${folder}/*.hpp ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  endforeach()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
  file(GLOB patches CONFIGURE_DEPENDS ${mutants}/patches/*)
  list(TRANSFORM sources REPLACE "^${PROJECT_SOURCE_DIR}/" "${PARDEL_MUTATED_SOURCES}/" OUTPUT_VARIABLE copies)
  set(stamp ${PARDEL_MUTATED_SOURCES}.stamp)
  add_custom_command(
    OUTPUT ${stamp}
    BYPRODUCTS ${copies}
    COMMAND apply_patches ${PROJECT_SOURCE_DIR} ${PARDEL_MUTATED_SOURCES} ${PARDEL_MUTATED_FOLDERS}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS apply_patches ${sources} ${patches} ${mutants}/registry
    COMMENT "Copying the sources with all mutants"
    VERBATIM)
  add_custom_target(mutated_sources DEPENDS ${stamp})
endfunction()

# pardel_mutated_twin(TARGET): the library or program TARGET_mutated.
function(pardel_mutated_twin target)
  get_target_property(type ${target} TYPE)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  set(copies)
  foreach(source ${sources})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    list(APPEND copies ${PARDEL_MUTATED_SOURCES}/${source})
  endforeach()
  if(type STREQUAL "EXECUTABLE")
    add_executable(${target}_mutated ${copies})
  else()
    add_library(${target}_mutated STATIC ${copies})
  endif()
  # What needs a twin depends on it.
  set_target_properties(${target}_mutated PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies(${target}_mutated mutated_sources)
  # Mutants cause harmless warnings. Full optimisation would take longer than it saves when the programs run.
  target_compile_options(${target}_mutated PRIVATE -w -O1)
  get_target_property(precompiled ${target} PRECOMPILE_HEADERS_REUSE_FROM)
  if(precompiled)
    target_precompile_headers(${target}_mutated REUSE_FROM ${precompiled})
  endif()
  foreach(property COMPILE_OPTIONS COMPILE_DEFINITIONS LINK_LIBRARIES INTERFACE_LINK_LIBRARIES
                   INTERFACE_COMPILE_OPTIONS)
    get_target_property(value ${target} ${property})
    if(value)
      string(REGEX REPLACE "(${PARDEL_MUTATED_SUPPORT})" "\\1_mutated" value "${value}")
      string(REGEX REPLACE "pardel(::|_)(${PARDEL_MUTATED})([^a-z_]|$)" "pardel_\\2_mutated\\3" value "${value}")
      set_property(TARGET ${target}_mutated APPEND PROPERTY ${property} "${value}")
    endif()
  endforeach()
endfunction()
