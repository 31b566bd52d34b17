# obscura_fuzz(NAME TARGET SECONDS): any bytes for the function in tests/fuzz/NAME.cpp, which has the
# library TARGET read them. The test, labelled unit, begins with the files in tests/fuzz/corpus/NAME.
#
# Usually these are read whole, cut, and changed at random but always the same (smoke_main.cpp). In
# the preset `fuzz` all is built by Clang, since GCC has no fuzzer, and libFuzzer goes on for SECONDS;
# what makes it fail lies in the build folder as NAME-crash-*.
function(obscura_fuzz name target seconds)
    set(corpus ${PROJECT_SOURCE_DIR}/tests/fuzz/corpus/${name})
    add_executable(${name} fuzz/${name}.cpp)
    target_link_libraries(${name} PRIVATE ${target})
    if(OBSCURA_FUZZ)
        set(found ${CMAKE_CURRENT_BINARY_DIR}/${name}.found)
        file(MAKE_DIRECTORY ${found})
        target_link_options(${name} PRIVATE -fsanitize=fuzzer)
        add_test(NAME ${name}
            COMMAND ${name} -max_total_time=${seconds} -timeout=10 -rss_limit_mb=2048
                -artifact_prefix=${CMAKE_CURRENT_BINARY_DIR}/${name}- ${found} ${corpus})
    else()
        target_sources(${name} PRIVATE fuzz/smoke_main.cpp)
        add_test(NAME ${name} COMMAND ${name} ${corpus} 2000)
    endif()
    set_tests_properties(${name} PROPERTIES LABELS unit TIMEOUT 300)
endfunction()
