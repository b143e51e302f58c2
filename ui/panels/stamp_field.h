// A grey image from a file: its picture, a button to choose another, and one to remove it.
#pragma once

#include <QWidget>
#include <string>

class QLabel;
class QToolButton;

namespace ui {

class StampField : public QWidget {
    Q_OBJECT
  public:
    explicit StampField(QWidget* parent = nullptr);

    const std::string& path() const { return m_path; }
    /// Empty: none. Does not emit.
    void setPath(const std::string& path);
    /// What the person chose; an image that cannot be read is reported in place of its picture, and not taken.
    void choose(const QString& path);

  Q_SIGNALS:
    void edited(); ///< by the person; path() is new

  private:
    void ask();
    bool show(const std::string& path); ///< false where it is not an image
    std::string m_path;
    QLabel *m_picture, *m_name;
    QToolButton* m_clear;
};

} // namespace ui
