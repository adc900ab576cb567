// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Mouse strokes as hands make them, to a program without back-steps; read from its text without our parser.
#include "core/project/project.h"
#include "tests/ui/window_steps.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <random>

using namespace burin;
using namespace burin::testing;

namespace {

constexpr std::size_t strokeCount = 20;

/// The seed of the random properties, so that one commit's verdict is the same wherever it is tested.
std::uint64_t seedOfTheRun() {
    const auto found = QRegularExpression("seed=([0-9]+)").match(qEnvironmentVariable("RC_PARAMS"));
    return found.hasMatch() ? found.captured(1).toULongLong() : std::random_device()();
}

/// A hand with the left button down: places of the pointer on the stock's top, mm from its middle, and how long each of
/// them takes to reach, ms.
struct HandMove {
    glm::dvec2 to{0.0};
    int milliseconds = 0; ///< to get there; with the place of before: a stop
};

/// Corners, stops that last, sweeps that are fast and slow, and now and then a tremor of a pixel.
std::vector<HandMove> randomStroke(std::mt19937_64& random) {
    std::uniform_real_distribution<double> one(0.0, 1.0);
    const auto place = [&] { return glm::dvec2(36.0 * one(random) - 18.0, 26.0 * one(random) - 13.0); };
    std::vector<HandMove> moves{{place(), 0}};
    const int legs = 2 + static_cast<int>(3.0 * one(random));
    for (int leg = 0; leg < legs; ++leg) {
        glm::dvec2 to = place();
        while (glm::distance(to, moves.back().to) < 6.0) to = place();
        const double speed = 20.0 * std::pow(15.0, one(random)); // mm/s
        const glm::dvec2 from = moves.back().to;
        const double length = glm::distance(from, to);
        const bool stops = one(random) < 0.5;
        const double share = stops ? 0.2 + 0.6 * one(random) : 1.0;
        moves.push_back({glm::mix(from, to, share), static_cast<int>(1000.0 * share * length / speed)});
        if (!stops) continue;
        moves.push_back({moves.back().to, 60 + static_cast<int>(200.0 * one(random))});
        moves.push_back({to, static_cast<int>(1000.0 * (1.0 - share) * length / speed)});
    }
    return moves;
}

/// Draws a stroke with real mouse events, one every 8 ms at most, as a mouse reports.
void draw(WindowDriver& driver, const std::vector<HandMove>& moves) {
    Viewport& viewport = driver.window().viewport();
    const glm::dvec3 zero = driver.window().workbench().setup.setup().workOffset;
    const auto at = [&](const glm::dvec2& place) { return viewport.project(zero + glm::dvec3(place, 0.0)).toPoint(); };
    QTest::mouseMove(&viewport, at(moves.front().to));
    QTest::qWait(120);
    QTest::mousePress(&viewport, Qt::LeftButton, Qt::NoModifier, at(moves.front().to));
    for (std::size_t i = 1; i < moves.size(); ++i) {
        QElapsedTimer clock;
        clock.start();
        for (double share = 0.0; share < 1.0;) {
            QTest::qWait(8);
            share = std::min(1.0, static_cast<double>(clock.elapsed()) / std::max(1, moves[i].milliseconds));
            QTest::mouseMove(&viewport, at(glm::mix(moves[i - 1].to, moves[i].to, share)));
        }
    }
    QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::NoModifier, at(moves.back().to));
}

