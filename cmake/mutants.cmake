# The mutated twin of a target: the same sources with known mistakes compiled in (core/mutants.hpp), asleep until
# the environment variable PARDEL_MUTANT names one, and linked to the mutated twins of the project's libraries.
function(pardel_mutated_twin target)
  get_target_property(type ${target} TYPE)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  list(TRANSFORM sources PREPEND ${folder}/ REGEX "^[^/]")
  if(type STREQUAL "EXECUTABLE")
    add_executable(${target}_mutated ${sources})
  else()
    add_library(${target}_mutated STATIC ${sources})
    target_compile_definitions(${target}_mutated PUBLIC PARDEL_MUTANTS)
  endif()
  # The compiler has a right to wonder about mistakes; and these programs run shorter than they take to optimise.
  target_compile_options(${target}_mutated PRIVATE -w -O1)
  foreach(property COMPILE_OPTIONS COMPILE_DEFINITIONS LINK_LIBRARIES INTERFACE_LINK_LIBRARIES INTERFACE_COMPILE_OPTIONS)
    get_target_property(value ${target} ${property})
    if(value)
      string(REGEX REPLACE "pardel(::|_)(${PARDEL_MUTATED})([^a-z_]|$)" "pardel_\\2_mutated\\3" value "${value}")
      set_property(TARGET ${target}_mutated APPEND PROPERTY ${property} "${value}")
    endif()
  endforeach()
endfunction()

# The libraries that have a mutated twin.
set(PARDEL_MUTATED "core|parallel|checker|domains|defects|generators|ref|framework|samples")
