// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plate_with_holes.h"
#include "program_run.h"

#include "core/base/units.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_part_measure {

using namespace burin::test;

/// Measurements of a part made with OpenCASCADE, compared with the dimensions that it was made with.
class PartMeasureTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        // 80 x 50 x 12 mm; two holes of 6 and 10 mm, 30 mm apart.
        QVERIFY(writePlate(in("plate.brep").toStdString(),
                           {{10.0, 10.0, 6.0, -1.0, 13.0}, {40.0, 10.0, 10.0, -1.0, 13.0}}, {}));
        QVERIFY(embed("plate.brep", "plate.burin"));
        // A wedge with a slope of atan(20 / 10) on a block, with a cone and a ball.
        TopoDS_Shape shape = BRepPrimAPI_MakeWedge(40.0, 20.0, 30.0, 30.0).Shape(); // y up, x from 40 to 30
        shape = BRepAlgoAPI_Fuse(
            shape, BRepPrimAPI_MakeCone(gp_Ax2({100.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), 10.0, 5.0, 20.0).Shape());
        shape = BRepAlgoAPI_Fuse(shape, BRepPrimAPI_MakeSphere(gp_Pnt(0.0, 0.0, 100.0), 8.0).Shape());
        QVERIFY(BRepTools::Write(shape, in("shapes.brep").toStdString().c_str()));
        QVERIFY(embed("shapes.brep", "shapes.burin"));
    }

    void aPlaneHasItsWallAndItsArea() {
        const QJsonObject top = measure("plate.burin", {20.0, 40.0, 12.0});
        QCOMPARE(top["from"]["face"].toString(), QStringLiteral("plane"));
        near(top["from"]["thickness_mm"], 12.0);
        near(top["from"]["area_mm2"], 80.0 * 50.0 - pi * (9.0 + 25.0));
        near(top["from"]["normal"][2], 1.0);
        // The 10 mm hole, whose centre is 10 mm from the side of the plate, leaves a wall of 10 − 5 = 5 mm.
        const QJsonObject side = measure("plate.burin", {40.0, 0.0, 6.0});
        near(side["from"]["thickness_mm"], 5.0);
    }

    void aHoleHasItsDiameterAndItsDistance() {
        const QJsonObject holes = measure("plate.burin", {13.0, 10.0, 6.0}, glm::dvec3(45.0, 10.0, 6.0));
        QCOMPARE(holes["from"]["face"].toString(), QStringLiteral("cylinder"));
        near(holes["from"]["radius_mm"], 3.0);
        near(holes["to"]["radius_mm"], 5.0);
        near(holes["between"]["apart_mm"], 30.0); // between the axes
        near(holes["between"]["faces_mm"], 22.0); // 30 − 3 − 5
        near(holes["between"]["angle_rad"], 0.0);
        near(holes["between"]["corners_mm"], 30.0); // between the centres of their rims
        near(holes["between"]["points_mm"], 32.0);
    }

    void facesHaveAnAngleOrADistance() {
        const QJsonObject walls = measure("plate.burin", {80.0, 25.0, 6.0}, glm::dvec3(0.0, 30.0, 6.0));
        near(walls["between"]["apart_mm"], 80.0);
        near(walls["between"]["angle_rad"], 0.0);
        const QJsonObject square = measure("plate.burin", {80.0, 25.0, 6.0}, glm::dvec3(30.0, 50.0, 6.0));
        near(square["between"]["angle_rad"], 0.5 * pi);
        QVERIFY(square["between"]["apart_mm"].isNull());
        const QJsonObject same = measure("plate.burin", {80.0, 25.0, 6.0}, glm::dvec3(80.0, 35.0, 6.0));
        near(same["between"]["points_mm"], 10.0);
        QVERIFY(same["between"]["faces_mm"].isNull()); // it is the same face
        near(square["between"]["faces_mm"], 0.0);
        // A hole and the plate's side, which are parallel.
        const QJsonObject along = measure("plate.burin", {40.0, 0.0, 6.0}, glm::dvec3(13.0, 10.0, 6.0));
        near(along["between"]["apart_mm"], 10.0);
        near(along["between"]["angle_rad"], 0.0);
        // The wedge's slope against its bottom.
        const QJsonObject slope = measure("shapes.burin", {35.0, 10.0, 15.0}, glm::dvec3(20.0, 0.0, 15.0));
        near(slope["between"]["angle_rad"], std::atan2(20.0, 10.0));
    }

    void coneAndBallAreKnown() {
        const QJsonObject cone = measure("shapes.burin", {107.5, 0.0, 10.0}); // half way up: radius 7.5
        QCOMPARE(cone["from"]["face"].toString(), QStringLiteral("cone"));
        near(cone["from"]["radius_mm"], 7.5);
        near(cone["from"]["taper_rad"], std::atan2(5.0, 20.0));
        const QJsonObject ball = measure("shapes.burin", {8.0, 0.0, 100.0});
        QCOMPARE(ball["from"]["face"].toString(), QStringLiteral("sphere"));
        near(ball["from"]["radius_mm"], 8.0);
        near(ball["from"]["thickness_mm"], 16.0);
    }

    /// In any orientation of the setup.
    void aTurnedPartIsMeasuredWhereItLies() {
        QVERIFY(QFile::copy(in("plate.burin"), in("turned.burin")));
        QCOMPARE(runBurin({"setup", in("turned.burin"), "--turn", "x:90", "--json"}).status, 0);
        // About the middle of the box: (40, 25, 6). The face that faced up now faces −y.
        const QJsonObject top = measure("turned.burin", {20.0, 19.0, 0.0});
        near(top["from"]["normal"][1], -1.0);
        near(top["from"]["thickness_mm"], 12.0);
    }

    void aMeshIsMeasuredByItsTriangles() {
        QFile file(in("block.stl"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        const QByteArray facets = blockStl(40.0, 30.0, 20.0);
        QCOMPARE(file.write(facets), facets.size());
        file.close();
        QVERIFY(embed("block.stl", "mesh.burin"));
        const QJsonObject top = measure("mesh.burin", {10.0, 10.0, 20.0}, glm::dvec3(10.0, 10.0, 0.0));
        QCOMPARE(top["from"]["face"].toString(), QStringLiteral("plane"));
        near(top["from"]["thickness_mm"], 20.0);
        near(top["between"]["apart_mm"], 20.0);
        QVERIFY(top["from"]["area_mm2"].isNull());
    }

    /// A slot, a hole and a step that a program mills into the stock above the plate, by the dimensions of the program;
    /// walls within half a voxel to either side, levels within 1/200.
    void theWorkpieceIsMeasuredAsItIsMilled() {
        QVERIFY(
            runBurin({"embed", in("plate.brep"), "-o", in("raw.burin"), "--voxel", "0.5", "--margin", "10"}).status ==
            0); // program zero: the middle of the top, (40, 25, 22)
        QFile file(in("milled.ngc"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("G21 G90 G17 G94 G54\nT7 M6\nG43 H7\nS6000 M3\nG0 Z20\n"
                   "G0 X-60 Y15.13\nG0 Z-6.2\nG1 X0 F300\nG0 Z20\n"         // a slot along X, 10 wide
                   "G0 X27 Y-15\nG1 Z-8 F300\nG3 X27 Y-15 I-7 J0\nG0 Z20\n" // a ring, 24 across outside
                   "G0 X47 Y-50\nG0 Z-5\nG1 Y50 F300\nG0 Z20\nM5\nM2\n");   // a step 8 wide
        file.close();
        const ProgramRun cut = runBurin({"verify", in("milled.ngc"), "--project", in("raw.burin"), "--tool", "flat-10",
                                         "--exact", "0", "--workpiece", in("then.srle"), "--json"});
        QVERIFY2(QFile::exists(in("then.srle")), cut.messages.constData());
        const QJsonObject wall = milled({20.0, 25.0 + 15.13 + 5.0, 19.0})["from"].toObject();
        within(wall["width"], 10.0);
        QVERIFY(wall["width"]["uncertainty_mm"].toDouble() <= 1.0);
        const QJsonObject floor = milled({10.0, 40.0, 15.0})["from"].toObject();
        QCOMPARE(floor["face"].toString(), QStringLiteral("plane"));
        within(floor["depth"], 6.2);
        QVERIFY(floor["depth"]["uncertainty_mm"].toDouble() < 0.01);
        near(floor["from_part_mm"], 22.0 - 6.2 - 12.0, 0.01);
        near(floor["thickness_mm"], 32.0 - 6.2, 0.01);
        const QJsonObject hole = milled({40.0 + 20.0, 25.0 - 15.0 + 12.0, 18.0})["from"].toObject();
        QCOMPARE(hole["face"].toString(), QStringLiteral("cylinder"));
        near(hole["radius_mm"], 12.0, hole["radius_uncertainty_mm"].toDouble());
        QVERIFY(hole["radius_uncertainty_mm"].toDouble() < 0.3);
        const QJsonObject step = milled({88.0, 25.0, 17.0}, glm::dvec3(75.0, 0.0, 22.0));
        near(step["between"]["apart_mm"], 5.0, 0.01);
        const QJsonObject side = milled({82.0, 25.0, 19.5}, glm::dvec3(90.0, 25.0, 10.0));
        near(side["between"]["apart_mm"], 8.0, side["between"]["uncertainty_mm"].toDouble());
        // From the front through the slot's wall: 20 mm lie in front of the slot, seen obliquely by the cosine.
        const ProgramRun oblique = runBurin({"measure", in("raw.burin"), "--workpiece-file", in("then.srle"), "--at",
                                             "10,-10,5", "--direction", "0,1,1", "--json"});
        within(oblique.json()["from"].toObject()["thickness_along_direction"], 17.0 * std::sqrt(2.0)); // up to the top
    }

    /// Without recordings the workpiece is the stock; a direction alone is refused.
    void theWorkpieceOfAProjectIsMeasured() {
        const ProgramRun run = runBurin({"measure", in("plate.burin"), "--workpiece", "--at", "20,20,13", "--json"});
        QVERIFY2(run.status == 0, run.messages.constData());
        near(run.json()["from"].toObject()["thickness_mm"], 14.0, 0.02);
        near(run.json()["from"].toObject()["from_part_mm"], 1.0, 0.02);
        near(run.json()["from"].toObject()["depth"].toObject()["value_mm"], 0.0, 0.02);
        const ProgramRun text = runBurin({"measure", in("plate.burin"), "--workpiece", "--at", "20,20,13"});
        QVERIFY2(text.output.contains("Stock left on the part: 1.000"), text.output.constData());
        const ProgramRun refused =
            runBurin({"measure", in("plate.burin"), "--at", "20,20,13", "--direction", "0,0,-1"});
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.messages.contains("--workpiece"), refused.messages.constData());
    }

    void whatIsWrongIsSaid() {
        for (const QStringList& wrong :
             {QStringList{"--at", "1,2"}, {"--at", "a,b,c"}, {"--at", "1,2,3", "--to", "nan,0,0"}}) {
            const ProgramRun refused = runBurin(QStringList{"measure", in("plate.burin")} + wrong);
            QCOMPARE(refused.status, 2);
            QVERIFY2(refused.messages.contains("X,Y,Z"), refused.messages.constData());
        }
        const ProgramRun text = runBurin({"measure", in("plate.burin"), "--at", at("plate.burin", {13.0, 10.0, 6.0})});
        QVERIFY2(text.output.contains("Cylinder, Ø 6.000"), text.output.constData());
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }
    static void near(const QJsonValue& value, double wanted, double tolerance = 1e-5) {
        QVERIFY2(std::abs(value.toDouble(1e9) - wanted) < tolerance,
                 qPrintable(QString("%1 instead of %2").arg(value.toDouble(1e9), 0, 'g', 10).arg(wanted, 0, 'g', 10)));
    }
    /// A length agrees with the truth within its own uncertainty.
    static void within(const QJsonValue& length, double truth) {
        near(length["value_mm"], truth, length["uncertainty_mm"].toDouble() + 1e-9);
    }
    QJsonObject milled(const glm::dvec3& place, const std::optional<glm::dvec3>& to = {}) {
        QStringList arguments{"measure", in("raw.burin"), "--workpiece-file",    in("then.srle"),
                              "--json",  "--at",          at("raw.burin", place)};
        if (to) arguments << "--to" << at("raw.burin", *to);
        const ProgramRun run = runBurin(arguments);
        if (run.status != 0) qWarning("%s", run.messages.constData());
        return run.json();
    }
    bool embed(const char* model, const char* project) {
        return runBurin({"embed", in(model), "-o", in(project), "--voxel", "1", "--margin", "1", "--json"}).status == 0;
    }
    /// A point in the model's own frame, converted to the setup frame.
    QString at(const char* project, const glm::dvec3& place) {
        Q_UNUSED(project);
        return QString("%1,%2,%3").arg(place.x, 0, 'g', 12).arg(place.y, 0, 'g', 12).arg(place.z, 0, 'g', 12);
    }
    QJsonObject measure(const char* project, const glm::dvec3& place, const std::optional<glm::dvec3>& to = {}) {
        QStringList arguments{"measure", in(project), "--json", "--at", at(project, place)};
        if (to) arguments << "--to" << at(project, *to);
        const ProgramRun run = runBurin(arguments);
        if (run.status != 0) qWarning("%s", run.messages.constData());
        return run.json();
    }
    static QByteArray blockStl(double x, double y, double z) {
        TriangleMesh mesh;
        for (int i = 0; i < 8; ++i) mesh.vertices.push_back({i & 1 ? x : 0.0, i & 2 ? y : 0.0, i & 4 ? z : 0.0});
        mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                          {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
        return testing::stlText(mesh);
    }

    QTemporaryDir folder_;
};

BURIN_TEST(PartMeasureTest, QCoreApplication)

} // namespace burin::tst_part_measure

#include "tst_part_measure.moc"
