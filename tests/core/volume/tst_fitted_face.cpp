// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/volume/surface/fitted_face.h"
#include "tests/core/volume/surfaces.h"
#include "tests/core/volume/volumes.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_fitted_face {

using namespace burin::test;

namespace {

using Kind = FittedSurface::Kind;

constexpr double edge = 0.5, top = 27.3; // mm
constexpr double turn = 0.0767;          // rad, of the oblique slot

/// A block of 80 x 60 x 27.3 mm with what a mill cuts into it; everything off the lattice of the voxels.
class CutBlock {
public:
    CutBlock() : volume_(emptyVolume(*Grid::make(glm::dvec3(0.0), edge, {160, 120, 60}))) {
        const Grid& grid = volume_.grid();
        (void)volume_.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, 0, grid.toRunPosition(top), wax);
        cut(15.2, [](const glm::dvec2& at) { return at.y > 10.13 && at.y < 20.41; });
        for (const glm::dvec3& hole : {glm::dvec3(15.2, 40.3, 5.0), {35.0, 40.0, 1.5}, {60.3, 42.7, 12.0}})
            cut(5.1, [&](const glm::dvec2& at) { return glm::length(at - glm::dvec2(hole)) < hole.z; });
        cut(20.0, [](const glm::dvec2& at) {
            const double across = (at.x - 5.0) * -std::sin(turn) + (at.y - 26.0) * std::cos(turn);
            return across > 0.0 && across < 2.5;
        });
        cutBelow([](const glm::dvec2& at) { // a ball end of 6 mm, sunk to its centre
            return top - std::sqrt(36.0 - std::pow(at.x - 72.0, 2) - std::pow(at.y - 9.0, 2));
        });
        cutBelow([](const glm::dvec2& at) { // a ball end of 4 mm, along y
            return at.y > 22.0 && at.y < 30.0 ? 25.0 - std::sqrt(16.0 - std::pow(at.x - 66.2, 2)) : std::nan("");
        });
        cutBelow([](const glm::dvec2& at) { // free-form
            return at.y < 8.0 && at.x < 40.0 ? 24.0 + std::sin(0.9 * at.x) * std::cos(0.8 * at.y) : std::nan("");
        });
    }
    VolumeSnapshot snapshot() { return volume_.snapshot(); }

private:
    template <class Inside>
    void cut(double floor, Inside inside) {
        fillLines(volume_, airProperty,
                  [&](const glm::dvec2& at) { return inside(at) ? std::pair(floor, 30.0) : std::pair(0.0, 0.0); });
    }
    template <class Floor>
    void cutBelow(Floor floorAt) {
        fillLines(volume_, airProperty, [&](const glm::dvec2& at) {
            const double floor = floorAt(at);
            return std::isnan(floor) ? std::pair(0.0, 0.0) : std::pair(floor, 30.0);
        });
    }
    RunVolume volume_;
};

} // namespace

class FittedFaceTest : public QObject {
    Q_OBJECT
private slots:
    void levelFacesAreExact();
    void shallowSlotsHaveLevelFloors();
    void wallsAreKnownToHalfAVoxel();
    void roundFacesHaveTheirRadius();
    void anEdgeAndAWaveHaveNoSurface();
    void thereIsNoFaceInAir();
    void fitsGoThroughTheirPoints();

private:
    FittedFace at(const glm::dvec3& place) {
        const std::optional<FittedFace> face = fittedFaceAt(block_.snapshot(), place);
        return face.value_or(FittedFace{});
    }
    void isRound(const glm::dvec3& place, Kind kind, double radius);

    CutBlock block_;
};

