# One interface target carries the warnings, so that no flag is global and system headers stay out of it.
add_library(udcp_warnings INTERFACE)
target_compile_options(udcp_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms of gcc 12 inside std::string's operator+ under -O3 (GCC bug 105651).
  target_compile_options(udcp_warnings INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
endif()
if(UDCP_WERROR)
  target_compile_options(udcp_warnings INTERFACE -Werror)
endif()

# udcp_library(NAME LIBRARIES a b SOURCES x.cpp y.cpp): a static library of one folder; includes are written from the root.
function(udcp_library name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;SOURCES" ${ARGN})
  add_library(udcp_${name} STATIC ${ARG_SOURCES})
  target_include_directories(udcp_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(udcp_${name} PUBLIC ${ARG_LIBRARIES} PRIVATE $<BUILD_INTERFACE:udcp_warnings>)
endfunction()
