# Level 8: the programs. `pointclay` has the subcommands, one file each and one table of them, and links no Qt;
# `pointclay-window`, which it becomes without a subcommand, stands beside it.
function(pointclay_app_target name)
    target_compile_definitions(${name} PRIVATE POINTCLAY_VERSION="${PROJECT_VERSION}")
    if(NOT CMAKE_BUILD_TYPE STREQUAL Debug)
        target_compile_options(${name} PRIVATE -Og) # nothing here is hot
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
pointclay_heavy(pointclay_commands <nlohmann/json.hpp>)

add_executable(pointclay app/main.cpp)
target_link_libraries(pointclay PRIVATE pointclay_commands)
pointclay_app_target(pointclay)

add_executable(pointclay-window app/window/main.cpp)
target_link_libraries(pointclay-window PRIVATE pointclay_commands pointclay_ui)
pointclay_app_target(pointclay-window)

# What `cmake --install` puts in its place: both programs side by side, and what a desktop has to know of them.
add_executable(pointclay_desktop_files app/desktop/main.cpp)
target_link_libraries(pointclay_desktop_files PRIVATE pointclay_commands)
pointclay_app_target(pointclay_desktop_files)
set(desktop ${CMAKE_BINARY_DIR}/desktop)
set(desktop_files ${desktop}/pointclay.desktop ${desktop}/pointclay.xml ${desktop}/pointclay.1 ${desktop}/pointclay.bash)
add_custom_command(OUTPUT ${desktop_files} COMMAND pointclay_desktop_files ${desktop} VERBATIM)
add_custom_target(desktop ALL DEPENDS ${desktop_files})
include(GNUInstallDirs)
install(TARGETS pointclay pointclay-window)
install(FILES ${desktop}/pointclay.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/pointclay.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${desktop}/pointclay.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${desktop}/pointclay.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME pointclay)
install(FILES icons/pointclay.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
