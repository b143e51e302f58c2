// A letter for every entry of every menu, so that Alt and a few keys reach all of them, in any language.
#pragma once

class QMenuBar;

namespace ui {

/// Entries keep the letter that their text has chosen unless another one before them has it; the others get one, of a
/// word's beginning where that is free. Letters of the bar leave alone what is an action's key with Alt.
void giveLetters(QMenuBar& bar);

} // namespace ui
