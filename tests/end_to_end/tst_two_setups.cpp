// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "canonical_moves.h"
#include "part_judge.h"
#include "program_run.h"

#include "core/tool/tool_library.h"
#include "tests/long_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin::tst_two_setups {

namespace {

constexpr const char* mouse = BURIN_BUILD_DIRECTORY "/resources/samples/mouse.step";
constexpr double radius = 3.0; // mm, of the ball

/// The sample part in a long run; a cube of 10 mm, which is milled in a tenth of the time, otherwise.
const char* part() {
    return testing::inLongRun(mouse, BURIN_FIXTURES "/models/cube.brep");
}

/// A point of a surface and the direction out of the part.
struct SurfacePoint {
    glm::dvec3 point, normal;
};

/// Points of a mesh at most half a millimetre apart: the middles of the equal parts that each triangle is divided into.
std::vector<SurfacePoint> pointsOn(const TriangleMesh& mesh) {
    std::vector<SurfacePoint> points;
    for (const auto& corners : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[corners[0]], ab = mesh.vertices[corners[1]] - a,
                         ac = mesh.vertices[corners[2]] - a, across = glm::cross(ab, ac);
        if (!(glm::length(across) > 0.0)) continue;
        const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ab - ac)});
        const int parts = static_cast<int>(std::ceil(longest / 0.5));
        for (int i = 0; i < parts; ++i)
            for (int j = 0; i + j < parts; ++j)
                points.push_back(
                    {a + (i + 1.0 / 3.0) / parts * ab + (j + 1.0 / 3.0) / parts * ac, glm::normalize(across)});
    }
    return points;
}

/// The ball's centres along a program, in the model's own frame.
struct Swept {
    std::vector<std::pair<glm::dvec3, glm::dvec3>> ways;

    double distance(const glm::dvec3& place) const {
        double nearest = 1e9;
        for (const auto& [from, to] : ways) {
            const glm::dvec3 way = to - from;
            const double length = glm::dot(way, way);
            const double share = length > 0.0 ? std::clamp(glm::dot(place - from, way) / length, 0.0, 1.0) : 0.0;
            nearest = std::min(nearest, glm::distance(place, from + share * way));
        }
        return nearest;
    }
};

glm::dvec3 vectorOf(const QJsonValue& value) {
    const QJsonArray numbers = value.toArray();
    return {numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()};
}

} // namespace

/// A part that is milled from two sides by the command line, and one that is laid on a face first. Oracles: LinuxCNC's
/// interpreter for the moves of the programs, the exact part for their result.
class TwoSetupsTest : public QObject {
    Q_OBJECT
private slots:
    void aSecondSetupBeginsWithWhatTheFirstLeaves() {
        QCOMPARE(
            runBurin({"embed", part(), "-o", in("p.burin"), "--voxel", testing::inLongRun("1", "0.5"), "--margin", "3"})
                .status,
            0);
        const ProgramRun early = runBurin({"setup", in("p.burin"), "--add-setup", "Back", "--turn", "x:180"});
        QCOMPARE(early.status, 2);
        QVERIFY2(early.messages.contains("recording"), early.messages.constData());
        QCOMPARE(setupsOf().size(), 1);

        mill("1", "front.ngc");
        const ProgramRun added = runBurin({"setup", in("p.burin"), "--add-setup", "Back", "--turn", "x:180"});
        QVERIFY2(added.status == 0, added.messages.constData());
        QVERIFY2(added.messages.contains("checked program"), added.messages.constData());
        QCOMPARE(setupsOf().size(), 2);
        const QJsonObject back = setupsOf()[1].toObject();
        QCOMPARE(back["name"].toString(), QString("Back"));
        QVERIFY(back["stock_left_by"].toInt() == 1 && !back["stock_out_of_date"].toBool());
        // Half a turn about x, through the middle of the part: exact.
        const QJsonArray turn = back["placement"]["turn"].toArray();
        QCOMPARE(vectorOf(turn[0]), glm::dvec3(1.0, 0.0, 0.0));
        QCOMPARE(vectorOf(turn[1]), glm::dvec3(0.0, -1.0, 0.0));
        QCOMPARE(vectorOf(turn[2]), glm::dvec3(0.0, 0.0, -1.0));
        QCOMPARE(runBurin({"info", in("p.burin"), "--setup", "Back", "--json"}).json()["takes"].toArray().size(), 0);
    }

