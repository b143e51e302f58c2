// What an exported image is to be: size, background, outlines, splats or the true surface.
#pragma once

#include <QDialog>
#include <QSize>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace ui {

struct ImageChoice {
    QSize size;
    bool transparent = false;
    bool smooth = true;   ///< four pixels make one
    bool rayCast = false; ///< the true surface, every pixel
    bool operator==(const ImageChoice&) const = default;
};

class ImageDialog : public QDialog {
    Q_OBJECT
  public:
    static constexpr int largest = 32767; ///< pixels a side

    /// `view`: the size of the viewport in device pixels; sizes keep its shape unless told otherwise.
    explicit ImageDialog(const ImageChoice& choice, QSize view, QWidget* parent = nullptr);
    ImageChoice choice() const;

  private:
    void widthEdited(int width);
    void heightEdited(int height);

    QSize m_view;
    QSpinBox *m_width, *m_height;
    QCheckBox *m_keepShape, *m_transparent, *m_smooth;
    QComboBox* m_how;
};

} // namespace ui
