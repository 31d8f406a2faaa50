# cmake -DBUILD= -DPREFIX= -P build_tree.cmake: the folder of the build tree BUILD for #include <pardel/...> has the
# same headers as the installation in PREFIX.
file(GLOB_RECURSE offered RELATIVE ${BUILD}/include ${BUILD}/include/*)
file(GLOB_RECURSE installed RELATIVE ${PREFIX}/include ${PREFIX}/include/*)
list(SORT offered)
list(SORT installed)
if(NOT offered STREQUAL installed)
  message(FATAL_ERROR "the build tree offers\n${offered}\nthe installation has\n${installed}")
endif()