    void bothProgramsTogetherMakeThePart() {
        mill("Back", "back.ngc");
        const ProgramRun verified = runBurin(
            {"verify", in("back.ngc"), "--project", in("p.burin"), "--setup", "2", "--exact", "0", "--excess", "0"});
        QVERIFY2(verified.status == 0, verified.output.constData());
        const std::optional<PartJudge> judge = PartJudge::of(part(), radius);
        QVERIFY(judge);
        const Swept front = swept("front.ngc", "1"), back = swept("back.ngc", "2");
        QVERIFY(front.ways.size() > 100 && back.ways.size() > 100);

        // The part is not cut, and the points 0.3 mm above its surface are.
        const std::vector<SurfacePoint> points = pointsOn(judge->model().bodies.front().mesh);
        const std::size_t every = std::max<std::size_t>(1, points.size() / 3000);
        int looked = 0, left = 0, gouged = 0;
        for (std::size_t i = 0; i < points.size(); i += every) {
            ++looked;
            const auto nearest = [&](double height) {
                const glm::dvec3 place = points[i].point + height * points[i].normal;
                return std::min(front.distance(place), back.distance(place));
            };
            if (nearest(0.3) > radius) ++left;
            if (nearest(-0.02) < radius) ++gouged;
        }
        qInfo("%d places of the surface: %d left, %d gouged", looked, left, gouged);
        QVERIFY(looked > 1000);
        QVERIFY2(left <= looked / 100, qPrintable(QString("%1 of %2 left").arg(left).arg(looked)));
        QCOMPARE(gouged, 0);
    }

    /// Changes that a machinist would otherwise only notice at the machine.
    void changesOfTheFirstSideAreTold() {
        QCOMPARE(runBurin({"setup", in("p.burin"), "--add-setup", "Third", "--turn", "z:90"}).status, 0);
        QVERIFY(!setupsOf()[2].toObject()["stock_out_of_date"].toBool());
        QCOMPARE(runBurin({"mill", in("p.burin"), "--fast", "--seconds", "3", "--seed", "5"}).status, 0);
        QVERIFY(setupsOf()[2].toObject()["stock_out_of_date"].toBool());
        const ProgramRun taken = runBurin({"setup", in("p.burin"), "--setup", "3", "--update-stock"});
        QVERIFY2(taken.status == 0, taken.messages.constData());
        QVERIFY2(taken.messages.contains("recordings"), taken.messages.constData()); // its program is out of date now
        QVERIFY(!setupsOf()[2].toObject()["stock_out_of_date"].toBool());
    }

