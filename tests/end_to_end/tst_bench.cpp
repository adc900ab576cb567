// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/benchmarks/scale/exponent.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QTest>

#include <cmath>
#include <csignal>
#include <iterator>
#include <map>

namespace burin::tst_bench {

/// The structure of the output of `burin bench`; its numbers are not tested.
class BenchTest : public QObject {
    Q_OBJECT
private slots:
    void listsWhatThereIs();
    void printsFiguresWithTheirPeers();
    void printsATableForPeople();
    void exponentsOfKnownCosts();
    void scaleTellsCostsAtThreeSizesAndHowTheyGrow();
    void roundsAddNoFigures();
    void refusesWhatItDoesNotKnow();
    void stopsWhenAsked();

private:
    static QJsonArray listOf(const ProgramRun& run) { return QJsonDocument::fromJson(run.output).array(); }
    static QJsonObject named(const QJsonArray& figures, const QString& name) {
        for (const QJsonValue& figure : figures)
            if (figure["name"].toString() == name) return figure.toObject();
        return {};
    }
};

void BenchTest::listsWhatThereIs() {
    const ProgramRun run = runBurin({"bench", "--json"});
    QCOMPARE(run.status, 0);
    QVERIFY2(named(listOf(run), "volume")["built"].toBool(), run.output.constData());
    const ProgramRun text = runBurin({"bench"});
    QCOMPARE(text.status, 0);
    QVERIFY(text.output.startsWith("volume  "));
}

void BenchTest::printsFiguresWithTheirPeers() {
    const ProgramRun run = runBurin({"bench", "volume", "--json", "--only", "cut.paper_case"});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QJsonArray figures = listOf(run);
    for (const char* radius : {"r0_5", "r5"}) {
        const QString stem = QStringLiteral("cut.paper_case.%1.").arg(QLatin1String(radius));
        const QJsonObject median = named(figures, stem + "p50");
        QVERIFY(median["value"].toDouble() > 0.0);
        QCOMPARE(median["unit"].toString(), QString("us"));
        QCOMPARE(median["peer"].toString(), QString("paper's way"));
        QVERIFY(median["peer_value"].toDouble() > 0.0);
        QCOMPARE(median["ratio"].toDouble(), median["peer_value"].toDouble() / median["value"].toDouble());
        QVERIFY(named(figures, stem + "p999")["value"].toDouble() >= median["value"].toDouble());
    }
    // The removed voxels were counted correctly, whichever groups were requested.
    for (const char* name : {"recount.mismatches", "tick.allocations", "tick.page_faults"}) {
        const QJsonObject figure = named(figures, name);
        QVERIFY2(figure["limit"].isDouble() && figure["value"].isDouble(), name);
        QCOMPARE(figure["limit"].toDouble(), 0.0);
    }
    QCOMPARE(named(figures, "recount.mismatches")["value"].toDouble(), 0.0);
    QSet<QString> names;
    for (const QJsonValue& figure : figures) names.insert(figure["name"].toString());
    QCOMPARE(names.size(), figures.size());
}

void BenchTest::printsATableForPeople() {
    const ProgramRun run = runBurin({"bench", "volume", "--only", "cut.paper_case.r5"});
    QCOMPARE(run.status, 0);
    const QList<QByteArray> lines = run.output.trimmed().split('\n');
    QVERIFY(lines.first().startsWith("figure "));
    QVERIFY2(lines.last().contains(" figures, "), lines.last().constData());
    for (const QByteArray& line : lines) QVERIFY(!line.contains("r0_5"));
}

void BenchTest::exponentsOfKnownCosts() {
    using burin::benchmarks::exponentBetween;
    QCOMPARE(exponentBetween(1000.0, 0.5, 4000.0, 2.0), 1.0);                    // four times as large in both
    QCOMPARE(exponentBetween(10.0, 3.0, 1000.0, 3.0), 0.0);                      // at no additional cost
    QCOMPARE(exponentBetween(8.0, 1.0, 64.0, 64.0), 2.0);                        // each with each of the others
    QVERIFY(std::abs(exponentBetween(8.0, 1.0, 64.0, 4.0) - 2.0 / 3.0) < 1e-12); // the surface of a cube
}

void BenchTest::scaleTellsCostsAtThreeSizesAndHowTheyGrow() {
    const ProgramRun run = runBurin({"bench", "scale", "--json", "--only", "scale.blocks.read"});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QJsonArray figures = listOf(run);
    const QString stem = QStringLiteral("scale.blocks.read.");
    std::map<double, double> cost; // s, by number of blocks
    for (const QJsonValue& figure : figures) {
        const QString name = figure["name"].toString();
        if (!name.endsWith(QStringLiteral(".cpu"))) continue;
        QCOMPARE(figure["unit"].toString(), QString("s"));
        const QString size = name.chopped(4).mid(stem.size());
        cost[size.toDouble()] = figure["value"].toDouble();
        const QJsonObject peak = named(figures, stem + size + QStringLiteral(".peak"));
        QCOMPARE(peak["unit"].toString(), QString("MB"));
        QVERIFY(peak["value"].isDouble());
    }
    QCOMPARE(cost.size(), std::size_t{3});
    const auto small = cost.begin(), middle = std::next(small), large = std::next(middle);
    QVERIFY(small->first > 1000.0 && small->second > 0.0);
    const auto grown = [](auto from, auto to) { // (log c2 - log c1) / (log n2 - log n1)
        return (std::log(to->second) - std::log(from->second)) / (std::log(to->first) - std::log(from->first));
    };
    const auto close = [&](const QString& name, double expected) {
        return std::abs(named(figures, stem + name)["value"].toDouble() - expected) < 1e-6;
    };
    QVERIFY(close("exponent", grown(small, large)));
    QVERIFY(close("exponent.lower", grown(small, middle)));
    QVERIFY(close("exponent.upper", grown(middle, large)));
    QCOMPARE(named(figures, stem + "exponent")["limit"].toDouble(), 1.2);
}

void BenchTest::roundsAddNoFigures() {
    QSet<QString> names;
    for (const char* rounds : {"1", "2"}) {
        const ProgramRun run = runBurin({"bench", "volume", "--json", "--only", "snapshot", "--rounds", rounds});
        QVERIFY2(run.status == 0, run.messages.constData());
        const QJsonArray figures = listOf(run);
        QCOMPARE(figures.size(), 2);
        for (const QJsonValue& figure : figures) names.insert(figure["name"].toString());
    }
    QCOMPARE(names, (QSet<QString>{"snapshot.us", "snapshot.first_touch_us"}));
    const ProgramRun none = runBurin({"bench", "volume", "--rounds", "0"});
    QCOMPARE(none.status, 2);
    QVERIFY2(none.messages.contains("--rounds"), none.messages.constData());
}

void BenchTest::refusesWhatItDoesNotKnow() {
    const ProgramRun run = runBurin({"bench", "lathe"});
    QCOMPARE(run.status, 2);
    QVERIFY2(run.messages.contains("lathe") && run.messages.contains("volume"), run.messages.constData());
}

void BenchTest::stopsWhenAsked() {
    QProcess process;
    process.start(burinProgram(), {"bench", "volume", "--only", "cut.raster"});
    QVERIFY(process.waitForStarted());
    QTest::qWait(1500);
    QCOMPARE(process.state(), QProcess::Running);
    ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitCode(), 5);
}

BURIN_TEST(BenchTest, QCoreApplication)

} // namespace burin::tst_bench

#include "tst_bench.moc"
