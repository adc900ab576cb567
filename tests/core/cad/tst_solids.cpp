// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/solids.h"
#include "tests/test_program.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
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
};

BURIN_TEST(TestSolids, NoApplication)

} // namespace burin::tst_solids

#include "tst_solids.moc"
