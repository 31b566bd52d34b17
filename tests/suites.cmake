# obscura_tests(NAME source... LIBRARIES target...): one program of many test suites, labelled NAME
# (unit, gpu, kiosk or store). ctest runs a suite at a time: starting the program costs more than
# most tests do. Another test holds the suites that ctest knows against those of the program, so
# that none is left out.
function(obscura_tests name)
    cmake_parse_arguments(PARSE_ARGV 1 test "" "" "LIBRARIES")
    set(program tests_${name})
    add_executable(${program} ${test_UNPARSED_ARGUMENTS})
    # All read TOML, or say so: what is compiled alike shares a precompiled header. The kiosk's tests
    # have threads among their options, by the libraries of its window.
    target_link_libraries(${program} PRIVATE ${test_LIBRARIES} tomlplusplus::tomlplusplus
        GTest::gmock GTest::gtest_main)
    target_compile_definitions(${program} PRIVATE
        OBSCURA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        OBSCURA_PROGRAM="$<TARGET_FILE:obscura_program>")
    # Some tests start the program itself. Their own code runs once, so that optimising it takes
    # longer than it saves; but for loops over all of a scene's triangles, which say so.
    add_dependencies(${program} obscura_program)
    target_compile_options(${program} PRIVATE $<$<CONFIG:Release>:-O0>)
    if(OBSCURA_SANITIZE)
        target_sources(${program} PRIVATE support/sanitizers.cpp)
    endif()

    obscura_unity(${program})
    if(OBSCURA_UNITY AND name MATCHES "gpu|store")
        target_precompile_headers(${program} REUSE_FROM tests_unit)
    elseif(OBSCURA_UNITY)
        target_precompile_headers(${program} PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
    endif()

    set(suites)
    foreach(source IN LISTS test_UNPARSED_ARGUMENTS)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
        file(STRINGS ${source} tests REGEX "^TEST(_F|_P)?\\(")
        list(TRANSFORM tests REPLACE "^TEST(_F|_P)?\\(([A-Za-z0-9_]+).*$" "\\2")
        list(APPEND suites ${tests})
    endforeach()
    list(REMOVE_DUPLICATES suites)
    foreach(suite IN LISTS suites)
        add_test(NAME ${suite} COMMAND ${program} "--gtest_filter=${suite}.*:*/${suite}.*")
        # What is slow begins early, so that nothing is left to wait for alone.
        set(cost 0)
        if(name STREQUAL "kiosk")
            set(cost 2)
        elseif(name STREQUAL "gpu")
            set(cost 1)
        endif()
        set_tests_properties(${suite} PROPERTIES LABELS ${name} COST ${cost})
    endforeach()
    add_test(NAME "${program} has no other suites"
        COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:${program}>" "-DSUITES=${suites}"
            -P "${CMAKE_CURRENT_SOURCE_DIR}/compare_suites.cmake")
    set_tests_properties("${program} has no other suites" PROPERTIES LABELS ${name})
endfunction()
