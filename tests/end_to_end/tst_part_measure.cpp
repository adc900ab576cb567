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
    static void near(const QJsonValue& value, double wanted) {
        QVERIFY2(std::abs(value.toDouble(1e9) - wanted) < 1e-5,
                 qPrintable(QString("%1 instead of %2").arg(value.toDouble(1e9), 0, 'g', 10).arg(wanted, 0, 'g', 10)));
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
