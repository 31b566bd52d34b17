# obscura_fuzz(NAME source... LIBRARIES library... SECONDS number): a libFuzzer program of those sources, named from
# the top of the project, under the address and undefined-behaviour sanitizers. Its test, labelled
# unit, begins with the files in tests/fuzz/corpus/NAME and goes on for that time; what makes it fail
# lies in the build folder as crash-*. Clang compiles it, since GCC has no fuzzer, and the sources
# again with it; everything else, also what they need of LIBRARIES (targets of the project that are
# archives, or the linker's words), stays with the project's compiler.
find_program(OBSCURA_CLANG NAMES clang++ clang++-14 REQUIRED)

function(obscura_fuzz name)
    # GCC's sanitizers in the archives and Clang's do not go into one program.
    if(OBSCURA_SANITIZE)
        return()
    endif()
    cmake_parse_arguments(PARSE_ARGV 1 fuzz "" "SECONDS" "LIBRARIES")
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name}.fuzz)
    file(MAKE_DIRECTORY ${folder}/found)
    set(flags -std=c++20 -O1 -g -DSPDLOG_FMT_EXTERNAL
        -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all
        # SOCI and others export no type information of their classes, which this would need.
        -fno-sanitize=vptr)
    set(objects)
    foreach(source IN LISTS fuzz_UNPARSED_ARGUMENTS)
        string(MAKE_C_IDENTIFIER ${source} object)
        set(object ${folder}/${object}.o)
        add_custom_command(OUTPUT ${object}
            COMMAND ${OBSCURA_CLANG} ${flags} -I${PROJECT_SOURCE_DIR} -MD -MF ${object}.d
                -c ${PROJECT_SOURCE_DIR}/${source} -o ${object}
            DEPENDS ${PROJECT_SOURCE_DIR}/${source}
            DEPFILE ${object}.d
            COMMENT "Compiling ${source} for ${name}"
            VERBATIM)
        list(APPEND objects ${object})
    endforeach()
    set(libraries)
    set(archives)
    foreach(library IN LISTS fuzz_LIBRARIES)
        if(TARGET ${library})
            list(APPEND libraries $<TARGET_FILE:${library}>)
            list(APPEND archives ${library} $<TARGET_FILE:${library}>)
        else()
            list(APPEND libraries ${library})
        endif()
    endforeach()
    add_custom_command(OUTPUT ${folder}/${name}
        COMMAND ${OBSCURA_CLANG} ${flags} ${objects} -o ${folder}/${name} ${libraries}
        DEPENDS ${objects} ${archives}
        COMMENT "Linking ${name}"
        VERBATIM)
    add_custom_target(${name} ALL DEPENDS ${folder}/${name})
    add_test(NAME ${name}
        COMMAND ${folder}/${name} -max_total_time=${fuzz_SECONDS} -timeout=10 -rss_limit_mb=2048
            -artifact_prefix=${folder}/ ${folder}/found
            ${PROJECT_SOURCE_DIR}/tests/fuzz/corpus/${name})
    set_tests_properties(${name} PROPERTIES LABELS unit TIMEOUT 300)
endfunction()
