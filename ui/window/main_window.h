// The main window: viewport in the centre, tools left, properties right, menus above, figures below. It assembles and
// connects; what things do is elsewhere (editor.h, view_controller.h, file_actions.h).
#pragma once

#include "ui/viewport/view_controller.h"
#include "ui/window/file_actions.h"
#include "ui/window/settings.h"
#include "ui/work/editor.h"

#include <memory>
#include <QElapsedTimer>
#include <QMainWindow>
#include <QSettings>

namespace ui {

class CutBar;
class Measurer;
class MeshExport;
class PropertiesPanel;
class StatusLine;
class ToolBar;
class TruthBar;

struct WindowOptions {
    QString settingsFile; ///< empty: the person's own
    EditorOptions editor;
};

class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    explicit MainWindow(const WindowOptions& options = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    Editor& editor() { return *m_editor; }
    Settings& settings() { return m_settings; }
    Viewport& viewport() { return *m_viewport; }
    ViewController& controller() { return *m_controller; }
    FileActions& files() { return *m_files; }
    StatusLine& statusLine() { return *m_status; }
    const ToolBar& toolBar() const { return *m_tools; }
    PropertiesPanel& panel() { return *m_panel; }
    Measurer& measurer() { return *m_measurer; }
    MeshExport& meshExport() { return *m_mesh; }
    /// Menu of that object name: "file", "new", "recent", "edit", "brush", "model", "view", "navigation",
    /// "saved-views", "help".
    QMenu* menu(const QString& name) const;

    void undo();
    void redo();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void buildViewport();
    void buildBars();
    void buildFileMenu();
    void buildEditMenu();
    void buildBrushMenu();
    void buildModelMenu();
    void buildViewMenu();
    void buildLookMenus(QMenu& view);
    void buildSwitches(QMenu& view);
    void buildNavigation(QMenu& view);
    void buildClipping(QMenu& view);
    void buildTrueSurface(QMenu& view);
    void showSavedViews();
    void saveView();
    void buildHelpMenu();
    void buildCorner();
    QMenu* addMenu(const QString& name, const QString& title, QMenu* parent = nullptr);
    QAction* addAction(QMenu& menu, const char* icon, const QString& text, const QKeySequence& shortcut,
                       const std::function<void()>& work);
    void connectEditor();
    void showSnapshot();
    void showProgress(double share, const QString& doing);
    void showRecent();
    void settingsEdited();
    bool working() const; ///< on something that tells its progress
    void measure();       ///< what the shading shows, where it measures
    void escape();
    void ask(const session::CommandRow& row);
    void about();

    std::unique_ptr<QSettings> m_store;
    Settings m_settings;
    Editor* m_editor = nullptr;
    Measurer* m_measurer = nullptr;
    MeshExport* m_mesh = nullptr;
    Viewport* m_viewport = nullptr;
    ViewController* m_controller = nullptr;
    FileActions* m_files = nullptr;
    ToolBar* m_tools = nullptr;
    PropertiesPanel* m_panel = nullptr;
    StatusLine* m_status = nullptr;
    CutBar* m_cutBar = nullptr;
    QAction *m_undo = nullptr, *m_redo = nullptr, *m_frame = nullptr;
    QString m_whyRenderer;
    QElapsedTimer m_working; ///< since the work whose progress is reported began
    std::uint64_t m_models = 0;
    bool m_mayClose = false;
};

} // namespace ui
