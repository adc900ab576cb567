// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/outline.h"
#include "tests/test_program.h"

#include <QTest>
#include <rapidcheck.h>

#include <cmath>

namespace burin::tst_outline {

namespace {

Property protectedPart() {
    Property part;
    part.id = "part";
    part.machinability = Machinability::isProtected;
    return part;
}

/// The definition, taken literally: every scanline within the distance contains the part.
bool slowlyContains(const std::vector<bool>& held, int width, int height, int u, int v, double limit) {
    const int reach = static_cast<int>(std::ceil(limit)) + 1;
    for (int dv = -reach; dv <= reach; ++dv)
        for (int du = -reach; du <= reach; ++du) {
            const int otherU = u + du, otherV = v + dv;
            const bool outside = otherU < 0 || otherV < 0 || otherU >= width || otherV >= height ||
                                 !held[static_cast<std::size_t>(otherV * width + otherU)];
            if (outside && du * du + dv * dv <= limit * limit) return false;
        }
    return true;
}

} // namespace

class OutlineTest : public QObject {
    Q_OBJECT
private slots:
    void shrinksAsTheDefinitionSays();
};

void OutlineTest::shrinksAsTheDefinitionSays() {
    const bool holds = rc::check("shrunk outline equals the definition", [] {
        const int width = *rc::gen::inRange(1, 14), height = *rc::gen::inRange(1, 14);
        const double distance = 0.25 * *rc::gen::inRange(0, 16);
        const auto cells =
            *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(width * height), rc::gen::inRange(0, 8));
        PropertyList list;
        const PropertyIndex part = list.add(protectedPart()).value();
        RunVolume volume =
            std::move(RunVolume::make(*Grid::make(glm::dvec3(0.0), 0.5, {width, height, 4}), list)).value();
        std::vector<bool> held(cells.size());
        for (int v = 0; v < height; ++v)
            for (int u = 0; u < width; ++u) {
                const auto place = static_cast<std::size_t>(v * width + u);
                held[place] = cells[place] > 0;
                if (held[place]) RC_ASSERT(volume.fillSpan({u, v}, 100, 300, part));
            }
        const ShrunkOutline outline(volume, distance);
        for (int v = 0; v < height; ++v)
            for (int u = 0; u < width; ++u)
                RC_ASSERT(outline.contains(0.5 * u + 0.25, 0.5 * v + 0.25) ==
                          slowlyContains(held, width, height, u, v, distance / 0.5));
        RC_ASSERT(!outline.contains(-1.0, 0.1));
    });
    QVERIFY(holds);
}

BURIN_TEST(OutlineTest, NoApplication)

} // namespace burin::tst_outline

#include "tst_outline.moc"
