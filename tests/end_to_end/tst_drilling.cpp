// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "canonical_moves.h"
#include "plate_with_holes.h"
#include "program_run.h"

#include "core/base/units.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <map>

namespace burin::tst_drilling {

using namespace burin::test;

/// Holes of a part made with OpenCASCADE are found and drilled. Oracles: the dimensions that the part was made with,
/// and LinuxCNC's interpreter for the program.
class DrillingTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY(writePlate(in("plate.brep").toStdString(),
                           {{10.0, 10.0, 6.0, -1.0, 13.0},
                            {70.0, 10.0, 6.0, -1.0, 13.0},
                            {70.0, 40.0, 6.0, -1.0, 13.0},
                            {10.0, 40.0, 6.0, 4.0, 13.0},  // blind, 8 mm deep
                            {40.0, 10.0, 5.0, -1.0, 13.0}, // for another drill
                            {40.0, 40.0, 10.0, 7.0, 13.0}, // a counterbore …
                            {40.0, 40.0, 6.0, -1.0, 8.0}}, // … and the hole in it
                           {{55.0, 25.0, 6.0, 11.0, 14.0}}));
        QCOMPARE(run({"embed", in("plate.brep"), "-o", in("p.burin"), "--voxel", "0.8", "--margin", "1"}).status, 0);
    }

    void holesAreFound() {
        const ProgramRun info = run({"info", in("p.burin")});
        QCOMPARE(info.status, 0);
        std::map<double, int> count;
        for (const QJsonValue& each : info.json()["holes"].toArray()) {
            const QJsonObject hole = each.toObject();
            ++count[std::round(1e3 * hole["diameter_mm"].toDouble()) / 1e3];
            const QJsonArray centre = hole["centre_mm"].toArray();
            for (int axis = 0; axis < 2; ++axis) {
                const double place = centre[axis].toDouble() - corner()[axis];
                QVERIFY2(std::abs(place - 10.0 * std::round(0.1 * place)) < 1e-3, qPrintable(QString::number(place)));
            }
        }
        QCOMPARE(count, (std::map<double, int>{{5.0, 1}, {6.0, 5}, {10.0, 1}}));
        const ProgramRun text = runBurin({"info", in("p.burin")});
        QVERIFY2(text.output.contains("5 × 6.00 mm"), text.output.constData());
    }

    /// All holes of the drill's diameter are drilled: through holes at full diameter, the blind hole down to the
    /// drill's point.
    void holesOfItsSizeAreDrilled() {
        const ProgramRun made = run({"path", in("p.burin"), "new", "--pass", "drill", "--tool", "drill-6"});
        QVERIFY2(made.status == 0, made.messages.constData());
        QCOMPARE(made.json()["strokes"].toInt(), 5);
        QCOMPARE(made.json()["unreached_holes"].toInt(), 0);
        const ProgramRun post = run({"post", in("p.burin"), "-o", in("p.ngc")});
        QVERIFY2(post.status == 0, (post.messages + post.output).constData());
        QVERIFY(post.json()["passed"].toBool());
        const auto holes = drilled(in("p.ngc"), post.json());
        QCOMPARE(holes.size(), 5u);
        const double point = 3.0 / std::tan(glm::radians(70.0)); // DIN 6537: 140 degrees
        for (const auto& [place, bottom] : holes) {
            const bool blind = place == std::pair(10L, 40L);
            const double expected = blind ? 4.0 : -point - 0.2;
            QVERIFY2(bottom > expected - 0.001 && bottom < expected + 0.012,
                     qPrintable(QString("%1 %2: %3").arg(place.first).arg(place.second).arg(bottom)));
        }
        QCOMPARE(holes.count({40, 10}), 0u);
        // A hole is not drilled twice.
        const ProgramRun again = runBurin({"path", in("p.burin"), "apply", "1", "--pass", "drill"});
        QVERIFY(again.status != 0);
        QVERIFY2(again.messages.contains("not drilled yet"), again.messages.constData());
    }

    /// All pecks start above the hole, each goes deeper, and they return by rapids in the hole already drilled.
    void pecksComeUpForChips() {
        QCOMPARE(run({"embed", in("plate.brep"), "-o", in("q.burin"), "--voxel", "0.8", "--margin", "1"}).status, 0);
        const ProgramRun made = run({"path", in("q.burin"), "new", "--pass", "drill", "--tool", "drill-5",
                                     "--level-depth", "4", "--hole", at(40.5, 10.5)});
        QVERIFY2(made.status == 0, made.messages.constData());
        const ProgramRun post = run({"post", in("q.burin"), "-o", in("q.ngc")});
        QVERIFY2(post.status == 0, post.messages.constData());
        const double point = 2.5 / std::tan(glm::radians(59.0)); // DIN 338: 118 degrees
        const double depth = 15.0 + point + 0.2;                 // the stud, and a millimetre of stock above it
        const int pecks = static_cast<int>(std::ceil(depth / 4.0));
        QCOMPARE(made.json()["strokes"].toInt(), pecks);
        const auto moves = canonicalMoves(in("q.ngc"), folder_.path(), tool(post.json()), 5.0);
        QVERIFY(moves);
        std::vector<double> bottoms;
        double fed = 0.0, lowest = 1e9;
        const double top = corner().z + 15.0 - zeroOf(post.json()).z;
        for (std::size_t i = 1; i < moves->size(); ++i) {
            const glm::dvec3 from = (*moves)[i - 1].to, to = (*moves)[i].to;
            if (!(*moves)[i].rapid) {
                fed += glm::distance(from, to);
                lowest = std::min(lowest, to.z);
            } else if (to.z > top) {
                if (lowest < top && (bottoms.empty() || lowest < bottoms.back())) bottoms.push_back(lowest);
            } else if (to.z < from.z && to.z < top) {
                QVERIFY2(to.z >= lowest + 0.5, "a rapid keeps off the bottom"); // the approach is a millimetre long
            }
        }
        QCOMPARE(static_cast<int>(bottoms.size()), pecks);
        for (std::size_t i = 1; i < bottoms.size(); ++i)
            QVERIFY(std::abs(bottoms[i - 1] - bottoms[i] - depth / pecks) < 0.01);
        // In the drilled part of the hole only the approach is repeated at feed rate.
        QVERIFY2(fed < depth + 3.0 * pecks, qPrintable(QString::number(fed)));
    }

    /// A deep hole is pecked by default; a point without a hole needs a depth; a drill that is too wide is refused.
    void placesAndDepths() {
        const ProgramRun none =
            runBurin({"path", in("q.burin"), "new", "--pass", "drill", "--tool", "drill-3", "--hole", at(25.0, 25.0)});
        QVERIFY(none.status != 0);
        QVERIFY2(none.messages.contains("a depth"), none.messages.constData());
        const ProgramRun wide =
            runBurin({"path", in("q.burin"), "new", "--pass", "drill", "--tool", "drill-8", "--hole", at(10.0, 10.0)});
        QVERIFY(wide.status != 0);
        QVERIFY2(wide.messages.contains("6.00 mm"), wide.messages.constData());
        const ProgramRun other = runBurin({"path", in("q.burin"), "new", "--pass", "drill", "--tool", "flat-6"});
        QVERIFY(other.status != 0);
        QVERIFY2(other.messages.contains("drill"), other.messages.constData());
        const ProgramRun deep = run({"path", in("q.burin"), "new", "--pass", "drill", "--tool", "drill-3", "--hole",
                                     at(40.0, 10.0), "--hole", at(10.0, 10.0)});
        QVERIFY2(deep.status == 0, deep.messages.constData());
        const double depth = 15.0 + 1.5 / std::tan(glm::radians(59.0)) + 0.2;               // more than three diameters
        QCOMPARE(deep.json()["strokes"].toInt(), static_cast<int>(std::ceil(depth / 3.0))); // one is drilled already
        // At a point that is no hole, drilling stops at the part.
        const ProgramRun spot = run({"path", in("q.burin"), "new", "--pass", "drill", "--tool", "drill-2", "--hole",
                                     at(25.0, 25.0), "--depth", "9"});
        QVERIFY2(spot.status == 0, spot.messages.constData());
        QCOMPARE(spot.json()["strokes"].toInt(), 1);
        QVERIFY2(std::abs(spot.json()["length_mm"].toDouble() - 4.0) < 0.1,
                 spot.output.constData()); // from above to the plate
    }

