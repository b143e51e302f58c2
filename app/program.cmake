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
file(GLOB sources CONFIGURE_DEPENDS app/*.cpp app/subcommands/*.cpp app/options/*.cpp app/desktop/*.cpp)
list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
add_library(pointclay_commands STATIC ${sources})
target_include_directories(pointclay_commands PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(pointclay_commands PUBLIC pointclay_view pointclay_workloads CLI11::CLI11
                                                nlohmann_json::nlohmann_json)
pointclay_app_target(pointclay_commands)
pointclay_batches(pointclay_commands)
pointclay_heavy(pointclay_commands <nlohmann/json.hpp>)

add_executable(pointclay app/main.cpp)
target_link_libraries(pointclay PRIVATE pointclay_commands)
pointclay_app_target(pointclay)

add_executable(pointclay-window app/window/main.cpp)
target_link_libraries(pointclay-window PRIVATE pointclay_commands pointclay_ui)
pointclay_app_target(pointclay-window)

# What `cmake --install` puts in its place: both programs side by side, what a desktop has to know of them, and the manual,
# whose pictures only the optimised program draws.
add_executable(pointclay_desktop_files app/desktop/main.cpp)
target_link_libraries(pointclay_desktop_files PRIVATE pointclay_commands)
pointclay_app_target(pointclay_desktop_files)
set(desktop ${CMAKE_BINARY_DIR}/desktop)
set(desktop_files pointclay.desktop pointclay.xml pointclay.thumbnailer pointclay.metainfo.xml pointclay.1 pointclay.bash
    manual.html)
list(TRANSFORM desktop_files PREPEND ${desktop}/)
set(drawn_by $<$<CONFIG:Release>:$<TARGET_FILE:pointclay>>)
add_custom_command(OUTPUT ${desktop_files} COMMAND pointclay_desktop_files ${desktop} ${drawn_by}
                   DEPENDS ${drawn_by} VERBATIM COMMAND_EXPAND_LISTS)
add_custom_target(desktop ALL DEPENDS ${desktop_files})
include(GNUInstallDirs)
install(TARGETS pointclay pointclay-window)
install(FILES ${desktop}/pointclay.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/pointclay.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${desktop}/pointclay.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers)
install(FILES ${desktop}/pointclay.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(DIRECTORY ${desktop}/ DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.html" PATTERN "*.png")
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${desktop}/pointclay.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${desktop}/pointclay.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME pointclay)
install(FILES icons/pointclay.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)

# A Debian package of the same: run `cpack` in the build's folder.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pointclay)
set(CPACK_PACKAGE_CONTACT "The authors of Pointclay <pointclay@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # needs dpkg-dev, which g++ brings
# Loaded when wanted, so that no library names them.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "qt6-qpa-plugins, libxcb-cursor0, fonts-dejavu-core")
# The last one has the words of Qt's own dialogs.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libosmesa6, libgl1-mesa-dri, qt6-translations-l10n")
include(CPack)
