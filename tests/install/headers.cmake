# cmake -DROOT= -DPREFIX= -DCOMPILER= -DMPI= -P headers.cmake: the installation in PREFIX has exactly the public headers. Each
# of them compiles by itself; those of the mesher compile without CGAL. ROOT is the repository. MPI: ON if the component
# mpi is installed.
set(include ${PREFIX}/include)

# The public headers: those directly in these folders. parallel/pardel.hpp is installed as pardel/pardel.hpp.
set(expected pardel/pardel.hpp)
foreach(folder core parallel off_the_shelf distributed properties/checker properties/domains properties/domains/generators)
  file(GLOB headers RELATIVE ${ROOT} ${ROOT}/${folder}/*.hpp)
  list(TRANSFORM headers PREPEND pardel/)
  list(APPEND expected ${headers})
endforeach()
list(REMOVE_ITEM expected pardel/parallel/pardel.hpp)
if(MPI)
  list(APPEND expected pardel/mpi/mpi_ranks.hpp)
endif()
list(SORT expected)

file(GLOB_RECURSE installed RELATIVE ${include} ${include}/*)
list(SORT installed)
if(NOT installed STREQUAL expected)
  list(JOIN installed "\n  " installed_lines)
  list(JOIN expected "\n  " expected_lines)
  message(FATAL_ERROR "installed are\n  ${installed_lines}\nexpected are\n  ${expected_lines}")
endif()

# No header of the reference, the defects, the theorem suites, the mutants and their libraries may be installed.
foreach(header ${installed})
  if(header MATCHES "ref/|defects|theorems|framework|mutants/|tests/|formats/|support/")
    message(FATAL_ERROR "${header} is installed, but is not for users")
  endif()
  file(READ ${include}/${header} text)
  if(text MATCHES "#include [<\"](rapidcheck|gtest|gmock|benchmark)")
    message(FATAL_ERROR "${header} includes a header of RapidCheck, GoogleTest or Google Benchmark")
  endif()
endforeach()

# -H lists every included file on stderr. -w suppresses the warning that the main file is a header.
foreach(header ${installed})
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -w -H -x c++ -I${include} ${include}/${header}
                  ERROR_VARIABLE output RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${header} does not compile by itself:\n${output}")
  endif()
  if(NOT header MATCHES "pardel/properties/" AND output MATCHES "[^\n]*/(CGAL|boost|gmp|mpfr)[^\n]*")
    message(FATAL_ERROR "${header} is of the mesher, but includes ${CMAKE_MATCH_0}")
  endif()
endforeach()
list(LENGTH installed count)
message(STATUS "${count} public headers, each compiles by itself")