/// Floors and tops: run ends, to 1/200 voxel.
void FittedFaceTest::levelFacesAreExact() {
    for (const auto& [place, height] : {std::pair(glm::dvec3(30.0, 15.0, 15.0), 15.2),
                                        {{15.0, 40.0, 5.0}, 5.1},
                                        {{30.0, 55.0, 27.0}, top},
                                        {{50.0, 55.0, 0.1}, 0.0}}) {
        const FittedFace face = at(place);
        QVERIFY(face.surface && face.surface->kind == Kind::plane);
        QVERIFY2(std::abs(face.place.z - height) <= edge / 200.0, qPrintable(QString::number(face.place.z)));
        QVERIFY(std::abs(std::abs(face.normal.z) - 1.0) < 1e-6);
        QCOMPARE(face.within, edge / 200.0);
    }
}

/// Slots that are hardly deeper than the surface rounds their edges: an arc through floor and top would explain more
/// points than the floor alone, but none of them well.
void FittedFaceTest::shallowSlotsHaveLevelFloors() {
    for (const double depth : {0.6, 1.1, 1.6}) {
        RunVolume volume = emptyVolume(*Grid::make(glm::dvec3(0.0), edge, {100, 80, 60}));
        const Grid& grid = volume.grid();
        (void)volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, 0, grid.toRunPosition(top), wax);
        fillLines(volume, airProperty, [&](const glm::dvec2& at) {
            const glm::dvec2 nearest(std::clamp(at.x, 15.0, 35.0), 20.1);
            return glm::distance(at, nearest) < 5.0 ? std::pair(top - depth, 30.0) : std::pair(0.0, 0.0);
        });
        const std::optional<FittedFace> face = fittedFaceAt(volume.snapshot(), {25.07, 20.03, top - depth});
        QVERIFY(face && face->surface && face->surface->kind == Kind::plane);
        QVERIFY(std::abs(face->place.z - (top - depth)) <= edge / 200.0);
    }
}

/// Along the axes and obliquely; the angle is right within its stated bound.
void FittedFaceTest::wallsAreKnownToHalfAVoxel() {
    for (const auto& [place, y, normal] :
         {std::tuple(glm::dvec3(30.0, 10.0, 20.0), 10.13, 1.0), {{30.0, 20.4, 20.0}, 20.41, -1.0}}) {
        const FittedFace face = at(place);
        QVERIFY(face.surface && face.surface->kind == Kind::plane);
        QVERIFY(std::abs(face.place.y - y) <= face.within && face.within == 0.5 * edge);
        QVERIFY(std::abs(face.normal.y - normal) < 1e-4);
    }
    const glm::dvec3 across(-std::sin(turn), std::cos(turn), 0.0);
    const FittedFace oblique = at(glm::dvec3(5.0, 26.0, 24.0) + 32.0 * glm::dvec3(std::cos(turn), std::sin(turn), 0.0));
    QVERIFY(oblique.surface && oblique.surface->kind == Kind::plane);
    QVERIFY(std::abs(glm::dot(oblique.place - glm::dvec3(5.0, 26.0, 24.0), across)) <= oblique.within);
    QVERIFY(std::acos(std::min(1.0, glm::dot(oblique.normal, across))) <= oblique.angleWithin);
    QVERIFY(oblique.angleWithin < 3.0 * pi / 180.0);
}

void FittedFaceTest::isRound(const glm::dvec3& place, Kind kind, double radius) {
    const FittedFace face = at(place);
    QVERIFY(face.surface && face.surface->kind == kind);
    QVERIFY2(std::abs(face.surface->radius - radius) <= face.radiusWithin,
             qPrintable(QString::number(face.surface->radius)));
    QVERIFY(face.radiusWithin < 0.65 * edge); // seen over half a turn, or nearly
    QCOMPARE(face.surface->side, -1.0);       // hollow
}

