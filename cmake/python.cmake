# Finds what the Python package needs (bindings/python).
option(PARDEL_BUILD_PYTHON "Build the Python package" OFF)
option(PARDEL_TEST_PYTHON "Test the Python package, also without PARDEL_BUILD_TESTS" OFF)
if(NOT PARDEL_BUILD_PYTHON)
  return()
endif()

# Debian's packages of Python are for its own interpreter, which need not be the first one on the path.
if(NOT Python_EXECUTABLE AND NOT DEFINED ENV{VIRTUAL_ENV} AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 CONFIG REQUIRED)
