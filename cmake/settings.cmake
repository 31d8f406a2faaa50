# What every target of the project is compiled with. Exact predicates rest on two of these: no contraction
# of a*b+c into one rounding, and no relaxed floating point.
find_package(OpenMP REQUIRED COMPONENTS CXX)

# Everyone may include a public header as <pardel/core/pslg.hpp>, from the build tree as from an installation.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include)
file(CREATE_LINK ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/include/pardel SYMBOLIC)

add_library(pardel_settings INTERFACE)
set_target_properties(pardel_settings PROPERTIES EXPORT_NAME settings)
target_compile_features(pardel_settings INTERFACE cxx_std_20)
# The predicates are inline, so whoever includes them is compiled without contraction too.
target_compile_options(pardel_settings INTERFACE -ffp-contract=off)
target_include_directories(pardel_settings SYSTEM INTERFACE $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                                                            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

add_library(pardel_warnings INTERFACE)
target_compile_options(pardel_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
# g++ 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(pardel_warnings INTERFACE -Wno-restrict)
endif()
if(PARDEL_WERROR)
  target_compile_options(pardel_warnings INTERFACE -Werror)
endif()

# pardel_library(NAME SOURCES...): a library pardel_NAME with the alias pardel::NAME.
function(pardel_library name)
  add_library(pardel_${name} STATIC ${ARGN})
  add_library(pardel::${name} ALIAS pardel_${name})
  set_target_properties(pardel_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(pardel_${name} PUBLIC pardel_settings PRIVATE $<BUILD_INTERFACE:pardel_warnings>)
endfunction()
