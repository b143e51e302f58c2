// The process in a locale with a decimal comma, for as long as this lives: de_DE, made by localedef, since machines
// that build have no such locale.
#pragma once

#include <clocale>
#include <cstdlib>
#include <QLocale>
#include <QProcess>
#include <QTemporaryDir>
#include <string>

namespace test {

class CommaLocale {
  public:
    CommaLocale() : m_before(std::setlocale(LC_ALL, nullptr)), m_default(QLocale()) {
        qputenv("LOCPATH", folder().toUtf8());
        m_set = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    }
    ~CommaLocale() {
        std::setlocale(LC_ALL, m_before.c_str());
        QLocale::setDefault(m_default);
        qunsetenv("LOCPATH");
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

    /// To be asserted: the locale was made and is in force.
    bool works() const { return m_set && std::string(std::localeconv()->decimal_point) == ","; }
    /// Where it lies, for a program's LOCPATH.
    static QString folder() {
        static const QTemporaryDir made; // once in a process: it takes a second
        static const int failed =
            QProcess::execute("localedef", {"-i", "de_DE", "-f", "UTF-8", made.filePath("de_DE.UTF-8")});
        return failed ? QString() : made.path();
    }

  private:
    std::string m_before;
    QLocale m_default;
    bool m_set = false;
};

} // namespace test