private:
    QString in(const QString& name) const { return folder_.filePath(name); }
    ProgramRun run(QStringList arguments) const { return runBurin(arguments << "--json"); }
    /// The plate's corner in the setup frame.
    glm::dvec3 corner() const {
        const QJsonObject info = run({"info", in("p.burin")}).json();
        const QJsonArray low = info["model"].toObject()["bounding_box_mm"].toArray()[0].toArray();
        return {low[0].toDouble(), low[1].toDouble(), low[2].toDouble()};
    }
    QString at(double x, double y) const { return QString("%1,%2").arg(corner().x + x).arg(corner().y + y); }
    static glm::dvec3 zeroOf(const QJsonObject& post) {
        const QJsonArray offset = post["work_offset_mm"].toArray();
        return {offset[0].toDouble(), offset[1].toDouble(), offset[2].toDouble()};
    }
    static int tool(const QJsonObject& post) { return post["tools"].toArray().at(0).toObject()["number"].toInt(1); }
    /// The lowest tip at each point of the plate (rounded to mm), mm above its underside.
    std::map<std::pair<long, long>, double> drilled(const QString& program, const QJsonObject& post) const {
        std::map<std::pair<long, long>, double> holes;
        const auto moves = canonicalMoves(program, folder_.path(), tool(post), 6.0);
        if (!moves) return holes;
        for (const CanonicalMove& move : *moves) {
            if (move.rapid) continue;
            const glm::dvec3 tip = move.to + zeroOf(post) - corner();
            const auto place = std::pair(std::lround(tip.x), std::lround(tip.y));
            const auto known = holes.try_emplace(place, tip.z).first;
            known->second = std::min(known->second, tip.z);
        }
        return holes;
    }
    QTemporaryDir folder_;
};

BURIN_TEST(DrillingTest, QCoreApplication)

} // namespace burin::tst_drilling

#include "tst_drilling.moc"