/// Wherever on the hole they are picked; the axis of a vertical one is vertical.
void FittedFaceTest::roundFacesHaveTheirRadius() {
    isRound({20.2, 40.3, 15.0}, Kind::cylinder, 5.0);
    isRound({15.2, 45.3, 15.0}, Kind::cylinder, 5.0);
    isRound({15.2 - 5.0 * 0.8, 40.3 + 5.0 * 0.6, 10.0}, Kind::cylinder, 5.0);
    isRound({36.5, 40.0, 15.0}, Kind::cylinder, 1.5);
    isRound({72.3, 42.7, 15.0}, Kind::cylinder, 12.0);
    isRound({72.0, 9.0, 21.3}, Kind::sphere, 6.0);
    isRound({75.0, 9.0, 22.0}, Kind::sphere, 6.0);
    isRound({66.2, 26.0, 21.0}, Kind::cylinder, 4.0);
    const FittedFace hole = at({20.2, 40.3, 15.0});
    QVERIFY(std::abs(hole.surface->axis.z) > std::cos(hole.angleWithin));
    QVERIFY(glm::length(glm::dvec2(hole.surface->place) - glm::dvec2(15.2, 40.3)) < 0.5 * edge);
}

/// The rounding of an edge by the voxels is no radius, and a wave is neither plane, cylinder nor sphere.
void FittedFaceTest::anEdgeAndAWaveHaveNoSurface() {
    QVERIFY(!at({60.0, 10.13, top}).surface);
    QVERIFY(!at({0.0, 60.0, top}).surface);
    const FittedFace wave = at({10.0, 3.0, 24.0});
    QVERIFY(!wave.surface);
    QVERIFY(wave.normal.z > 0.5 && wave.within > 0.0);
    const double height = 24.0 + std::sin(0.9 * wave.place.x) * std::cos(0.8 * wave.place.y);
    QVERIFY(std::abs(wave.place.z - height) < 0.5 * edge);
}

void FittedFaceTest::thereIsNoFaceInAir() {
    RunVolume air = emptyVolume(cubeGrid({40, 40, 40}));
    QVERIFY(!fittedFaceAt(air.snapshot(), glm::dvec3(1.0)));
    QVERIFY(!fittedFaceAt(VolumeSnapshot(), glm::dvec3(1.0)));
    QVERIFY(!fittedFaceAt(block_.snapshot(), glm::dvec3(std::nan(""))));
    const std::optional<FittedFace> far = fittedFaceAt(block_.snapshot(), {-500.0, 45.0, 10.0});
    QVERIFY(far && std::abs(far->place.x) < 0.5 * edge && far->normal.x < -0.99);
}

/// Exact points of a plane, a cylinder and a sphere, each seen in part, in any direction.
void FittedFaceTest::fitsGoThroughTheirPoints() {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -0.5, 0.8)), centre(100.0, -40.0, 7.0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, glm::dvec3(1.0, 0.0, 0.0))), v = glm::cross(axis, u);
    std::vector<SurfacePoint> plane, cylinder, sphere;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            const double angle = 0.08 * i, along = 0.3 * j;
            const glm::dvec3 out = std::cos(angle) * u + std::sin(angle) * v;
            plane.push_back({centre + 0.2 * i * u + along * v, axis});
            cylinder.push_back({centre + 6.5 * out + along * axis, -out});
            const glm::dvec3 up = std::cos(0.06 * j) * out + std::sin(0.06 * j) * axis;
            sphere.push_back({centre + 9.25 * up, up});
        }
    const auto flat = fitSurface(Kind::plane, plane), round = fitSurface(Kind::cylinder, cylinder),
               ball = fitSurface(Kind::sphere, sphere);
    QVERIFY(flat && round && ball);
    QVERIFY(glm::length(flat->axis - axis) < 1e-9 && std::abs(flat->distance(centre)) < 1e-9);
    QVERIFY(std::abs(round->radius - 6.5) < 1e-7 && std::abs(glm::dot(round->axis, axis)) > 1.0 - 1e-12);
    QCOMPARE(round->side, -1.0);
    QVERIFY(std::abs(ball->radius - 9.25) < 1e-7 && glm::length(ball->place - centre) < 1e-6 && ball->side == 1.0);
    QVERIFY(!fitSurface(Kind::sphere, plane)); // no finite radius
    QVERIFY(!fitSurface(Kind::plane, std::span(plane).first(2)));
}

BURIN_TEST(FittedFaceTest, NoApplication)

} // namespace burin::tst_fitted_face

#include "tst_fitted_face.moc"
