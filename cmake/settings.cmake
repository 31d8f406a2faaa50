# The settings of all targets. The exact predicates need two of them: the compiler must not contract a*b+c into one
# rounding (-ffp-contract=off), and it must not relax floating-point arithmetic (no -ffast-math).
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(ZLIB REQUIRED)  # for the target pardel::formats only

# Public headers are included as <pardel/core/pslg.hpp>, both from the build tree and from an installation.
include(cmake/public_headers.cmake)
pardel_link_public_headers(${PROJECT_BINARY_DIR}/include)

add_library(pardel_settings INTERFACE)
set_target_properties(pardel_settings PROPERTIES EXPORT_NAME settings)
target_compile_features(pardel_settings INTERFACE cxx_std_20)
# All code that is linked with the mesher must round in the same way, also on processors with fused multiply-add.
target_compile_options(pardel_settings INTERFACE -ffp-contract=off)
target_include_directories(pardel_settings SYSTEM INTERFACE $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                                                            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

add_library(pardel_warnings INTERFACE)
target_compile_options(pardel_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
# g++ 12 warns of overlapping copies in std::string's operator+ that do not exist (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(pardel_warnings INTERFACE -Wno-restrict)
endif()
if(PARDEL_WERROR)
  target_compile_options(pardel_warnings INTERFACE -Werror)
endif()

# Sanitizers have an operator new of their own, which nothing else must replace.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  set(PARDEL_SANITIZED ON)
endif()

# gold, of the same package as the usual linker, links a program in half the time. The tests are hundreds of programs.
# Without gold, or with another linker in the flags, nothing changes. With clang's AddressSanitizer, gold prints
# hundreds of warnings for each program.
if(PROJECT_IS_TOP_LEVEL AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT PARDEL_SANITIZED
   AND NOT "${CMAKE_CXX_FLAGS} ${CMAKE_EXE_LINKER_FLAGS}" MATCHES "-fuse-ld=")
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=gold PARDEL_HAS_GOLD)
  if(PARDEL_HAS_GOLD)
    add_link_options(-fuse-ld=gold)
  endif()
endif()

# pardel_compile_fast(): the sources of this folder and of its subfolders are optimised less. It is for code that takes
# little time when it runs: tests, fuzz targets, the command line. Libraries outside the folder keep the full
# optimisation. In a Release build this shortens the compilation by a quarter; with a sanitizer, code without
# optimisation is compiled three times as fast, so the presets asan and tsan ask for it.
set(PARDEL_FAST_COMPILATION "$<$<CONFIG:Release>:-O1>" CACHE STRING "Options of sources that take little time when they run")
macro(pardel_compile_fast)
  add_compile_options(${PARDEL_FAST_COMPILATION})
endmacro()

# pardel_compile_fast_with_sanitizer(): the same for the folder of an oracle, which is optimised fully elsewhere.
macro(pardel_compile_fast_with_sanitizer)
  if(PARDEL_SANITIZED)
    pardel_compile_fast()
  endif()
endmacro()

# pardel_library(NAME SOURCES...): adds the static library pardel_NAME with the alias pardel::NAME.
function(pardel_library name)
  add_library(pardel_${name} STATIC ${ARGN})
  add_library(pardel::${name} ALIAS pardel_${name})
  set_target_properties(pardel_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(pardel_${name} PUBLIC pardel_settings PRIVATE $<BUILD_INTERFACE:pardel_warnings>)
endfunction()

# Code of the engine, also where other libraries include its headers. Three fields stored as one vector are three fields
# that the next instructions cannot load until all of it has reached the cache: vectors made of straight-line code cost
# refinement a tenth of its time. Where two doubles go together, the code says so (arithmetic/pair.hpp).
function(pardel_compile_as_engine library)
  target_compile_options(${library} PRIVATE $<IF:$<CXX_COMPILER_ID:GNU>,-fno-tree-slp-vectorize,-fno-slp-vectorize>)
endfunction()

# pardel_compile_rooms_together(LIBRARY ROOMS...): these rooms are compiled as one source each. In a Release build the
# others are not: sources compiled together are inlined differently, and the gate (bench/gate) counted 9 % more
# instructions.
function(pardel_compile_rooms_together library)
  list(JOIN ARGN "|" rooms)
  set_target_properties(${library} PROPERTIES UNITY_BUILD_MODE GROUP)
  if(NOT CMAKE_BUILD_TYPE STREQUAL "Release")
    set(rooms "[a-z_]+")
  endif()
  get_target_property(sources ${library} SOURCES)
  foreach(source IN LISTS sources)
    if(source MATCHES "^(${rooms})/[^/]*$")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${CMAKE_MATCH_1})
    endif()
  endforeach()
endfunction()
