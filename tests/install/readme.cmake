# cmake -DREADME= -DEXAMPLE= -P readme.cmake: the README shows the file EXAMPLE unchanged, which a test builds and runs.
file(READ ${README} readme)
file(READ ${EXAMPLE} example)
string(FIND "${readme}" "```cpp\n${example}```" place)
if(place EQUAL -1)
  message(FATAL_ERROR "${README} does not show ${EXAMPLE} unchanged")
endif()
