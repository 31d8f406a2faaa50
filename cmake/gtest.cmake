# pardel_discover_tests(PROGRAM [NO_PRETTY_VALUES] PROPERTIES NAME VALUE...): the tests of a GoogleTest program become
# tests of ctest, one process each. With PARDEL_TESTS_TOGETHER a program has four tests of ctest, PROGRAM.0 to
# PROGRAM.3, each with a quarter of its tests: under a sanitizer, the start of a process takes longer than most tests.
include(GoogleTest)
set(PARDEL_SHARDS 4)

function(pardel_discover_tests program)
  if(NOT PARDEL_TESTS_TOGETHER)
    gtest_discover_tests(${program} ${ARGN})
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 tests "NO_PRETTY_VALUES" "" "PROPERTIES")
  math(EXPR last "${PARDEL_SHARDS} - 1")
  foreach(shard RANGE ${last})
    set(name ${program}.${shard})
    add_test(NAME ${name} COMMAND ${program} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES ${tests_PROPERTIES})
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT GTEST_TOTAL_SHARDS=${PARDEL_SHARDS} GTEST_SHARD_INDEX=${shard})
    set_property(TEST ${name} PROPERTY TIMEOUT 1800)
  endforeach()
endfunction()
