// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "canonical_moves.h"
#include "plate_with_holes.h"
#include "program_run.h"

#include "core/base/units.h"
#include "core/tool/tool.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

namespace burin::tst_threads {

using namespace burin::test;

namespace {

constexpr double pitch = 1.25; // mm, M8

} // namespace

/// Threads in holes of a part made with OpenCASCADE. Oracles: the helix by its formula, and LinuxCNC's interpreter for
/// the program.
class ThreadsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY(writePlate(in("plate.brep").toStdString(),
                           {{10.0, 10.0, 8.0, -1.0, 13.0},  // M8, drawn at the major diameter
                            {70.0, 10.0, 8.0, 2.0, 13.0},   // the same, blind
                            {40.0, 10.0, 6.8, -1.0, 13.0},  // drawn as a core hole
                            {40.0, 40.0, 8.0, -1.0, 13.0}}, // M8 again, not drilled
                           {}));
        QCOMPARE(run({"embed", in("plate.brep"), "-o", in("p.burin"), "--voxel", "0.5", "--margin", "1"}).status, 0);
    }

    /// Without a hole in the stock nothing is milled; the sentence says what to do.
    void aHoleIsDrilledFirst() {
        const ProgramRun early =
            runBurin({"path", in("p.burin"), "new", "--pass", "thread", "--tool", "thread-mill-m8", "--thread", "M8"});
        QVERIFY(early.status != 0);
        QVERIFY2(early.messages.contains("drill them first"), early.messages.constData());
        const ProgramRun drilled = run({"path", in("p.burin"), "new", "--pass", "drill", "--tool", "drill-6.8",
                                        "--hole", at(10.0, 10.0), "--hole", at(70.0, 10.0), "--bottom",
                                        QString::number(corner().z - 4.0)}); // also through the stock below
        QVERIFY2(drilled.status == 0, drilled.messages.constData());
    }

    /// Two of three holes are drilled and get their thread, the third is reported. The program passes its check, and
    /// LinuxCNC makes a helix of it: right-handed, anticlockwise, from the bottom up, at a quarter of the feed.
    void aThreadIsAHelix() {
        const ProgramRun made =
            run({"path", in("p.burin"), "new", "--pass", "thread", "--tool", "thread-mill-m8", "--thread", "M8"});
        QVERIFY2(made.status == 0, made.messages.constData());
        QCOMPARE(made.json()["strokes"].toInt(), 2);
        QCOMPARE(made.json()["unreached_holes"].toInt(), 1);
        const ProgramRun post = run({"post", in("p.burin"), "-o", in("p.ngc"), "--dialect", "linuxcnc"});
        QVERIFY2(post.status == 0, (post.messages + post.output).constData());
        QVERIFY(post.json()["passed"].toBool());
        const QString text = contentOf(in("p.ngc"));
        static const QRegularExpression helicalArc("G3[^\n]*Z[^\n]*I");
        QVERIFY2(text.contains(helicalArc), "helical arcs");
        const auto moves = canonicalMoves(in("p.ngc"), folder_.path(), toolsOf(post.json()));
        QVERIFY(moves);
        const Tool mill = *loadTool("thread-mill-m8");
        const double radius = 4.0 - mill.cutter.radius(), tooth = 0.5 * mill.cutter.fluteLength;
        const glm::dvec3 move = zeroOf(post.json()) - corner();
        double turned = 0.0, first = 0.0, lowest = 1e9, highest = -1e9, ofHelix = 0.0, fastest = 0.0;
        int points = 0;
        for (std::size_t i = 1; i < moves->size(); ++i) {
            const glm::dvec3 from = (*moves)[i - 1].to + move, to = (*moves)[i].to + move;
            const glm::dvec2 axis(10.0, 10.0), before = glm::dvec2(from) - axis, place = glm::dvec2(to) - axis;
            if (!(*moves)[i].rapid) fastest = std::max(fastest, (*moves)[i].feed); // up along the axis, in air
            if ((*moves)[i].rapid || glm::length(place) > 5.0 || glm::length(before) > 5.0) continue;
            QVERIFY2(glm::length(place) < radius + 0.005, qPrintable(QString::number(glm::length(place), 'f', 4)));
            if (glm::length(before) < 0.01 || glm::length(place) < 0.01) continue; // from the axis and back to it
            const double angle = std::atan2(before.x * place.y - before.y * place.x, glm::dot(before, place));
            QVERIFY(angle > 0.0);
            if (points++ == 0) first = to.z - pitch * angle / (2.0 * pi);
            turned += angle;
            QVERIFY2(std::abs(to.z - first - pitch * turned / (2.0 * pi)) < 0.006,
                     qPrintable(QString::number(to.z - first - pitch * turned / (2.0 * pi))));
            if (std::abs(glm::length(place) - radius) > 0.005) continue; // half turns that lead onto it and off
            lowest = std::min(lowest, to.z + tooth);
            highest = std::max(highest, to.z + tooth);
            ofHelix = std::max(ofHelix, (*moves)[i].feed);
        }
        QVERIFY(points > 500);
        // The crest goes from half a pitch below the plate to half a pitch above it.
        QVERIFY2(std::abs(lowest + 0.5 * pitch) < 0.15, qPrintable(QString::number(lowest)));
        QVERIFY2(std::abs(highest - 12.0 - 0.5 * pitch) < 0.15, qPrintable(QString::number(highest)));
        // F (D - d) / D
        QVERIFY2(fastest > 0.0 && std::abs(ofHelix / fastest - (8.0 - 6.0) / 8.0) < 0.005,
                 qPrintable(QString("%1 of %2").arg(ofHelix).arg(fastest)));
    }

    void whatDoesNotFitIsRefused() {
        const QStringList thread{"path", in("p.burin"), "new", "--pass", "thread"};
        const auto refusal = [&](const QStringList& further) {
            const ProgramRun made = runBurin(thread + further);
            return made.status != 0 ? made.messages : QByteArray("was made");
        };
        const QStringList m8{"--tool", "thread-mill-m8"};
        const QByteArray core = refusal(m8 + QStringList{"--thread", "M8", "--hole", at(40.0, 10.0)});
        QVERIFY2(core.contains("8.00 mm, not with 6.80 mm"), core.constData());
        const QByteArray other = refusal(m8 + QStringList{"--thread", "M6"});
        QVERIFY2(other.contains("pitch of 1 mm"), other.constData());
        const QByteArray wide = refusal({"--tool", "thread-mill-m10", "--pitch", "1.5", "--hole", at(10.0, 10.0)});
        QVERIFY2(wide.contains("at most 6.28 mm"), wide.constData());
        const QByteArray drill = refusal({"--tool", "drill-6.8", "--thread", "M8"});
        QVERIFY2(drill.contains("a thread mill"), drill.constData());
        const QByteArray unknown = refusal(m8 + QStringList{"--thread", "M7.7"});
        QVERIFY2(unknown.contains("M7.7") && unknown.contains("M24"), unknown.constData());
        const QByteArray number = refusal(m8 + QStringList{"--thread", "M8", "--hole", "9"});
        QVERIFY2(number.contains("1 to 4"), number.constData());
        const QByteArray nothing = refusal(m8);
        QVERIFY2(nothing.contains("pitch_mm"), nothing.constData());
    }

    /// A hole by its number in "info", a left-hand thread by its threads per inch; the request is stored.
    void aHoleByItsNumber() {
        QJsonArray holes = run({"info", in("p.burin")}).json()["holes"].toArray();
        QCOMPARE(holes.size(), 4);
        int number = 0;
        for (const QJsonValue& each : holes) {
            const QJsonArray centre = each.toObject()["centre_mm"].toArray();
            if (std::abs(centre[0].toDouble() - corner().x - 70.0) < 0.01) number = each.toObject()["number"].toInt();
        }
        QVERIFY(number > 0);
        const ProgramRun made =
            run({"path", in("p.burin"), "new", "--pass", "thread", "--tool", "thread-mill-m8", "--tpi", "20.32",
                 "--left-hand", "--radial-passes", "2", "--spring-pass", "--hole", QString::number(number)});
        QVERIFY2(made.status == 0, made.messages.constData());
        QCOMPARE(made.json()["strokes"].toInt(), 1);
        const ProgramRun list = runBurin({"path", in("p.burin"), "list", "--json"});
        QVERIFY2(list.output.contains("left_hand") && list.output.contains("places_mm"), list.output.constData());
    }

    /// A stud that is drawn at the minor diameter gets its thread, once the stock around it is milled to the major one.
    /// The program passes its check, and LinuxCNC makes a helix of it: right-handed, clockwise, from the top down, of
    /// (minor diameter + tool diameter) / 2, at (D + d) / D times the feed.
    void anExternalThreadIsAHelix() {
        constexpr double root = 4.0 - 0.649519 * pitch, radius = root + 3.0; // mm: 3/4 H below the crest
        QVERIFY(writePlate(in("stud.brep").toStdString(), {}, {{40.0, 25.0, 2.0 * root, 12.0, 24.0}}));
        QCOMPARE(run({"embed", in("stud.brep"), "-o", in("s.burin"), "--voxel", "0.5", "--margin", "1"}).status, 0);
        const QJsonObject info = run({"info", in("s.burin")}).json();
        QCOMPARE(info["holes"].toArray().size(), 0);
        QCOMPARE(info["studs"].toArray().size(), 1);
        const QJsonArray low = info["model"].toObject()["bounding_box_mm"].toArray()[0].toArray();
        const glm::dvec3 start(low[0].toDouble(), low[1].toDouble(), low[2].toDouble());
        const glm::dvec2 axis = glm::dvec2(start) + glm::dvec2(40.0, 25.0);
        const QStringList thread{"path",           in("s.burin"), "new", "--pass",     "thread",  "--tool",
                                 "thread-mill-m8", "--thread",    "M8",  "--external", "--depth", "8"};
        const ProgramRun early = runBurin(thread);
        QVERIFY(early.status != 0);
        QVERIFY2(early.messages.contains("mill it to the thread's major diameter first, 8.00 mm"),
                 early.messages.constData());
        const QString circle = QString("0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n%1\n20\n%2\n30\n0\n40\n12\n0\n"
                                       "ENDSEC\n0\nEOF\n")
                                   .arg(axis.x)
                                   .arg(axis.y);
        QFile drawing(in("around.dxf"));
        QVERIFY(drawing.open(QIODevice::WriteOnly) && drawing.write(circle.toUtf8()) > 0);
        drawing.close();
        const ProgramRun milled = run({"path", in("s.burin"), "new", "--pass", "levels", "--tool", "flat-6",
                                       "--allowance", "0.812", "--area", in("around.dxf"), "--unit", "mm"});
        QVERIFY2(milled.status == 0, milled.messages.constData());
        const ProgramRun made = run(thread);
        QVERIFY2(made.status == 0, made.messages.constData());
        QCOMPARE(made.json()["strokes"].toInt(), 1);
        const ProgramRun post = run({"post", in("s.burin"), "-o", in("s.ngc"), "--dialect", "linuxcnc"});
        QVERIFY2(post.status == 0, (post.messages + post.output).constData());
        QVERIFY(post.json()["passed"].toBool());
        QVERIFY2(post.json()["gouge_max_mm"].toDouble() < 0.01, post.output.constData());
        const auto moves = canonicalMoves(in("s.ngc"), folder_.path(), toolsOf(post.json()));
        QVERIFY(moves);
        const glm::dvec3 move = zeroOf(post.json());
        double turned = 0.0, first = 0.0, lowest = 1e9, highest = -1e9;
        int points = 0;
        for (std::size_t i = 1; i < moves->size(); ++i) {
            const glm::dvec3 from = (*moves)[i - 1].to + move, to = (*moves)[i].to + move;
            const glm::dvec2 before = glm::dvec2(from) - axis, place = glm::dvec2(to) - axis;
            const auto on = [&](const glm::dvec2& at) { return std::abs(glm::length(at) - radius) < 0.005; };
            if ((*moves)[i].rapid || !on(before) || !on(place)) continue;
            const double angle = std::atan2(before.x * place.y - before.y * place.x, glm::dot(before, place));
            QVERIFY(angle < 0.0);
            if (points++ == 0) first = to.z - pitch * angle / (2.0 * pi);
            turned += angle;
            QVERIFY2(std::abs(to.z - first - pitch * turned / (2.0 * pi)) < 0.006,
                     qPrintable(QString::number(to.z - first - pitch * turned / (2.0 * pi))));
            lowest = std::min(lowest, to.z);
            highest = std::max(highest, to.z);
        }
        QVERIFY2(points > 500, qPrintable(QString::number(points)));
        const double tooth = 0.5 * loadTool("thread-mill-m8")->cutter.fluteLength, top = start.z + 24.0;
        QVERIFY2(std::abs(lowest + tooth - (top - 8.0)) < 0.05, qPrintable(QString::number(lowest)));
        QVERIFY2(highest + tooth > top + 0.5 * pitch - 0.05, qPrintable(QString::number(highest)));
    }