    void refusalsSayWhy_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("a setup that is not there") << QStringList{"--setup", "Side"} << QByteArray("Back");
        QTest::newRow("milled as it lies") << QStringList{"--turn", "x:90"} << QByteArray("--add-setup");
        QTest::newRow("work would be lost")
            << QStringList{"--setup", "3", "--delete-setup", "Back"} << QByteArray("without recordings");
        QTest::newRow("in use") << QStringList{"--delete-setup", "1"} << QByteArray("not in use");
        QTest::newRow("no angle") << QStringList{"--setup", "3", "--turn", "x"} << QByteArray("AXIS:DEGREES");
        QTest::newRow("no place") << QStringList{"--setup", "3", "--align", "x=-z"} << QByteArray("X,Y,Z=AXIS");
        QTest::newRow("no stock to take") << QStringList{"--update-stock"} << QByteArray("another one left");
        if (testing::longRun()) // a cube has none
            QTest::newRow("a curved face")
                << QStringList{"--setup", "3", "--align", "0,0,60=-z"} << QByteArray("plane");
    }
    void refusalsSayWhy() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, said);
        const QString before = contentDigest();
        const ProgramRun run = runBurin(QStringList{"setup", in("p.burin")} + arguments);
        QCOMPARE(run.status, 2);
        QVERIFY2(run.messages.contains(said), run.messages.constData());
        QCOMPARE(run.messages.count('\n'), 1); // one sentence
        QCOMPARE(contentDigest(), before);
    }

    void anEmptySetupGoes() {
        QCOMPARE(runBurin({"setup", in("p.burin"), "--delete-setup", "Third"}).status, 0);
        QCOMPARE(setupsOf().size(), 2);
        QCOMPARE(runBurin({"setup", in("p.burin"), "--setup", "2", "--name", "Underside"}).status, 0);
        QCOMPARE(setupsOf()[1].toObject()["name"].toString(), QString("Underside"));
    }

    /// The part lies on its side. Its flat bottom is laid down by a point on it, which restores the original
    /// orientation.
    BURIN_ONLY_IN_LONG_RUNS void aPartIsLaidDownByAFace() {
        const ProgramRun tilted = runBurin({"embed", mouse, "-o", in("side.burin"), "--voxel", "1", "--turn", "y:90",
                                            "--turn", "z:30", "--move", "0,0,20", "--json"});
        QCOMPARE(tilted.status, 0);
        const QJsonObject placement = tilted.json()["placement"].toObject();
        const QJsonArray turn = placement["turn"].toArray();
        const auto lying = [&](const glm::dvec3& place) { // calculated from the answer
            return vectorOf(turn[0]) * place.x + vectorOf(turn[1]) * place.y + vectorOf(turn[2]) * place.z +
                   vectorOf(placement["shift_mm"]);
        };
        const glm::dvec3 bottom = lying({0.0, 0.0, 0.0}); // the bottom of the mouse is z = 0
        const QString place =
            QString("%1,%2,%3").arg(bottom.x, 0, 'g', 12).arg(bottom.y, 0, 'g', 12).arg(bottom.z, 0, 'g', 12);
        const ProgramRun laid = runBurin({"setup", in("side.burin"), "--align", place + "=-z", "--json"});
        QVERIFY2(laid.status == 0, laid.messages.constData());
        const QJsonArray now = laid.json()["setups"][0]["placement"]["turn"].toArray();
        QVERIFY(glm::distance(vectorOf(now[2]), {0.0, 0.0, 1.0}) < 1e-9);
        QCOMPARE(runBurin({"mill", in("side.burin"), "--fast", "--seconds", "6"}).status, 0);
        QCOMPARE(runBurin({"path", in("side.burin"), "new"}).status, 0);
        const ProgramRun posted = runBurin({"post", in("side.burin"), "-o", in("side.ngc")});
        QVERIFY2(posted.status == 0, posted.output.constData());
    }

    /// A mirrored part is a different part: its left side is on the right, and so is its exact surface.
    void aPartIsMirrored() {
        const auto boxOf = [&](const QStringList& more) {
            const ProgramRun run = runBurin(QStringList{"embed", BURIN_FIXTURES "/models/cube.brep", "-o",
                                                        in("m.burin"), "--replace", "--json", "--voxel", "1"} +
                                            more);
            return run.json()["model_volume_mm3"].toDouble();
        };
        QCOMPARE(boxOf({"--mirror", "x"}), boxOf({}));
        QVERIFY(runBurin({"info", in("m.burin")}).status == 0);
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }

    void mill(const QString& setup, const char* program) {
        // Rows 2.2 mm apart leave scallops of 0.21 mm by the closed formula.
        const ProgramRun rough = runBurin({"path", in("p.burin"), "new", "--setup", setup, "--json", "--pass", "levels",
                                           "--tool", "ball-6", "--allowance", "0.3"});
        QVERIFY2(rough.status == 0, rough.messages.constData());
        const QString path = QString::number(rough.json()["id"].toInt());
        for (const QStringList& pass :
             {QStringList{"parallel", "--steepest", "50"}, {"waterline", "--flattest", "40"}}) {
            const ProgramRun made = runBurin(
                QStringList{"path", in("p.burin"), "apply", path, "--setup", setup, "--step-over", "2.2", "--pass"} +
                pass);
            QVERIFY2(made.status == 0, made.messages.constData());
        }
        const ProgramRun posted = runBurin({"post", in("p.burin"), "--setup", setup, "-o", in(program)});
        QVERIFY2(posted.status == 0, posted.output.constData());
    }

    QJsonArray setupsOf() const { return runBurin({"info", in("p.burin"), "--json"}).json()["setups"].toArray(); }
    QString contentDigest() const { return contentOf(in("p.burin")); }

    /// Converted from the setup's frame back to the model's, by the output of `burin info`.
    Swept swept(const char* program, const QString& setup) const {
        const QJsonObject info = runBurin({"info", in("p.burin"), "--setup", setup, "--json"}).json();
        const QJsonObject placement = info["setups"][setup.toInt() - 1]["placement"].toObject();
        const glm::dvec3 zero = vectorOf(info["setup"]["work_offset_mm"]), shift = vectorOf(placement["shift_mm"]);
        const QJsonArray turn = placement["turn"].toArray();
        const glm::dmat3 back = glm::transpose(glm::dmat3(vectorOf(turn[0]), vectorOf(turn[1]), vectorOf(turn[2])));
        QTemporaryDir home;
        const auto moves = canonicalMoves(in(program), home.path(), loadTool("ball-6").value().number, 2.0 * radius);
        Swept result;
        for (std::size_t i = 1; moves && i < moves->size(); ++i) {
            if ((*moves)[i].rapid) continue;
            const auto centre = [&](const glm::dvec3& tip) {
                return back * (tip + zero + glm::dvec3(0.0, 0.0, radius) - shift);
            };
            result.ways.emplace_back(centre((*moves)[i - 1].to), centre((*moves)[i].to));
        }
        return result;
    }

    QTemporaryDir folder_;
};

BURIN_TEST(TwoSetupsTest, QCoreApplication)

} // namespace burin::tst_two_setups

#include "tst_two_setups.moc"
