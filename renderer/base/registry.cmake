# obscura_registry(TARGET FOLDER TYPE FUNCTION SHADERS): reads FOLDER/list, where a line is a name and
# the other sources (.cpp) and shaders that belong to it. Each FOLDER/NAME.cpp joins TARGET and
# defines `TYPE NAME_FOLDER()`; FUNCTION, which gives all of them in the list's order, is written
# here. The shaders are appended to the list that SHADERS names.
function(obscura_registry target folder type function shaders)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
        "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/list")
    file(STRINGS "${folder}/list" lines)
    set(declarations "")
    set(calls "")
    foreach(line IN LISTS lines)
        if(line MATCHES "^#")
            continue()
        endif()
        separate_arguments(words UNIX_COMMAND "${line}")
        list(POP_FRONT words name)
        string(APPEND declarations "${type} ${name}_${folder}();\n")
        string(APPEND calls "        ${name}_${folder}(),\n")
        target_sources(${target} PRIVATE "${folder}/${name}.cpp")
        list(TRANSFORM words PREPEND "${folder}/")
        set(sources ${words})
        list(FILTER sources INCLUDE REGEX "\\.cpp$")
        target_sources(${target} PRIVATE ${sources})
        # Each speaks of its own parts in the same words, so they are not compiled as one unit.
        set_source_files_properties("${folder}/${name}.cpp" ${sources} PROPERTIES
            SKIP_UNITY_BUILD_INCLUSION ON)
        list(FILTER words EXCLUDE REGEX "\\.cpp$")
        list(APPEND ${shaders} ${words})
    endforeach()
    set(output "${CMAKE_CURRENT_BINARY_DIR}/${folder}_list.cpp")
    file(CONFIGURE OUTPUT "${output}" CONTENT "// Written by renderer/base/registry.cmake.
#include \"renderer/${folder}/${folder}.h\"

namespace obscura::renderer {

${declarations}
const std::vector<${type}>& ${function}() {
    static const std::vector<${type}> list = {
${calls}    };
    return list;
}

}  // namespace obscura::renderer
" @ONLY)
    target_sources(${target} PRIVATE "${output}")
    set(${shaders} "${${shaders}}" PARENT_SCOPE)
endfunction()
