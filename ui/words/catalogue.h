// One language's texts, looked up by what they say rather than by which class asks. Any thread.
#pragma once

#include <mutex>
#include <QHash>
#include <QSet>
#include <QTranslator>

namespace ui {

class Catalogue : public QTranslator {
  public:
    using QTranslator::QTranslator;
    /// Reads pointclay_`language`.qm, which is in the program. False where there is none.
    bool open(const QString& language);
    QString translate(const char* context, const char* source, const char* comment, int n) const override;

    QString englishOf(const QString& shown) const;
    /// Texts that were asked for and are not in it.
    QSet<QString> missing() const;
    /// Of a table's text alone; empty where it is not in it.
    QString find(const char* source, const char* table = "") const;

    /// The one that is installed; null: the window speaks English.
    static const Catalogue* installed();
    ~Catalogue() override;

  private:
    mutable std::mutex m_mutex;
    mutable QHash<QString, QString> m_english; ///< by what is shown, without mnemonics
    mutable QSet<QString> m_missing;
};

} // namespace ui
