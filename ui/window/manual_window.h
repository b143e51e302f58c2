// The manual (F1) in a window of its own: the page that the build made, with a field to search it and a button that
// hands it to the browser. Where there is no such page it says so. Interface's thread only.
#pragma once

#include <QDialog>

class QLineEdit;
class QTextBrowser;

namespace ui {

/// Beside the program as it was built, or where it was installed; empty where there is none.
QString manualFile();

class ManualWindow : public QDialog {
    Q_OBJECT
  public:
    explicit ManualWindow(const QString& file, QWidget* parent = nullptr);

  private:
    void findNext();

    QTextBrowser* m_page;
    QLineEdit* m_sought;
};

} // namespace ui