private:
    QString in(const QString& name) const { return folder_.filePath(name); }
    ProgramRun run(QStringList arguments) const { return runBurin(arguments << "--json"); }
    /// The plate's corner in the setup frame.
    glm::dvec3 corner() const {
        if (!corner_) {
            const QJsonObject info = run({"info", in("p.burin")}).json();
            const QJsonArray low = info["model"].toObject()["bounding_box_mm"].toArray()[0].toArray();
            corner_ = {low[0].toDouble(), low[1].toDouble(), low[2].toDouble()};
        }
        return *corner_;
    }
    QString at(double x, double y) const { return QString("%1,%2").arg(corner().x + x).arg(corner().y + y); }
    static glm::dvec3 zeroOf(const QJsonObject& post) {
        const QJsonArray offset = post["work_offset_mm"].toArray();
        return {offset[0].toDouble(), offset[1].toDouble(), offset[2].toDouble()};
    }
    static std::vector<std::pair<int, double>> toolsOf(const QJsonObject& post) {
        std::vector<std::pair<int, double>> tools;
        for (const QJsonValue& each : post["tools"].toArray())
            tools.emplace_back(each.toObject()["number"].toInt(1), 6.0);
        return tools;
    }
    QTemporaryDir folder_;
    mutable std::optional<glm::dvec3> corner_;
};

BURIN_TEST(ThreadsTest, QCoreApplication)

} // namespace burin::tst_threads

#include "tst_threads.moc"