/// The feed moves of a program of lines, each with where it begins, in mm of its own frame; a row for each run of them
/// between rapids. Nothing where a block is not understood.
std::optional<std::vector<std::vector<glm::dvec3>>> feedRuns(const QString& text) {
    const QRegularExpression comment(R"(\([^)]*\)|;.*)"), word("([A-Z])\\s*(-?[0-9]*\\.?[0-9]+|-?[0-9]+\\.?)");
    std::vector<std::vector<glm::dvec3>> runs;
    glm::dvec3 at(0.0);
    int motion = 0;
    double unit = 1.0;
    bool inRun = false;
    for (const QString& line : text.split('\n')) {
        glm::dvec3 to = at;
        bool ofMachine = false;
        auto words = word.globalMatch(QString(line).remove(comment));
        while (words.hasNext()) {
            const auto one = words.next();
            const char letter = one.captured(1)[0].toLatin1();
            const double value = one.captured(2).toDouble();
            if (letter == 'G' && value == 53.0) ofMachine = true;
            if (letter == 'G' && (value == 20.0 || value == 21.0)) unit = value == 20.0 ? 25.4 : 1.0;
            if (letter == 'G' && (value == 2.0 || value == 3.0)) return std::nullopt; // no edit here makes arcs
            if (letter == 'G' && (value == 0.0 || value == 1.0)) motion = static_cast<int>(value);
            if (letter >= 'X' && letter <= 'Z') to[letter - 'X'] = value * unit;
        }
        if (ofMachine || to == at) continue;
        if (motion == 0) {
            inRun = false;
        } else {
            if (!inRun) runs.push_back({at});
            inRun = true;
            runs.back().push_back(to);
        }
        at = to;
    }
    return runs;
}

/// Turns of more than 155 degrees with a leg of less than 0.1 mm.
QStringList backSteps(const std::vector<std::vector<glm::dvec3>>& runs) {
    QStringList found;
    for (const std::vector<glm::dvec3>& run : runs)
        for (std::size_t i = 1; i + 1 < run.size(); ++i) {
            const glm::dvec3 in = run[i] - run[i - 1], out = run[i + 1] - run[i];
            const double turn =
                std::acos(glm::clamp(glm::dot(glm::normalize(in), glm::normalize(out)), -1.0, 1.0)) * 180.0 / M_PI;
            if (turn > 155.0 && std::min(glm::length(in), glm::length(out)) < 0.1)
                found.append(QString("X%1 Y%2 Z%3 turns by %4, legs %5 and %6")
                                 .arg(run[i].x)
                                 .arg(run[i].y)
                                 .arg(run[i].z)
                                 .arg(turn)
                                 .arg(glm::length(in))
                                 .arg(glm::length(out)));
        }
    return found;
}

