// The program where a comma separates decimals: options, results and files are the same.
#include "support/comma_locale.h"

#include "app/options/number_list.h"
#include "program.h"
#include "support/registry.h"

#include <algorithm>
#include <QTest>

using test::Outcome;
using test::Program;

class CommaLocaleTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void listsOfNumbersAreReadTheSame();
    void subcommandsDoTheSame_data();
    void subcommandsDoTheSame();
};

void CommaLocaleTest::listsOfNumbersAreReadTheSame() {
    const test::CommaLocale comma;
    QVERIFY(comma.works());
    double three[3];
    QVERIFY(app::parseNumbers("1.5, -2e-3,+.25", ',', three));
    QVERIFY(three[0] == 1.5 && three[1] == -2e-3 && three[2] == 0.25);
    for (const char* wrong : {"", "1,2", "1,2,3,4", "1,2,3 ", "1;2;3", "1,,3", "1,2,x", "1,2,3,"})
        QVERIFY2(!app::parseNumbers(wrong, ',', three), wrong);
    int two[2];
    QVERIFY(app::parseNumbers("1280x+720", 'x', two) && two[0] == 1280 && two[1] == 720);
    for (const char* wrong : {"1280", "1280x", "x720", "1280x720x", "1.5x2", "99999999999x1"})
        QVERIFY2(!app::parseNumbers(wrong, 'x', two), wrong);
}

void CommaLocaleTest::subcommandsDoTheSame_data() {
    QTest::addColumn<QString>("arguments");
    const auto row = [](const char* arguments) { QTest::newRow(arguments) << QString(arguments); };
    row("info model.xyz --json");
    row("convert model.xyz out");
    row("query model.xyz --at model.xyz --what value,curvature --support 0.35 -o out");
    row("section sample:sphere:800 --plane 0,1,0,0.25 -o out");
    row("render model.xyz -o out --size 60x40 --eye 0.5,1.25,2.5 --fov 20.5 --clip 0,0,-1,0.25 --section --shading "
        "curvature --range=-0.5,1.5 --scale-bar");
    row("render model.xyz -o out --size 60x40 --ortho 2.5 --mode raycast --material clay --lights 0.5,1,0.25");
    row("render model.xyz -o out --size 60x40 --backend osmesa --effects outline,ambient-occlusion --detail 1.5");
}

void CommaLocaleTest::subcommandsDoTheSame() {
    QFETCH(QString, arguments);
    const test::CommaLocale comma;
    QVERIFY(comma.works());
    const Program program;
    QVERIFY(program.run({"convert", "sample:sphere:800", "model.xyz"}).code == 0);
    const char* extension = arguments.startsWith("render") ? "png" : arguments.startsWith("query") ? "csv" : "obj";
    std::vector<std::string> results;
    for (const char* locale : {"C", "de_DE.UTF-8"}) {
        const QString out = QString("out-%1.%2").arg(results.size()).arg(extension);
        QStringList words = arguments.split(' ', Qt::SkipEmptyParts);
        std::replace(words.begin(), words.end(), QString("out"), out);
        QProcess process;
        program.prepare(process, words);
        QProcessEnvironment environment = process.processEnvironment();
        environment.insert("LOCPATH", comma.folder());
        environment.insert("LC_ALL", locale);
        process.setProcessEnvironment(environment);
        process.start();
        QVERIFY(process.waitForFinished(120000));
        const QByteArray told = process.readAllStandardError();
        if (process.exitCode() == 1 && told.contains("OSMesa"))
            QSKIP(told.constData());
        QVERIFY2(process.exitCode() == 0, told.constData());
        results.push_back(process.readAllStandardOutput().toStdString() + program.read(out.toStdString()));
    }
    QVERIFY(!results[0].empty());
    QVERIFY(results[0] == results[1]);
}

static const test::Registered<CommaLocaleTest> registered;
#include "comma_locale_test.moc"
