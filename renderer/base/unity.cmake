# obscura_unity(TARGET): where OBSCURA_UNITY is on, the sources of TARGET that lie in one folder are
# compiled some at a time, as one unit: what they read and instantiate in common is done once. Names
# in the unnamed namespaces of a folder should differ; a source that SKIP_UNITY_BUILD_INCLUSION is
# set for stays alone.
function(obscura_unity target)
    set(at_a_time 32)
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
    set_target_properties(${target} PROPERTIES
        UNITY_BUILD ${OBSCURA_UNITY} UNITY_BUILD_MODE GROUP)
endfunction()

# obscura_seldom_hot(TARGET): waits for people, files or the GPU, and compiles half as long for
# being a little slower.
function(obscura_seldom_hot target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)
endfunction()
