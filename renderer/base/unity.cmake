# obscura_unity(TARGET): where CMAKE_UNITY_BUILD is on, the sources of TARGET that lie in one folder
# are compiled some at a time, as one unit: what they read and instantiate in common is done once.
# Names in their unnamed namespaces must differ within a folder.
function(obscura_unity target)
    set(at_a_time 6)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        get_filename_component(folder "${source}" DIRECTORY)
        string(MAKE_C_IDENTIFIER "${folder}" folder)
        if(NOT DEFINED count_${folder})
            set(count_${folder} 0)
        endif()
        math(EXPR unit "${count_${folder}} / ${at_a_time}")
        math(EXPR count_${folder} "${count_${folder}} + 1")
        set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}_${unit}")
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
