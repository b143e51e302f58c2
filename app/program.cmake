# Level 8: the program. One file per subcommand, one table of them.
file(GLOB sources CONFIGURE_DEPENDS app/*.cpp)
if(sources)
    add_executable(pointclay ${sources})
    target_compile_definitions(pointclay PRIVATE POINTCLAY_VERSION="${PROJECT_VERSION}")
    target_include_directories(pointclay PRIVATE ${CMAKE_SOURCE_DIR})
    target_link_libraries(pointclay PRIVATE pointclay_ui pointclay_workloads Qt6::Widgets CLI11::CLI11 nlohmann_json::nlohmann_json)
    if(NOT CMAKE_BUILD_TYPE STREQUAL Debug)
        target_compile_options(pointclay PRIVATE -Og) # most of what -O3 compiles are CLI11's inline functions
    endif()
    pointclay_unhurried(pointclay)
    pointclay_heavy(pointclay <CLI/CLI.hpp> <nlohmann/json.hpp>)
endif()
