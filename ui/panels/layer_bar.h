// The bar of layers: which of them strokes act on, how much of it is shown, and whether it is; adding, merging, moving,
// renaming, removing. It shows a list (layers/stack.h) and asks for commands; it changes nothing itself.
#pragma once

#include "core/layers/stack.h"

#include <nlohmann/json_fwd.hpp>
#include <QToolBar>

class QComboBox;
class QTimer;
class QToolButton;

namespace ui {

class FoldingRows;
class NumberSlider;

class LayerBar : public QToolBar {
    Q_OBJECT
  public:
    explicit LayerBar(QWidget* parent = nullptr);
    /// Of the picture that it floats over.
    void fitInto(int width);
    /// The layers as they are now. Does not emit.
    void display(const layers::Stack& stack);

  Q_SIGNALS:
    void wanted(const nlohmann::json& command);
    void nameWanted(const QString& now); ///< the person wants to rename the active layer

  private:
    void addList();
    void addStrength();
    QToolButton* addButton(const char* action, const QString& label, const QString& tip);
    void ask(const char* action);
    void askStrength();
    void fillList(const layers::Stack& stack);

    layers::Stack m_stack;
    FoldingRows* m_lines;
    QComboBox* m_list;
    NumberSlider* m_strength;
    QToolButton* m_shown;
    std::vector<QToolButton*> m_ofLayer; ///< of use where a layer is active
    QTimer* m_rest;                      ///< a slider that moves asks once, when it rests
    std::uint32_t m_moved = 0;           ///< id of the layer that it was moved for
    double m_wish = 1;                   ///< where to
};

} // namespace ui
