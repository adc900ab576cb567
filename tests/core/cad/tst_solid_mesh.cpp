// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/solid_mesh.h"

#include "tests/core/cad/rounded_block.h"
#include "tests/test_program.h"

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include <QCoreApplication>
#include <QtTest>

#include <cmath>

namespace burin::tst_solid_mesh {

namespace {

constexpr double chord = 0.05; // mm

SolidMesh meshed(const TopoDS_Shape& shape) {
    return meshSolid(TopoDS::Solid(TopExp_Explorer(shape, TopAbs_SOLID).Current()), chord, [](double) {});
}

/// A box of 10 mm without its first face.
TopoDS_Solid openBox() {
    BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    TopExp_Explorer faces(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape(), TopAbs_FACE);
    for (faces.Next(); faces.More(); faces.Next()) builder.Add(shell, faces.Current());
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    return solid;
}

} // namespace

class TestSolidMesh : public QObject {
    Q_OBJECT

private slots:
    /// Seams, poles and an apex are not holes, and each face is covered once.
    void soundSolidsAreMeshedOnce_data() {
        QTest::addColumn<TopoDS_Shape>("solid");
        QTest::addColumn<double>("volume"); // mm³
        QTest::addColumn<double>("area");   // mm²
        QTest::newRow("box") << TopoDS_Shape(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape()) << 1000.0 << 600.0;
        QTest::newRow("cone with an apex")
            << TopoDS_Shape(BRepPrimAPI_MakeCone(3.0, 0.0, 4.0).Shape()) << 12.0 * pi << 24.0 * pi;
        QTest::newRow("sphere") << TopoDS_Shape(BRepPrimAPI_MakeSphere(3.0).Shape()) << 36.0 * pi << 36.0 * pi;
        QTest::newRow("torus") << TopoDS_Shape(BRepPrimAPI_MakeTorus(5.0, 2.0).Shape()) << 40.0 * pi * pi
                               << 40.0 * pi * pi;
    }
    void soundSolidsAreMeshedOnce() {
        QFETCH(TopoDS_Shape, solid);
        QFETCH(double, volume);
        QFETCH(double, area);
        const SolidMesh mesh = meshed(solid);
        QCOMPARE(mesh.attempts, std::size_t{1});
        QCOMPARE(mesh.openEdges, std::size_t{0});
        QVERIFY(mesh.torn.IsNull());
        QVERIFY(std::abs(signedVolume(mesh.mesh) - volume) <= chord * area);
        QVERIFY(std::abs(surfaceArea(mesh.mesh) / area - 1.0) < 0.02);
    }

    /// Where three rounded edges meet there is a corner with a pole; OpenCASCADE's own refinement of triangles to the
    /// chord did not terminate there.
    void roundedCornersAreMeshed_data() {
        QTest::addColumn<TopoDS_Shape>("solid");
        const TopoDS_Shape block = roundedBlock();
        QTest::newRow("by formula") << block;
        QTest::newRow("as splines") << BRepBuilderAPI_NurbsConvert(block).Shape();
    }
    void roundedCornersAreMeshed() {
        QFETCH(TopoDS_Shape, solid);
        constexpr double fine = 0.005; // mm
        const SolidMesh mesh =
            meshSolid(TopoDS::Solid(TopExp_Explorer(solid, TopAbs_SOLID).Current()), fine, [](double) {});
        QCOMPARE(mesh.openEdges, std::size_t{0});
        QVERIFY(mesh.torn.IsNull());
        QVERIFY(std::abs(signedVolume(mesh.mesh) - roundedVolume) < fine * roundedArea);
        // In both directions around a corner 8 segments of 0.15 rad and 0.005 mm make a quarter of 6 mm; ten times that
        // is ample.
        QVERIFY(mesh.mesh.triangles.size() < 100'000);
    }

    /// No mesh can close a gap of the shape, and each attempt on a large one takes many seconds.
    void aGapOfTheShapeIsMeshedOnce() {
        const SolidMesh mesh = meshed(openBox());
        QCOMPARE(mesh.openEdges, std::size_t{4});
        QCOMPARE(mesh.attempts, std::size_t{1});
        QVERIFY(mesh.torn.IsNull());
    }
};

BURIN_TEST(TestSolidMesh, QCoreApplication)

} // namespace burin::tst_solid_mesh

#include "tst_solid_mesh.moc"
