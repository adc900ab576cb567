// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/solid_mesh.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include <QtTest>

using namespace burin;

Q_DECLARE_METATYPE(TopoDS_Shape)

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
    /// Seams, poles and an apex are no holes.
    void soundSolidsAreMeshedOnce_data() {
        QTest::addColumn<TopoDS_Shape>("solid");
        QTest::newRow("box") << TopoDS_Shape(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape());
        QTest::newRow("cone with an apex") << TopoDS_Shape(BRepPrimAPI_MakeCone(5.0, 0.0, 8.0).Shape());
        QTest::newRow("sphere") << TopoDS_Shape(BRepPrimAPI_MakeSphere(5.0).Shape());
    }
    void soundSolidsAreMeshedOnce() {
        QFETCH(TopoDS_Shape, solid);
        const SolidMesh mesh = meshed(solid);
        QCOMPARE(mesh.attempts, std::size_t{1});
        QCOMPARE(mesh.openEdges, std::size_t{0});
        QVERIFY(mesh.torn.IsNull());
    }

    /// No mesh closes what the shape leaves open, and a large one takes many seconds each time.
    void aGapOfTheShapeIsMeshedOnce() {
        const SolidMesh mesh = meshed(openBox());
        QCOMPARE(mesh.openEdges, std::size_t{4});
        QCOMPARE(mesh.attempts, std::size_t{1});
        QVERIFY(mesh.torn.IsNull());
    }
};

QTEST_GUILESS_MAIN(TestSolidMesh)
#include "tst_solid_mesh.moc"
