# A small test takes a second of its own to compile after five for the headers that it includes. So the tests of a room are
# compiled several to a translation unit, eight of which take a third of the time; each file inside a namespace of
# its own, where its helpers meet no others. `-DPOINTCLAY_TOGETHER=0` is for who works on one file again and again.

# together TARGET: what its tests include is included before the first namespace opens, so that it stays outside.
function(pointclay_together target)
    if(NOT POINTCLAY_TOGETHER)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    set(includes "")
    foreach(source ${sources})
        file(STRINGS ${source} found REGEX "^#include .*[.>\"]" ENCODING UTF-8)
        list(FILTER found EXCLUDE REGEX "[.]moc\"")
        # What Qt declares for a type stands outside of all namespaces, and so does the function that support/registry.cpp
        # calls.
        file(STRINGS ${source} outside REGEX "^Q_DECLARE_METATYPE|^QCoreApplication[*] makeApplication" LIMIT_COUNT 1)
        if(outside)
            set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        endif()
        # What stands beside a test is named without its folder.
        get_filename_component(folder ${source} DIRECTORY)
        foreach(line ${found})
            string(REGEX REPLACE "^#include \"([^/\"]+)\".*" "\\1" beside "${line}")
            if(EXISTS ${folder}/${beside})
                file(RELATIVE_PATH beside ${CMAKE_SOURCE_DIR}/tests ${folder}/${beside})
                set(line "#include \"${beside}\"")
            endif()
            list(APPEND includes "${line}")
        endforeach()
    endforeach()
    list(REMOVE_DUPLICATES includes)
    list(JOIN includes "\n" includes)
    set(header ${CMAKE_CURRENT_BINARY_DIR}/${target}_includes.h)
    file(CONFIGURE OUTPUT ${header} CONTENT "#pragma once\n@includes@\n" @ONLY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources})
    set_target_properties(${target} PROPERTIES
        UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${POINTCLAY_TOGETHER} UNITY_BUILD_UNIQUE_ID POINTCLAY_UNIT
        UNITY_BUILD_CODE_BEFORE_INCLUDE "#include \"${header}\"\nnamespace POINTCLAY_UNIT {"
        UNITY_BUILD_CODE_AFTER_INCLUDE "}")
endfunction()
