# Level 7: what draws and what a person touches. The renderers know no widget; the window knows no GL function.
pointclay_room(gl ui/gl render)
pointclay_link(gl ${CMAKE_DL_LIBS})

pointclay_room(ui ui session gl)
pointclay_link(ui Qt6::Widgets Qt6::OpenGLWidgets Qt6::Svg nlohmann_json::nlohmann_json)
# AUTOMOC does not notice a file that the glob has just found unless it depends on its own list of files.
set_target_properties(pointclay_ui PROPERTIES AUTOMOC ON AUTORCC ON AUTOGEN_TARGET_DEPENDS
    ${CMAKE_BINARY_DIR}/CMakeFiles/pointclay_ui_autogen.dir/AutogenInfo.json)
pointclay_unhurried(pointclay_ui)
pointclay_heavy(pointclay_ui <QMainWindow> <QPainter> <nlohmann/json.hpp>)
target_sources(pointclay_ui PRIVATE ${CMAKE_SOURCE_DIR}/icons/icons.qrc)
# Without Qt's keywords: `slots` is a word of the core, too.
target_compile_definitions(pointclay_ui PUBLIC QT_NO_KEYWORDS PRIVATE POINTCLAY_VERSION="${PROJECT_VERSION}")
