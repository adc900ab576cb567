// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/end_to_end/program_run.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace burin::tst_several_tools {

class TestSeveralTools : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void largerToolsComeFirst();
    void theProgramIsVerifiedWithEachOfItsTools();
    void inchesSayTheSame();
    void aControlWithoutToolChangeRefuses();

private:
    QString inFolder(const char* name) const { return folder_.filePath(name); }
    QTemporaryDir folder_;
    QString project_;
};

void TestSeveralTools::initTestCase() {
    project_ = inFolder("two.burin");
    QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", project_, "--voxel", "0.5", "--margin", "4",
                       "--material", "machinable-wax"})
                 .status,
             0);
    for (const char* tool : {"ball-3", "flat-10"})
        QCOMPARE(runBurin({"mill", project_, "--tool", tool, "--seconds", "6"}).status, 0);
    const QJsonArray takes = runBurin({"info", project_, "--json"}).json()["takes"].toArray();
    QVERIFY(takes.size() >= 2);
    QMap<QString, QStringList> byTool;
    for (const auto& take : takes)
        byTool[take.toObject()["tool"].toString()].append(QString::number(take.toObject()["id"].toInteger()));
    QCOMPARE(byTool.keys(), (QStringList{"ball-3", "flat-10"}));
    // Posting creates the path of the other tool.
    QCOMPARE(runBurin({"path", project_, "new", "--takes", byTool["ball-3"].join(',')}).status, 0);
    const ProgramRun mixed =
        runBurin({"path", project_, "new", "--takes", byTool["ball-3"].front() + "," + byTool["flat-10"].front()});
    QVERIFY2(mixed.status == 2 && mixed.messages.contains("ball-3"), mixed.messages.constData());
}

void TestSeveralTools::largerToolsComeFirst() {
    const QString program = inFolder("two.ngc");
    const ProgramRun run = runBurin({"post", project_, "-o", program, "--json"});
    QVERIFY2(run.status == 0, run.messages + run.output);
    const QJsonArray tools = run.json()["tools"].toArray();
    QCOMPARE(tools.size(), 2);
    QStringList changes;
    auto match = QRegularExpression("^T(\\d+) M6", QRegularExpression::MultilineOption).globalMatch(contentOf(program));
    while (match.hasNext()) changes.append(match.next().captured(1));
    QStringList bySize; // by the numbers that the tools state
    for (const char* id : {"flat-10", "ball-3"})
        for (const auto& tool : tools)
            if (tool.toObject()["id"].toString() == id)
                bySize.append(QString::number(tool.toObject()["number"].toInt()));
    QCOMPARE(changes, bySize);
}

void TestSeveralTools::theProgramIsVerifiedWithEachOfItsTools() {
    const QString program = inFolder("two.ngc");
    const ProgramRun run = runBurin({"verify", program, "--project", project_, "--json"});
    QVERIFY2(run.status == 0, run.messages + run.output);
    // A program with an unknown tool cannot be checked.
    QFile strange(inFolder("strange.ngc"));
    QVERIFY(strange.open(QIODevice::WriteOnly));
    QString text = contentOf(program);
    text.replace(QRegularExpression("^T\\d+ M6(?![\\s\\S]*^T\\d+ M6)", QRegularExpression::MultilineOption), "T77 M6");
    strange.write(text.toUtf8());
    strange.close();
    const ProgramRun refused = runBurin({"verify", strange.fileName(), "--project", project_});
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.output.contains("tool_unknown 77"), refused.output.constData());
    // Nor if that is its only tool: it is unknown which of the project's tools it would be.
    text.replace(QRegularExpression("^T\\d+ M6", QRegularExpression::MultilineOption), "T77 M6");
    QFile alone(inFolder("alone.ngc"));
    QVERIFY(alone.open(QIODevice::WriteOnly));
    alone.write(text.toUtf8());
    alone.close();
    const ProgramRun unknown = runBurin({"verify", alone.fileName(), "--project", project_});
    QVERIFY2(unknown.status == 1 && unknown.output.contains("tool_unknown 77"), unknown.output.constData());
    const ProgramRun meant = runBurin({"verify", alone.fileName(), "--project", project_, "--tool", "ball-3"});
    QVERIFY(!meant.output.contains("tool_unknown"));
}

void TestSeveralTools::inchesSayTheSame() {
    const QString metric = inFolder("two.ngc"), inch = inFolder("inch.ngc");
    const ProgramRun posted = runBurin({"post", project_, "-o", inch, "--path", "1,2", "--units", "inch", "--json"});
    QVERIFY2(posted.status == 0, posted.messages + posted.output);
    QVERIFY(contentOf(inch).contains("G20") && !contentOf(inch).contains("G21"));
    QVERIFY(contentOf(metric).contains("G21"));
    const auto judged = [&](const QString& program) {
        return runBurin({"verify", program, "--project", project_, "--json"}).json();
    };
    const QJsonObject one = judged(metric), other = judged(inch);
    QVERIFY(other["passed"].toBool());
    // Four decimals of an inch are 0.00254 mm.
    const double removed = one["removed_mm3"].toDouble();
    QVERIFY2(std::abs(other["removed_mm3"].toDouble() - removed) < 0.003 * removed,
             qPrintable(QString::number(other["removed_mm3"].toDouble() - removed)));
}

void TestSeveralTools::aControlWithoutToolChangeRefuses() {
    const QString program = inFolder("two.nc");
    const ProgramRun run = runBurin({"post", project_, "-o", program, "--path", "1,2", "--machine", "grbl-router"});
    QVERIFY2(run.status != 0 && run.messages.count('\n') == 1, run.messages.constData());
    QVERIFY(!QFile::exists(program));
}

BURIN_TEST(TestSeveralTools, QCoreApplication)

} // namespace burin::tst_several_tools

#include "tst_several_tools.moc"
