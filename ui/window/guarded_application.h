// The application that outlives what its events throw: a person who runs out of memory reads a message and can save,
// instead of losing the window. What cannot be outlived ends in one sentence and exit code 1, never in an abort; the
// journal then holds what was done. Interface's thread only.
#pragma once

#include <QApplication>

namespace ui {

class GuardedApplication : public QApplication {
  public:
    /// REQUIRES: `argc` outlives it.
    GuardedApplication(int& argc, char** argv) : QApplication(argc, argv) {}
    bool notify(QObject* receiver, QEvent* event) override;

  private:
    void tell(const QString& trouble);
    bool m_telling = false; ///< what the message itself causes is not told
};

/// To be called before there is an application: Qt's own last words (a missing plugin, no more memory) and exceptions
/// that nobody catches become a sentence on stderr.
void installLastWords();

} // namespace ui
