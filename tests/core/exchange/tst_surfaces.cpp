// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cad/import.h"
#include "core/exchange/surface_file.h"
#include "core/volume/voxelisation/voxelisation.h"
#include "tests/core/volume/shapes.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <assimp/Importer.hpp>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace burin::tst_surfaces {

using namespace burin::test;

namespace {

/// A ball of one material in a block of another, on a grid that is not aligned with it.
RunVolume ballInBlock() {
    PropertyList list;
    Property wax, steel;
    wax.id = wax.name = "wax";
    steel.id = steel.name = "steel";
    steel.colour = {200, 30, 30};
    const PropertyIndex block = *list.add(wax), ball = *list.add(steel);
    RunVolume volume = *RunVolume::make(*Grid::make(glm::dvec3(-0.3), 0.5, {70, 70, 70}), list);
    Progress progress;
    const TriangleMesh box = boxMesh({2.2, 2.2, 2.2}, {27.7, 20.1, 15.3}), sphere = sphereMesh({15, 15, 16}, 9.0, 200);
    if (!voxelise(box, block, volume, progress) || !voxelise(sphere, ball, volume, progress)) qFatal("no volume");
    return volume;
}

double volumeOf(const RunVolume& volume) {
    return static_cast<double>(volume.amounts().units[1] + volume.amounts().units[2]) * volume.grid().unitVolume();
}

} // namespace

class TestSurfaces : public QObject {
    Q_OBJECT

private slots:
    void theSurfaceIsClosedAndHoldsTheVolume() {
        RunVolume volume = ballInBlock();
        Progress progress;
        const auto surface = surfaceOf(volume.snapshot(), progress);
        QVERIFY(surface);
        QCOMPARE(countOpenEdges(surface->mesh), std::size_t{0});
        QCOMPARE(surface->materials.size(), surface->mesh.triangles.size());
        const double enclosed = signedVolume(surface->mesh), exact = volumeOf(volume);
        QVERIFY2(std::abs(enclosed / exact - 1.0) < 0.01, qPrintable(QString::number(enclosed / exact)));
    }

    /// Read back by an independent reader.
    void stlIsReadBackByOpenCascade() {
        RunVolume volume = ballInBlock();
        Progress progress;
        const auto surface = surfaceOf(volume.snapshot(), progress);
        const QTemporaryDir folder;
        const auto file = folder.filePath("out.stl").toStdString();
        QVERIFY(writeSurfaceFile(file, *surface, volume.properties()));
        ImportOptions options;
        options.worker = BURIN_BUILD_DIRECTORY "/burin-import";
        const auto model = importModel(file, options, progress);
        QVERIFY(model);
        QCOMPARE(model->bodies.size(), std::size_t{1});
        QCOMPARE(model->bodies[0].openEdges, std::size_t{0});
        QVERIFY(std::abs(model->volume() / volumeOf(volume) - 1.0) < 0.01);
    }

    void eachFormIsWhatItSays() {
        RunVolume volume = ballInBlock();
        Progress progress;
        const auto surface = surfaceOf(volume.snapshot(), progress);
        const QTemporaryDir folder;
        for (const auto& [name, begins] :
             {std::pair("a.ply", "ply"), std::pair("a.3mf", "PK"), std::pair("A.STL", "")}) {
            const QString file = folder.filePath(name);
            QVERIFY(isSurfaceFile(file.toStdString()));
            QVERIFY2(writeSurfaceFile(file.toStdString(), *surface, volume.properties()), name);
            QFile written(file);
            QVERIFY(written.open(QIODevice::ReadOnly));
            QVERIFY(written.size() > 100'000);
            QVERIFY(written.readAll().startsWith(begins));
        }
        const auto other = writeSurfaceFile(folder.filePath("a.fbx").toStdString(), *surface, volume.properties());
        QVERIFY(!other && other.error().code == ErrorCode::notSupported);
        QVERIFY(!writeSurfaceFile("/no/such/folder/a.stl", *surface, volume.properties()));
        QVERIFY(!writeSurfaceFile("/no/such/folder/a.3mf", *surface, volume.properties()));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 3); // no other file is left
    }

    /// Each material has a mesh of its own, in its colour; together they form the surface.
    void threeMfKeepsMaterialsApart() {
        RunVolume volume = ballInBlock();
        Progress progress;
        const auto surface = surfaceOf(volume.snapshot(), progress);
        const QTemporaryDir folder;
        const std::string file = folder.filePath("a.3mf").toStdString();
        QVERIFY(writeSurfaceFile(file, *surface, volume.properties()));
        Assimp::Importer importer;
        const aiScene* const scene = importer.ReadFile(file, 0);
        QVERIFY(scene != nullptr);
        QCOMPARE(scene->mNumMeshes, 2U);
        double enclosed = 0.0;
        for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
            const aiMesh& mesh = *scene->mMeshes[i];
            for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
                const auto corner = [&](unsigned place) {
                    const aiVector3D& at = mesh.mVertices[mesh.mFaces[face].mIndices[place]];
                    return glm::dvec3(at.x, at.y, at.z);
                };
                enclosed += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
            }
        }
        QVERIFY(std::abs(enclosed / volumeOf(volume) - 1.0) < 0.01);
    }

    void airHasNoSurface() {
        PropertyList list;
        RunVolume volume = *RunVolume::make(*Grid::make(glm::dvec3(0.0), 0.5, {8, 8, 8}), list);
        Progress progress;
        const auto surface = surfaceOf(volume.snapshot(), progress);
        QVERIFY(surface && surface->mesh.triangles.empty());
        QVERIFY(!writeSurfaceFile("never.stl", *surface, list));
    }
};

BURIN_TEST(TestSurfaces, QCoreApplication)

} // namespace burin::tst_surfaces

#include "tst_surfaces.moc"
