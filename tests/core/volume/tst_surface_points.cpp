// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_cubes.h"
#include "core/volume/surface/surface_points.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace burin::tst_surface_points {

namespace {

constexpr int columns = 20, stride = 16;
constexpr std::size_t places = columns * stride;

/// A random row of a field.
struct RandomRow {
    std::vector<std::int16_t> values, smooth;
    std::vector<std::uint64_t> below;

    SurfaceField::Row row() const { return {values.data(), smooth.data(), below.data()}; }
};

RandomRow drawRow() {
    const auto some =
        rc::gen::container<std::vector<std::int16_t>>(places, rc::gen::inRange<std::int16_t>(-4096, 4097));
    RandomRow row{*some, *some, std::vector<std::uint64_t>(columns)};
    for (std::size_t place = 0; place < places; ++place)
        row.below[place / stride] |= std::uint64_t{row.values[place] < 0} << place % stride;
    return row;
}

/// The cubes between some rows, up to the size of a batch.
void addCubes(const std::vector<RandomRow>& rows, SurfaceBatch& batch) {
    const SurfaceCubes::Owned all{0, columns - 1, (std::uint64_t{1} << (stride - 1)) - 1};
    std::vector<std::uint32_t> pointAt(places);
    SurfaceCubes cubes;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        const std::array<SurfaceField::Row, 2> pair{rows[i].row(), rows[i + 1].row()};
        cubes.find(pair, stride, all);
        const auto some = cubes.listed().first(static_cast<std::size_t>(
            *rc::gen::inRange(0, static_cast<int>(std::min<std::size_t>(cubes.listed().size(), 60)) + 1)));
        (void)batch.add(some, {pair, static_cast<std::uint32_t>(i), stride}, pointAt.data(), 0);
    }
}

SurfaceFrame drawFrame() {
    SurfaceFrame frame;
    frame.stride = stride;
    frame.placesPerRow = places;
    frame.firstU = *rc::gen::inRange(-3, 4000);
    frame.firstV = *rc::gen::inRange(-3, 4000);
    frame.firstNode = *rc::gen::inRange(-3, 4000);
    frame.firstEdgeColumn = *rc::gen::inRange(0, columns);
    frame.firstEdgeRow = *rc::gen::inRange(0, 3);
    frame.firstEdgeNode = *rc::gen::inRange(0, stride);
    frame.axisOfRuns = *rc::gen::inRange(0, 3);
    frame.low = {-3.0F, 5.0F, 1.0F};
    frame.size = 0.25F;
    return frame;
}

struct Placed {
    std::vector<glm::vec3> points, normals;
    SurfaceEdges edges;
    explicit Placed(std::size_t cubes) : points(cubes + SurfaceFrame::spare), normals(cubes + SurfaceFrame::spare) {}
};

bool isSame(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b, std::size_t count) {
    return std::memcmp(a.data(), b.data(), count * sizeof(glm::vec3)) == 0;
}

} // namespace

class TestSurfacePoints : public QObject {
    Q_OBJECT

private slots:
    void everyProcessorPlacesTheSamePoints();
    void edgesAreTheirCubesOwn();
};

void TestSurfacePoints::everyProcessorPlacesTheSamePoints() {
    QVERIFY(rc::check("with registers of sixteen numbers and of eight, to the last bit", [] {
        SurfaceBatch batch;
        addCubes(*rc::gen::exec([] { return std::vector{drawRow(), drawRow(), drawRow(), drawRow()}; }), batch);
        const SurfaceFrame frame = drawFrame();
        Placed widest(batch.count()), eight(batch.count());
        placeSurfacePoints(frame, batch, widest.points.data(), widest.normals.data(), widest.edges);
        any_processor::placeSurfacePoints(frame, batch, eight.points.data(), eight.normals.data(), eight.edges);
        RC_ASSERT(isSame(widest.points, eight.points, batch.count()));
        RC_ASSERT(isSame(widest.normals, eight.normals, batch.count()));
        for (std::size_t axis = 0; axis < 3; ++axis)
            RC_ASSERT(std::ranges::equal(widest.edges.listed(axis), eight.edges.listed(axis)));
    }));
}

/// For each cube the three edges at its lowest corner are checked one by one.
void TestSurfacePoints::edgesAreTheirCubesOwn() {
    QVERIFY(rc::check("each edge whose ends lie on either side, from the first that are owned on", [] {
        const std::vector<RandomRow> rows = *rc::gen::exec([] {
            return std::vector{drawRow(), drawRow(), drawRow(), drawRow()};
        });
        SurfaceBatch batch;
        addCubes(rows, batch);
        const SurfaceFrame frame = drawFrame();
        std::array<std::vector<std::uint32_t>, 3> expected;
        for (std::size_t i = 0; i < batch.count(); ++i) {
            const std::uint32_t cube = batch.cubes()[i], place = cube & SurfaceBatch::placeMask;
            const std::size_t row = cube >> SurfaceBatch::rowShift, column = place / stride, node = place % stride;
            const std::array<std::int16_t, 3> far{rows[row].values[place + stride], rows[row + 1].values[place],
                                                  rows[row].values[place + 1]};
            const bool inside = rows[row].values[place] >= 0;
            const bool owned = std::cmp_greater_equal(column, frame.firstEdgeColumn) &&
                               std::cmp_greater_equal(row, frame.firstEdgeRow) &&
                               std::cmp_greater_equal(node, frame.firstEdgeNode);
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (owned && inside != (far[axis] >= 0))
                    expected[axis].push_back(static_cast<std::uint32_t>(place + row * places) |
                                             (inside ? SurfaceEdges::insideBit : 0));
        }
        Placed placed(batch.count());
        placeSurfacePoints(frame, batch, placed.points.data(), placed.normals.data(), placed.edges);
        for (std::size_t axis = 0; axis < 3; ++axis)
            RC_ASSERT(std::ranges::equal(placed.edges.listed(axis), expected[axis]));
    }));
}

BURIN_TEST(TestSurfacePoints, NoApplication)

} // namespace burin::tst_surface_points

#include "tst_surface_points.moc"
