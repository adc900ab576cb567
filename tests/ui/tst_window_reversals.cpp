// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Mouse strokes as users make them become programs without back-steps, which are read from their text without our
// parser.
#include "core/document/project.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <random>

namespace burin::tst_window_reversals {

using namespace burin::testing;

namespace {

const std::size_t strokeCount = inLongRun<std::size_t>(20, 6);

/// The seed of the random properties, so that the result for a commit is the same wherever it is tested.
std::uint64_t seedOfTheRun() {
    const auto found = QRegularExpression("seed=([0-9]+)").match(qEnvironmentVariable("RC_PARAMS"));
    return found.hasMatch() ? found.captured(1).toULongLong() : std::random_device()();
}

/// A hand with the left button down: positions of the pointer on the stock's top, mm from its middle, and the time to
/// reach each of them, ms.
struct HandMove {
    glm::dvec2 to{0.0};
    int milliseconds = 0; ///< to get there; with the previous position: a stop
};

/// Corners, lasting stops, slow and fast sweeps, and now and then a tremor of a pixel.
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

/// Draws a stroke with real mouse events, at most one every 8 ms, as a mouse reports them.
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

/// A point on a feed move, mm in the program's own frame. An arc has many, a line only its end.
struct Place {
    glm::dvec3 at{0.0};
    double length = 0.0;  ///< mm, of the whole move
    bool endsMove = true; ///< otherwise the point lies within the move
};
using FeedRun = std::vector<Place>;

/// Adds an arc as chords that deviate from it by 0.001 mm and turn by a tenth of a radian at most. @param across  its
/// axis: 0 X, 1 Y, 2 Z
void addArc(FeedRun& run, const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& centre, int across,
            bool clockwise) {
    const int u = (across + 1) % 3, v = (across + 2) % 3;
    const double start = std::atan2(from[v] - centre[v], from[u] - centre[u]);
    double sweep = std::atan2(to[v] - centre[v], to[u] - centre[u]) - start;
    while (clockwise && sweep >= -1e-9) sweep -= 2.0 * M_PI;
    while (!clockwise && sweep <= 1e-9) sweep += 2.0 * M_PI;
    const double radius = std::hypot(from[u] - centre[u], from[v] - centre[v]);
    const double length = std::hypot(radius * sweep, to[across] - from[across]);
    const double most = std::min(0.1, 2.0 * std::acos(std::max(0.0, 1.0 - 0.001 / std::max(radius, 0.001))));
    const int pieces = 1 + static_cast<int>(std::abs(sweep) / most);
    for (int i = 1; i < pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        glm::dvec3 place = glm::mix(from, to, share);
        place[u] = centre[u] + radius * std::cos(start + share * sweep);
        place[v] = centre[v] + radius * std::sin(start + share * sweep);
        run.push_back({place, length, false});
    }
    run.push_back({to, length});
}

/// The feed moves of a program, each with its starting point; one row for each sequence of them between rapids.
std::vector<FeedRun> feedRuns(const QString& text) {
    const QRegularExpression comment(R"(\([^)]*\)|;.*)"), word("([A-Z])\\s*(-?[0-9]*\\.?[0-9]+|-?[0-9]+\\.?)");
    std::vector<FeedRun> runs;
    glm::dvec3 at(0.0);
    int motion = 0, across = 2;
    double unit = 1.0;
    bool inRun = false;
    for (const QString& line : text.split('\n')) {
        glm::dvec3 to = at, centre = at;
        bool ofMachine = false;
        auto words = word.globalMatch(QString(line).remove(comment));
        while (words.hasNext()) {
            const auto one = words.next();
            const char letter = one.captured(1)[0].toLatin1();
            const double value = one.captured(2).toDouble();
            if (letter == 'G' && value == 53.0) ofMachine = true;
            if (letter == 'G' && (value == 20.0 || value == 21.0)) unit = value == 20.0 ? 25.4 : 1.0;
            if (letter == 'G' && value >= 17.0 && value <= 19.0) across = 19 - static_cast<int>(value);
            if (letter == 'G' && value >= 0.0 && value <= 3.0) motion = static_cast<int>(value);
            if (letter >= 'X' && letter <= 'Z') to[letter - 'X'] = value * unit;
            if (letter >= 'I' && letter <= 'K') centre[letter - 'I'] = at[letter - 'I'] + value * unit;
        }
        if (ofMachine || to == at) continue;
        if (motion == 0) {
            inRun = false;
        } else {
            if (!inRun) runs.push_back({{at}});
            inRun = true;
            if (motion == 1)
                runs.back().push_back({to, glm::distance(at, to)});
            else
                addArc(runs.back(), at, to, centre, across, motion == 2);
        }
        at = to;
    }
    return runs;
}

/// Reversals: turns of more than 155 degrees with a leg of less than 0.1 mm.
QStringList backSteps(const std::vector<FeedRun>& runs) {
    QStringList found;
    for (const FeedRun& run : runs)
        for (std::size_t i = 1; i + 1 < run.size(); ++i) {
            const glm::dvec3 in = run[i].at - run[i - 1].at, out = run[i + 1].at - run[i].at;
            const double turn =
                std::acos(glm::clamp(glm::dot(glm::normalize(in), glm::normalize(out)), -1.0, 1.0)) * 180.0 / M_PI;
            if (turn > 155.0 && std::min(run[i].length, run[i + 1].length) < 0.1)
                found.append(QString("X%1 Y%2 Z%3 turns by %4, legs %5 and %6")
                                 .arg(run[i].at.x)
                                 .arg(run[i].at.y)
                                 .arg(run[i].at.z)
                                 .arg(turn)
                                 .arg(run[i].length)
                                 .arg(run[i + 1].length));
        }
    return found;
}

double distanceTo(const glm::dvec3& place, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 along = to - from;
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? glm::clamp(glm::dot(place - from, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(place, from + share * along);
}

/// Whether the tool moved straight down from a point, so that what it cut there is also cut from its next position.
bool isLeftPlumbDown(const std::vector<glm::dvec3>& places, std::size_t place) {
    constexpr double beside = 0.05; // mm
    const glm::dvec3& from = places[place];
    for (std::size_t i = place + 1; i < places.size(); ++i) {
        if (glm::distance(glm::dvec2(from), glm::dvec2(places[i])) > beside) return false;
        if (places[i].z < from.z) return true;
    }
    return false;
}

/// Where the recorded stroke cut, in the frame of the program, without its vertical plunges: the program plunges in its
/// own manner.
std::vector<glm::dvec3> cutsOf(const Take& take, const glm::dvec3& zero) {
    std::vector<glm::dvec3> all, places;
    for (const Sample& sample : take.samples) {
        const bool cuts = std::ranges::any_of(sample.removed, [](const RemovedMaterial& one) { return one.units > 0; });
        if (!cuts || (sample.flags & sampleSpindleOff) != 0) continue;
        all.push_back(sample.proxy.tip - zero);
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        if ((places.empty() || glm::distance(places.back(), all[i]) > 0.2) && !isLeftPlumbDown(all, i))
            places.push_back(all[i]);
    return places;
}

} // namespace

class TestWindowReversals : public QObject {
    Q_OBJECT
private slots:
    void theReaderSeesABackStep();
    BURIN_ONLY_IN_LONG_RUNS void mouseStrokesMakeAProgramThatNeverStepsBack();
};

/// The back-steps that programs once had where the hand stopped, and what is no back-step: a retract, and a sharp turn
/// of long moves.
void TestWindowReversals::theReaderSeesABackStep() {
    const QString head = "G21 (X1 in a comment)\nG0 X-25 Y0 Z5\nG1 Z-1 F300\n";
    const auto faulty = feedRuns(head + "X-23.622 F900\nX-23.657\nX-21.891\nZ5\nG0 X0\n");
    QCOMPARE(faulty.size(), std::size_t{1});
    QCOMPARE(backSteps(faulty).size(), 2);
    const auto sound = feedRuns(head + "X-23.622\nX-24.5\nX-21.891 Y0.1\nG0 Z5\nG1 Z4\n");
    QVERIFY(sound.size() == 2 && backSteps(sound).isEmpty());
    const auto inInches = feedRuns("G20\nG0 X0 Y0\nG1 X1 F30\nX0.998\nX2\n");
    QCOMPARE(backSteps(inInches).size(), 2);
    // A half circle, and a reversal at its end by two hundredths.
    const auto arc = feedRuns("G0 X0 Y0\nG1 X0.5\nG17 G2 X2.5 I1\nG1 X2.5001 Y0.02\nX5 Y-9\n");
    QVERIFY(arc.size() == 1 && arc.front().size() > 30);
    QVERIFY(std::ranges::any_of(arc.front(), [](const Place& one) {
        return glm::distance(one.at, {1.5, 1, 0}) < 0.1;
    }));
    QCOMPARE(backSteps(arc).size(), 2);
}

void TestWindowReversals::mouseStrokesMakeAProgramThatNeverStepsBack() {
    const std::uint64_t seed = seedOfTheRun();
    qInfo() << "seed" << seed;
    std::mt19937_64 random(seed);
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return workbench.mill.active(); }));
    for (std::size_t i = 0; i < strokeCount; ++i) {
        draw(driver, randomStroke(random));
        QVERIFY(driver.waitFor([&] { return workbench.workpiece.strokes().count() == i + 1; }));
    }
    driver.shoot("reversals-strokes");
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
    QVERIFY(driver.step(JobStep::path));
    QVERIFY(driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor(
        [&] { return workbench.path.evaluated() && !workbench.path.outdated() && !workbench.path.busy(); }));
    const double budget = workbench.path.evaluated()->errorBudget;
    const glm::dvec3 zero = workbench.workpiece.milling()->setup.workOffset;
    const QString file = driver.folder().filePath("strokes.burin");
    QVERIFY(saveAs(driver, file));

