# obscura_embed(TARGET NAMESPACE FILE...): compiles the files' bytes into TARGET. A file is known by
# its path relative to the calling CMakeLists.txt. TARGET then defines, in NAMESPACE:
#
#   std::string_view embedded(std::string_view name);      the bytes; data() is null for no such file
#   std::vector<std::string_view> embedded_names();        every name, in the order given
#
# The folder that calls it declares both in a header of its own. The same file, run as a script,
# writes the source; it runs again whenever one of the files changes.

set(OBSCURA_EMBED_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")

function(obscura_embed target namespace)
    set(output "${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded.cpp")
    list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE paths)
    add_custom_command(
        OUTPUT "${output}"
        COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DNAMESPACE=${namespace}"
                "-DFOLDER=${CMAKE_CURRENT_SOURCE_DIR}" "-DFILES=${ARGN}"
                -P "${OBSCURA_EMBED_SCRIPT}"
        DEPENDS ${paths} "${OBSCURA_EMBED_SCRIPT}"
        COMMENT "Embedding the files of ${target}"
        VERBATIM)
    target_sources(${target} PRIVATE "${output}")
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    return()
endif()

set(arrays "")
set(entries "")
set(index 0)
foreach(file IN LISTS FILES)
    file(READ "${FOLDER}/${file}" bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    # The last byte closes the array, so that an empty file is one too; it is not part of the view.
    string(APPEND arrays "constexpr unsigned char kFile${index}[] = {${bytes}0x00};\n")
    string(APPEND entries "    {\"${file}\", view_of(kFile${index})},\n")
    math(EXPR index "${index} + 1")
endforeach()

file(WRITE "${OUTPUT}" "// Written by renderer/base/embed.cmake.
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace ${NAMESPACE} {
namespace {

${arrays}
template <std::size_t kSize>
std::string_view view_of(const unsigned char (&bytes)[kSize]) {
    return {reinterpret_cast<const char*>(bytes), kSize - 1};
}

const std::pair<std::string_view, std::string_view> kFiles[] = {
${entries}};

}  // namespace

std::string_view embedded(std::string_view name) {
    for (const auto& [file, bytes] : kFiles) {
        if (file == name) return bytes;
    }
    return {};
}

std::vector<std::string_view> embedded_names() {
    std::vector<std::string_view> names;
    for (const auto& file : kFiles) names.push_back(file.first);
    return names;
}

}  // namespace ${NAMESPACE}
")
