# Level 8: the programs. `pointclay` has the subcommands, one file each and one table of them, and links no Qt;
# `pointclay-window`, which it becomes without a subcommand, stands beside it.
function(pointclay_app_target name)
    target_compile_definitions(${name} PRIVATE POINTCLAY_VERSION="${PROJECT_VERSION}")
    if(NOT CMAKE_BUILD_TYPE STREQUAL Debug)
        target_compile_options(${name} PRIVATE -Og) # most of what -O3 compiles are CLI11's inline functions
    endif()
    pointclay_unhurried(${name})
endfunction()

# All but the mains, so that tests can read the tables.
file(GLOB sources CONFIGURE_DEPENDS app/*.cpp app/subcommands/*.cpp app/options/*.cpp)
list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
add_library(pointclay_commands STATIC ${sources})
target_include_directories(pointclay_commands PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(pointclay_commands PUBLIC pointclay_view pointclay_workloads CLI11::CLI11
                                                nlohmann_json::nlohmann_json)
pointclay_app_target(pointclay_commands)
pointclay_heavy(pointclay_commands <CLI/CLI.hpp> <nlohmann/json.hpp>)

add_executable(pointclay app/main.cpp)
target_link_libraries(pointclay PRIVATE pointclay_commands)
pointclay_app_target(pointclay)

add_executable(pointclay-window app/window/main.cpp)
target_link_libraries(pointclay-window PRIVATE pointclay_commands pointclay_ui)
pointclay_app_target(pointclay-window)
