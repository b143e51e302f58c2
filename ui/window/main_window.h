// The main window: viewport in the centre, tools left, properties right, menus above, figures below. It assembles and
// connects; what things do is elsewhere (editor.h, sculpt_view.h, menus.h, file_actions.h). Interface's thread only.
#pragma once

#include "ui/interaction/sculpt_view.h"
#include "ui/settings/settings_file.h"
#include "ui/window/file_actions.h"
#include "ui/window/floating_bars.h"
#include "ui/window/image_export.h"

#include <QMainWindow>

namespace ui {

class HeaderBar;
class Measurer;
class Notices;
class MeshExport;
class PropertiesPanel;
class StatusLine;
class Thumbnails;
class ToolBar;
class WorkProgress;

struct WindowOptions {
    QString settingsFile; ///< empty: the person's own
    QString pictures;     ///< folder for those of recent files; empty: the person's own
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
    SculptView& sculptView() { return *m_view; }
    FileActions& files() { return *m_files; }
    ImageExport& images() { return *m_images; }
    StatusLine& statusLine() { return *m_status; }
    const ToolBar& toolBar() const { return *m_tools; }
    PropertiesPanel& panel() { return *m_panel; }
    Measurer& measurer() { return *m_measurer; }
    MeshExport& meshExport() { return *m_mesh; }
    FloatingBars& bars() { return *m_bars; }
    const Thumbnails& thumbnails() const { return *m_thumbnails; }
    /// By its object name (menus.h).
    QMenu* menu(const QString& name) const;
    /// One sentence about the choice of the renderer.
    const QString& whyRenderer() const { return m_whyRenderer; }

    void undo(); ///< a stroke in progress goes first
    void redo();
    /// So many steps forward, or back where negative.
    void go(int steps);
    /// Drops what the pointer is doing; where that is nothing, stops long work.
    void escape();
    /// In the status line.
    void tell(const QString& message);
    void tellFailure(const QString& message);
    /// Opens a model in a window of its own; empty: there is only this one.
    std::function<void(const std::filesystem::path&)> openAnother;
    /// What the shading shows, where it measures.
    void measure();
    /// As if chosen in the menu.
    void showShading(render::Shading shading);
    /// In the status line: what the pointer does now.
    void showHint();
    /// The same of what else has the pointer, until the next.
    void showHint(const QString& what);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void buildViewport();
    void showTitle();
    void suitTool(const QString& tool);
    void buildStatus();
    void buildTools();
    void buildPanel();
    void buildMenus();
    void buildHeader();
    void connectWork();
    void showSnapshot();
    void suitShading();
    void keepSettings();
    QSize fitting(const QSize& wanted) const;

    SettingsFile m_settingsFile;
    Settings m_settings;
    Editor* m_editor = nullptr;
    Measurer* m_measurer = nullptr;
    MeshExport* m_mesh = nullptr;
    FloatingBars* m_bars = nullptr;
    Viewport* m_viewport = nullptr;
    SculptView* m_view = nullptr;
    FileActions* m_files = nullptr;
    ImageExport* m_images = nullptr;
    ToolBar* m_tools = nullptr;
    HeaderBar* m_header = nullptr;
    PropertiesPanel* m_panel = nullptr;
    StatusLine* m_status = nullptr;
    WorkProgress* m_progress = nullptr;
    Notices* m_notices = nullptr;
    Thumbnails* m_thumbnails = nullptr;
    QString m_whyRenderer;
    std::uint64_t m_models = 0; ///< of the snapshot that the panel's ranges suit
    std::uint32_t m_model = 0;  ///< of its scene: sizes were chosen for it
    bool m_mayClose = false;
};

} // namespace ui
