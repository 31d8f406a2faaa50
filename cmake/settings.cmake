# What every target of the project is compiled with. Exact predicates rest on two of these: no contraction
# of a*b+c into one rounding, and no relaxed floating point.
find_package(OpenMP REQUIRED COMPONENTS CXX)

add_library(pardel_settings INTERFACE)
target_compile_features(pardel_settings INTERFACE cxx_std_20)
target_compile_options(pardel_settings INTERFACE -ffp-contract=off)

add_library(pardel_warnings INTERFACE)
target_compile_options(pardel_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
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
