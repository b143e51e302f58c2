# Level 7: what draws and what a person touches. The renderers know no widget; the window knows no GL function.
pointclay_room(gl ui/gl render)
pointclay_link(gl ${CMAKE_DL_LIBS})

# The camera as a hand moves it, and views by name; `render --view` needs them without a window.
pointclay_room(view ui/view render)

# Every folder of the window is a room, too, so that they depend on each other in one direction only.
function(pointclay_qt_room name)
    pointclay_room(${name} ${ARGN})
    set(target pointclay_${name})
    # AUTOMOC does not notice a file that the glob has just found unless it depends on its own list of files.
    set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOGEN_ORIGIN_DEPENDS OFF AUTOGEN_TARGET_DEPENDS
        ${CMAKE_BINARY_DIR}/CMakeFiles/${target}_autogen.dir/AutogenInfo.json)
    # Without Qt's keywords: `slots` is a word of the core, too.
    target_compile_definitions(${target} PUBLIC QT_NO_KEYWORDS)
    pointclay_link(${name} Qt6::Widgets Qt6::OpenGLWidgets Qt6::Svg nlohmann_json::nlohmann_json)
    pointclay_unhurried(${target})
    if(name STREQUAL theme)
        pointclay_heavy(${target} <QMainWindow> <QPainter> <nlohmann/json.hpp>)
    else()
        pointclay_heavy_as(${target} pointclay_theme)
    endif()
endfunction()

pointclay_qt_room(theme ui/theme)
# Every language's catalogue is in the program. Qt's tools make it of the text that translators edit.
pointclay_qt_room(words ui/words)
set(words ${CMAKE_BINARY_DIR}/words)
file(CONFIGURE OUTPUT ${words}/words.qrc CONTENT
     "<RCC><qresource prefix=\"/words\"><file>pointclay_de.qm</file></qresource></RCC>\n")
add_custom_command(OUTPUT ${words}/qrc_words.cpp
    COMMAND ${LRELEASE} -silent ${CMAKE_SOURCE_DIR}/ui/words/pointclay_de.ts -qm ${words}/pointclay_de.qm
    COMMAND Qt6::rcc --name words --output ${words}/qrc_words.cpp ${words}/words.qrc
    DEPENDS ${CMAKE_SOURCE_DIR}/ui/words/pointclay_de.ts ${words}/words.qrc VERBATIM)
set_source_files_properties(${words}/qrc_words.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_AUTOGEN ON
    SKIP_PRECOMPILE_HEADERS ON)
target_sources(pointclay_words PRIVATE ${words}/qrc_words.cpp)

pointclay_qt_room(work ui/work session render words)
pointclay_qt_room(settings ui/settings session view)
pointclay_qt_room(overlay ui/overlay sculpt render view theme words)
pointclay_qt_room(panels ui/panels theme settings work)
pointclay_qt_room(viewport ui/viewport gl work)
pointclay_qt_room(interaction ui/interaction settings overlay viewport)
pointclay_qt_room(window ui/window interaction panels)
add_library(pointclay_ui INTERFACE)
target_link_libraries(pointclay_ui INTERFACE pointclay_window)
set_source_files_properties(ui/window/run_window.cpp PROPERTIES COMPILE_DEFINITIONS POINTCLAY_VERSION="${PROJECT_VERSION}")

# Every drawing in icons/ is in the program under its file's name.
file(GLOB icons RELATIVE ${CMAKE_SOURCE_DIR}/icons CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/icons/*.svg)
list(TRANSFORM icons REPLACE "(.+)" "<file alias=\"\\1\">${CMAKE_SOURCE_DIR}/icons/\\1</file>")
list(JOIN icons "\n" icons)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/icons.qrc CONTENT "<RCC><qresource prefix=\"/icons\">\n@icons@\n</qresource></RCC>\n" @ONLY)
set_target_properties(pointclay_theme PROPERTIES AUTORCC ON)
target_sources(pointclay_theme PRIVATE ${CMAKE_BINARY_DIR}/icons.qrc)
