# The C++ of the technique that renderer/README.md shows, for the test that builds it; written again
# whenever the page changes.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/renderer/README.md)
file(READ ${PROJECT_SOURCE_DIR}/renderer/README.md page)
string(FIND "${page}" "`technique/cross.cpp`:\n```cpp\n" begin)
if(begin EQUAL -1)
    message(FATAL_ERROR "renderer/README.md shows no technique/cross.cpp")
endif()
string(SUBSTRING "${page}" ${begin} -1 page)
string(REGEX REPLACE "^`technique/cross.cpp`:\n```cpp\n" "" page "${page}")
string(FIND "${page}" "```" end)
string(SUBSTRING "${page}" 0 ${end} page)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/cross.cpp CONTENT "${page}" @ONLY)
