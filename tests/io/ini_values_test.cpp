// Settings files read without Qt: what QSettings writes comes back.
#include "core/io/ini_values.h"

#include "support/registry.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

class IniValuesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatQtWritesComesBack_data();
    void whatQtWritesComesBack();
    void onlyTheKeyOfTheSectionCounts();
    void whatIsMalformedIsReadAsFarAsItGoes();
};

void IniValuesTest::whatQtWritesComesBack_data() {
    QTest::addColumn<QStringList>("values");
    QTest::newRow("numbers and a name") << QStringList{"0 0 0 10 1 0 0 0 35 1 0 0 0 0 0 0 0 my side"};
    QTest::newRow("several") << QStringList{"one", "two words", "3"};
    QTest::newRow("separators") << QStringList{"a,b", "c;d", "e=f", "[view]", "#", "%41"};
    QTest::newRow("quotes") << QStringList{"say \"so\"", "back\\slash", "it's", "\\x41", "\\"};
    QTest::newRow("blanks") << QStringList{" before", "after ", "  ", "in  between", "tab\tline\nend\r"};
    QTest::newRow("other scripts") << QStringList{"Rückseite", "背面", "ёлка 1a", "\u00e9e9"};
    QTest::newRow("control") << QStringList{QString("\x01") + "7", QString("\x1b") + "beef", "x"};
    QTest::newRow("empty among others") << QStringList{"", "a", ""};
}

void IniValuesTest::whatQtWritesComesBack() {
    QFETCH(QStringList, values);
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.conf");
    {
        QSettings store(path, QSettings::IniFormat);
        store.setValue("brush/saved", "something else");
        store.setValue("view/saved", values);
        store.setValue("view/shading", "matcap");
    }
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    const auto read = io::iniValues(text.toStdString(), "view", "saved");
    QVERIFY2(read, text.constData());
    QStringList got;
    for (const std::string& value : *read)
        got << QString::fromStdString(value);
    QVERIFY2(got == values, text.constData());
}

void IniValuesTest::onlyTheKeyOfTheSectionCounts() {
    const char* file =
        "saved=0\n[brush]\nsaved=1\n\n[view]\r\n; saved=2\nunsaved=3\n saved = 4 , 5 \r\n[view2]\nsaved=6";
    QCOMPARE(io::iniValues(file, "view", "saved"), (std::vector<std::string>{"4", "5"}));
    QCOMPARE(io::iniValues(file, "view2", "saved"), std::vector<std::string>{"6"});
    QVERIFY(!io::iniValues(file, "view", "shading"));
    QVERIFY(!io::iniValues(file, "panel", "saved"));
    QVERIFY(!io::iniValues("", "view", "saved"));
}

void IniValuesTest::whatIsMalformedIsReadAsFarAsItGoes() {
    QCOMPARE(io::iniValues("[view]\nsaved=\"open, a", "view", "saved"), std::vector<std::string>{"open, a"});
    for (const char* end : {"\\", "\\x", "\\xffffffffff", "\\777777777777", "\\q", "\"", ",", "\"\\"})
        QVERIFY(io::iniValues(std::string("[view]\nsaved=a") + end, "view", "saved"));
}

static const test::Registered<IniValuesTest> registered;
#include "ini_values_test.moc"
