// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/solids.h"

#include "core/cad/reader/measure.h"
#include "tests/test_program.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <QtTest>

namespace burin::tst_solids {

class TestSolids : public QObject {
    Q_OBJECT

private slots:
    /// As in a sample file of OpenCASCADE: a shell was deleted, but its solid was kept. The rest of the model is
    /// usable.
    void aSolidWithoutFacesIsLeftOut() {
        TopoDS_Solid empty;
        BRep_Builder().MakeSolid(empty);
        CadFile file;
        file.shapes = {{empty, "", {}}, {BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Solid(), "block", {}}};
        const Result<std::vector<NamedSolid>> solids = makeSolids(file);
        QVERIFY(solids);
        QCOMPARE(solids->size(), std::size_t{1});
        QCOMPARE(solids->front().name, std::string("block"));
        QCOMPARE(file.notes.size(), std::size_t{1});
        QCOMPARE(file.notes.front().text, std::string("Solid 1 has no faces and was left out."));
        file.shapes.pop_back();
        QCOMPARE(makeSolids(file).error().code, ErrorCode::modelHasNoSolid);
    }

    /// Six faces of a cube, each an entry of its own with its own colour, as in IGES files: after sewing each side of
    /// the cube has its colour.
    void sewnFacesKeepTheirColours() {
        CadFile file;
        std::uint8_t number = 0;
        for (TopExp_Explorer faces(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape(), TopAbs_FACE); faces.More();
             faces.Next(), ++number)
            file.shapes.push_back({BRepBuilderAPI_Copy(faces.Current()).Shape(), "", BodyColour({number, 0, 0})});
        const std::vector<NamedShape> before = file.shapes;
        const Result<std::vector<NamedSolid>> solids = makeSolids(file);
        QVERIFY(solids);
        QCOMPARE(solids->size(), std::size_t{1});
        const NamedSolid& cube = solids->front();
        QCOMPARE(cube.faceColours.size(), std::size_t{6});
        std::size_t i = 0;
        for (TopExp_Explorer faces(cube.solid, TopAbs_FACE); faces.More(); faces.Next(), ++i)
            for (const NamedShape& entry : before)
                if (glm::distance(exactBox(entry.shape).centre(), exactBox(faces.Current()).centre()) < 1e-6)
                    QVERIFY(cube.faceColours[i] == entry.colour);
    }

    /// A cube with one face turned inside out is repaired; the colours of its faces stay where they are.
    void repairedFacesKeepTheirColours() {
        TopoDS_Shell shell;
        BRep_Builder builder;
        builder.MakeShell(shell);
        std::vector<TopoDS_Shape> sides;
        for (TopExp_Explorer faces(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape(), TopAbs_FACE); faces.More();
             faces.Next())
            sides.push_back(sides.size() == 3 ? faces.Current().Reversed() : faces.Current());
        for (const TopoDS_Shape& side : sides) builder.Add(shell, side);
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, shell);
        NamedShape entry{solid, "cube", {}};
        for (std::uint8_t i = 0; i < 6; ++i) entry.faceColours.push_back(BodyColour({i, 0, 0}));
        CadFile file;
        file.shapes = {entry};
        const Result<std::vector<NamedSolid>> solids = makeSolids(file);
        QVERIFY(solids);
        QVERIFY(!file.notes.empty());
        QCOMPARE(file.notes.front().kind, ImportNote::Kind::healing);
        QCOMPARE(solids->front().faceColours.size(), std::size_t{6});
        std::size_t i = 0;
        for (TopExp_Explorer faces(solids->front().solid, TopAbs_FACE); faces.More(); faces.Next(), ++i)
            for (std::uint8_t k = 0; k < 6; ++k)
                if (glm::distance(exactBox(sides[k]).centre(), exactBox(faces.Current()).centre()) < 1e-6)
                    QVERIFY(solids->front().faceColours[i] == BodyColour({k, 0, 0}));
    }
};

BURIN_TEST(TestSolids, NoApplication)

} // namespace burin::tst_solids

#include "tst_solids.moc"
