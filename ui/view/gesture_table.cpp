#include "ui/view/gesture_table.h"

namespace ui {

std::span<const GestureRow> gestureTable() {
    static const GestureRow table[] = {
        {"Left button on the model", "Sculpt with the chosen tool; pen pressure counts"},
        {"Shift + left button", "Smooth"},
        {"Ctrl + left button, eraser of a pen", "Invert the tool"},
        {"Left button beside the model", "Turn the view"},
        {"Right button, Alt + left button", "Turn the view, on the model too"},
        {"Double-click with these",
         "Turn about that point of the surface; beside the model, about the middle of the view"},
        {"Middle button", "Pan the view"},
        {"Wheel", "Zoom towards the pointer"},
        {"W A S D, Q E, Shift, wheel", "While flying: move, down and up, faster, set the speed; Esc lands"},
        {"Hold F and move, or type a number", "Brush radius"},
        {"Hold Shift+F and move, or type a number", "Tool strength"},
        {"Ctrl + click with Clone", "Choose where to copy from"},
        {"Select and Measure bars (B, Shift+M)",
         "While a button of theirs is down the left button picks; Shift adds, Ctrl subtracts, Esc goes back to "
         "sculpting"},
        {"Click a number", "Type a value; drag to change it, with Shift in fine steps"},
        {"Esc", "Take back the stroke in progress; stop long work"},
    };
    return table;
}

} // namespace ui
