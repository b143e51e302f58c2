# Level 8: the program. One file per subcommand, one table of them.
file(GLOB sources CONFIGURE_DEPENDS app/*.cpp)
if(sources)
    add_executable(pointclay ${sources})
    target_compile_definitions(pointclay PRIVATE POINTCLAY_VERSION="${PROJECT_VERSION}")
    target_include_directories(pointclay PRIVATE ${CMAKE_SOURCE_DIR})
    target_link_libraries(pointclay PRIVATE pointclay_ui pointclay_workloads Qt6::Widgets CLI11::CLI11 nlohmann_json::nlohmann_json)
    pointclay_unhurried(pointclay)
endif()