    const QString copy = driver.folder().filePath("copy.burin"); // the window has the original open
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
            QTRY_VERIFY(workbench.target.target().units == NcUnits::inch);
        }
        QVERIFY(postProgram(driver));
        const QString text = QString::fromStdString(workbench.program.program()->text);
        QVERIFY(text.contains(inch ? "G20" : "G21"));
        const auto runs = feedRuns(text);
        std::ptrdiff_t moves = 0;
        for (const FeedRun& run : runs) moves += std::ranges::count(run.begin() + 1, run.end(), true, &Place::endsMove);
        const QStringList found = backSteps(runs);
        qInfo() << (inch ? "inch:" : "mm:") << runs.size() << "runs," << moves << "feed moves," << found.size()
                << "back-steps, budget" << budget << "mm";
        QVERIFY(moves > static_cast<std::ptrdiff_t>(
                            5 * strokeCount)); // strokes that meet may be one run; that none is missing is asked below
        QVERIFY2(found.isEmpty(), qPrintable(found.mid(0, 5).join("\n")));

        // What was recorded as cut is milled, as accurately as the path's edits state, plus the rounding of the last
        // digit.
        const double rounding = 4.0 * (inch ? 25.4e-4 : 1e-3);
        double farthest = 0.0;
        for (const glm::dvec3& place : cuts) {
            double nearest = 1e9;
            for (const FeedRun& run : runs)
                for (std::size_t i = 1; i < run.size() && nearest > 1e-3; ++i)
                    nearest = std::min(nearest, distanceTo(place, run[i - 1].at, run[i].at));
            farthest = std::max(farthest, nearest);
        }
        qInfo() << "farthest from the hand" << farthest << "mm";
        QVERIFY(farthest <= budget + rounding);
    }
}

BURIN_TEST(TestWindowReversals, QApplication)

} // namespace burin::tst_window_reversals

#include "tst_window_reversals.moc"