double distanceTo(const glm::dvec3& place, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 along = to - from;
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? glm::clamp(glm::dot(place - from, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(place, from + share * along);
}

/// Where the hand cut, in the frame of the program.
std::vector<glm::dvec3> cutsOf(const Take& take, const glm::dvec3& zero) {
    std::vector<glm::dvec3> places;
    for (const Sample& sample : take.samples) {
        const bool cuts = std::ranges::any_of(sample.removed, [](const RemovedMaterial& one) { return one.units > 0; });
        if (!cuts || (sample.flags & sampleSpindleOff) != 0) continue;
        const glm::dvec3 place = sample.proxy.tip - zero;
        if (places.empty() || glm::distance(places.back(), place) > 0.2) places.push_back(place);
    }
    return places;
}

} // namespace

class TestWindowReversals : public QObject {
    Q_OBJECT
private slots:
    void theReaderSeesABackStep();
    void mouseStrokesMakeAProgramThatNeverStepsBack();
};

/// What a program once had where the hand stopped, and what is no back-step: a retract, and a sharp turn of long moves.
void TestWindowReversals::theReaderSeesABackStep() {
    const QString head = "G21 (X1 in a comment)\nG0 X-25 Y0 Z5\nG1 Z-1 F300\n";
    const auto faulty = feedRuns(head + "X-23.622 F900\nX-23.657\nX-21.891\nZ5\nG0 X0\n");
    QVERIFY(faulty && faulty->size() == 1);
    QCOMPARE(backSteps(*faulty).size(), 2);
    const auto sound = feedRuns(head + "X-23.622\nX-24.5\nX-21.891 Y0.1\nG0 Z5\nG1 Z4\n");
    QVERIFY(sound && sound->size() == 2 && backSteps(*sound).isEmpty());
    const auto inInches = feedRuns("G20\nG0 X0 Y0\nG1 X1 F30\nX0.998\nX2\n");
    QVERIFY(inInches && backSteps(*inInches).size() == 2);
    QVERIFY(!feedRuns("G2 X1 I1"));
}

void TestWindowReversals::mouseStrokesMakeAProgramThatNeverStepsBack() {
    const std::uint64_t seed = seedOfTheRun();
    qInfo() << "seed" << seed;
    std::mt19937_64 random(seed);
    WindowDriver driver;
    Workbench& bench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return bench.mill.active(); }, 5000));
    for (std::size_t i = 0; i < strokeCount; ++i) {
        draw(driver, randomStroke(random));
        QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == i + 1; }, 10000));
    }
    driver.shoot("reversals-strokes");
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !bench.session.running(); }, 5000));
    QVERIFY(driver.step(JobStep::path));
    QVERIFY(driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return bench.path.evaluated() && !bench.path.outdated() && !bench.path.busy(); }));
    const double budget = bench.path.evaluated()->errorBudget;
    const glm::dvec3 zero = bench.bench.bench()->setup.workOffset;
    const QString file = driver.folder().filePath("strokes.burin");
    QVERIFY(saveAs(driver, file));

    const QString copy = driver.folder().filePath("copy.burin"); // the window has the other one open
    QVERIFY(QFile::copy(file, copy));
    const Result<Project> project = Project::open(copy.toStdString());
    QVERIFY(project);
    const auto takes = project->takes();
    QVERIFY(takes && takes->size() == 1);
    const Result<Take> take = project->take(takes->front().id);
    QVERIFY(take);
    const std::vector<glm::dvec3> cuts = cutsOf(*take, zero);
    QVERIFY(cuts.size() > 50 * strokeCount);

    for (const bool inch : {false, true}) {
        QVERIFY(driver.step(JobStep::program));
        if (inch) {
            auto* units = driver.visible<QComboBox>("programUnits");
            QVERIFY(units != nullptr);
            units->setFocus();
            QTest::keyClick(units, Qt::Key_Down);
            QTRY_VERIFY(bench.target.target().units == NcUnits::inch);
        }
        QVERIFY(postProgram(driver));
        const QString text = QString::fromStdString(bench.program.program()->text);
        QVERIFY(text.contains(inch ? "G20" : "G21"));
        const auto runs = feedRuns(text);
        QVERIFY(runs);
        std::size_t moves = 0;
        for (const auto& run : *runs) moves += run.size() - 1;
        const QStringList found = backSteps(*runs);
        qInfo() << (inch ? "inch:" : "mm:") << runs->size() << "runs," << moves << "feed moves," << found.size()
                << "back-steps, budget" << budget << "mm";
        QVERIFY(moves > 10 * strokeCount); // strokes that meet may be one run; that none is missing is asked below
        QVERIFY2(found.isEmpty(), qPrintable(found.mid(0, 5).join("\n")));

        // What the hand cut is milled, as near as the path's edits say; the last digit's rounding comes on top.
        const double rounding = 4.0 * (inch ? 25.4e-4 : 1e-3);
        double farthest = 0.0;
        for (const glm::dvec3& place : cuts) {
            double nearest = 1e9;
            for (const auto& run : *runs)
                for (std::size_t i = 1; i < run.size() && nearest > 1e-3; ++i)
                    nearest = std::min(nearest, distanceTo(place, run[i - 1], run[i]));
            farthest = std::max(farthest, nearest);
        }
        qInfo() << "farthest from the hand" << farthest << "mm";
        QVERIFY(farthest <= budget + rounding);
    }
}

QTEST_MAIN(TestWindowReversals)
#include "tst_window_reversals.moc"
