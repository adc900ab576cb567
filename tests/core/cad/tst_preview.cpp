// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/preview.h"
#include "tests/core/cad/rounded_block.h"
#include "tests/test_program.h"

#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <TopLoc_Location.hxx>

#include <QCoreApplication>
#include <QtTest>

namespace burin::tst_preview {

namespace {

constexpr double chord = 0.005; // mm, of the mesh made afterwards

NamedSolid named(const TopoDS_Shape& shape, const char* name) {
    return {TopoDS::Solid(TopExp_Explorer(shape, TopAbs_SOLID).Current()), name, std::nullopt};
}

bool hasTriangles(const TopoDS_Shape& shape) {
    TopLoc_Location place;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
        if (!BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), place).IsNull()) return true;
    return false;
}

} // namespace

class TestPreview : public QObject {
    Q_OBJECT

private slots:
    /// A ball's triangles look smooth, and the preview has no effect on the final mesh of the solid.
    void aBallLooksLikeOne() {
        std::vector<NamedSolid> solids{named(BRepPrimAPI_MakeSphere(30.0).Shape(), "ball"), named(roundedBlock(), "")};
        solids.front().colour = {{10, 20, 30}};
        const std::optional<ModelPreview> preview = previewOf(solids, chord);
        QVERIFY(preview);
        QCOMPARE(preview->bodies.size(), std::size_t{2});
        QCOMPARE(preview->bodies[0].name, std::string("ball"));
        QVERIFY(preview->bodies[0].colour == solids.front().colour);
        QCOMPARE(preview->bodies[1].name, std::string("Body 2"));
        const PreviewMesh& ball = preview->bodies[0].mesh;
        QVERIFY(ball.triangles.size() > 100 && ball.triangles.size() < 5000);
        for (const auto& triangle : ball.triangles) {
            glm::vec3 centre(0.0F);
            for (const std::uint32_t corner : triangle) centre += ball.vertices[corner] / 3.0F;
            QVERIFY(glm::length(centre) > 30.0F - 1.5F && glm::length(centre) < 30.001F);
        }
        for (const NamedSolid& solid : solids) QVERIFY(!hasTriangles(solid.solid));
    }
    /// Their mesh takes no noticeable time.
    void planeAndTinyPartsNeedNone() {
        const std::vector<NamedSolid> plane{named(BRepPrimAPI_MakeBox(100.0, 50.0, 20.0).Shape(), "plate")};
        QVERIFY(!previewOf(plane, chord));
        const std::vector<NamedSolid> tiny{named(BRepPrimAPI_MakeSphere(1.0).Shape(), "bead")};
        QVERIFY(!previewOf(tiny, chord));
        QVERIFY(!previewOf({}, chord));
    }
};

BURIN_TEST(TestPreview, QCoreApplication)

} // namespace burin::tst_preview

#include "tst_preview.moc"
