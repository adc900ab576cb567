// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/operator/virtual_operator.h"
#include "core/passes/milling_plan.h"
#include "tests/core/passes/planned_fields.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>

namespace burin::tst_operator_session {

using namespace burin::test;

namespace {

constexpr double voxel = 0.5;

/// A block of stock around a protected capsule, both exact along z.
std::optional<RunVolume> workpieceAround(const LyingCapsule& part, const Box& stock) {
    PropertyList properties;
    Property aluminium;
    aluminium.id = "aluminium";
    aluminium.values[std::string(specificCuttingEnergy)] = {0.7, "J/mm^3", "for this test", true};
    aluminium.values[std::string(radialForceRatio)] = {0.3, "1", "for this test", true};
    const auto stockProperty = properties.add(aluminium);
    aluminium.id = "part";
    aluminium.machinability = Machinability::isProtected;
    const auto partProperty = properties.add(aluminium);
    const glm::ivec3 count(glm::round(stock.size() / voxel));
    const auto grid = Grid::make(stock.low, voxel, count);
    if (!stockProperty || !partProperty || !grid) return std::nullopt;
    auto volume = RunVolume::make(*grid, properties);
    if (!volume) return std::nullopt;
    volume->fillBlock({0, 0}, {count.x, count.y}, 0, grid->lineEnd(), *stockProperty);
    for (int u = 0; u < count.x; ++u)
        for (int v = 0; v < count.y; ++v) {
            const glm::dvec2 centre = grid->lineCentre({u, v});
            const double top = part.top(centre.x, centre.y);
            if (top > 0.0) volume->fillSpan({u, v}, grid->toRunPosition(0.0), grid->toRunPosition(top), *partProperty);
        }
    return std::move(*volume);
}

/// Mills an intended motion as the servo loop does, without a clock.
std::vector<Sample> mill(RunVolume& workpiece, const ClearanceField& field, const Tool& tool, HapticSettings settings,
                         const std::vector<IntentPoint>& intent, double allowance) {
    OperatorSettings who;
    settings.allowance = allowance;
    settings.stylus = who.stylus;
    VirtualOperator hand(intent, settings.mapping, who);
    std::vector<Sample> samples;
    if (!hand.open()) return samples;
    HapticStep step(workpiece, field, tool, settings);
    for (int tick = 0; tick < 1000000 && !hand.finished(); ++tick) {
        samples.push_back(step.advance(hand.read(tick * settings.tickPeriod), settings.tickPeriod));
        hand.write(step.deviceWrench());
    }
    return samples;
}

std::size_t ticksWith(SampleFlag flag, const std::vector<Sample>& samples) {
    return static_cast<std::size_t>(
        std::ranges::count_if(samples, [flag](const Sample& sample) { return (sample.flags & flag) != 0; }));
}

} // namespace

class OperatorSessionTest final : public QObject {
    Q_OBJECT
private slots:
    void theOperatorMillsAPartOutOfItsStock();
};

void OperatorSessionTest::theOperatorMillsAPartOutOfItsStock() {
    LyingCapsule part(3.0, 12.0, 10.0, 3.0); // 44 x 24 x 15 mm
    part.answerGradients();
    const Tool tool = shankedBallTool();
    MillingRequest request;
    request.stock = {part.box().low - glm::dvec3(5.0), part.box().high + glm::dvec3(5.0)};
    request.finishing.part = part.box();
    request.finishing.stepOver = 0.8;
    const Result<MillingPlan> plan = planMilling(part, tool, request);
    QVERIFY(plan);
    std::optional<RunVolume> workpiece = workpieceAround(part, request.stock);
    QVERIFY(workpiece);
    HapticSettings settings;
    Box region = request.stock.grown(tool.cutter.radius() + 2.0);
    region.high.z = request.stock.high.z + travelHeight + 2.0;
    settings.mapping = mappingFor(region, touchLikeStylus());

    const std::vector<Sample> roughing = mill(*workpiece, part, tool, settings, plan->roughing, 0.5);
    QVERIFY(roughing.size() > 5000);
    QCOMPARE(ticksWith(sampleShankContact, roughing), std::size_t{0});
    for (const Sample& sample : roughing) QVERIFY(part.at(sample.proxy.tip).clearance > 0.5 - 0.05 * voxel);
    // The hand has a tremor near the part but is not dragged along it.
    const std::size_t onBoundary = ticksWith(sampleOnBoundary, roughing);
    QVERIFY2(onBoundary < roughing.size() / 20, qPrintable(QString::number(onBoundary)));

    const std::vector<Sample> finishing = mill(*workpiece, part, tool, settings, plan->finishing, 0.0);
    QCOMPARE(ticksWith(sampleShankContact, finishing), std::size_t{0});
    std::size_t over = 0, near = 0, crest = 0;
    double press = 0.0, deepest = 0.0, highest = 0.0;
    for (const Sample& sample : finishing) {
        const glm::dvec3& tip = sample.proxy.tip;
        const double clearance = part.at(tip).clearance;
        deepest = std::min(deepest, clearance);
        if (tip.z > request.stock.high.z + 0.5 || part.top(tip.x, tip.y) < 8.0) continue; // moving between cuts
        ++over;
        near += clearance < 0.1 ? 1 : 0;
        if (part.at(tip).gradient.z < 0.97) continue; // where the hand presses perpendicular to the part
        ++crest;
        press += glm::distance(tip, sample.stylusTip);
    }
    press /= static_cast<double>(std::max<std::size_t>(crest, 1));
    for (int u = 0; u < workpiece->grid().lineCountU(); ++u)
        for (int v = 0; v < workpiece->grid().lineCountV(); ++v) {
            const glm::dvec2 centre = workpiece->grid().lineCentre({u, v});
            if (part.top(centre.x, centre.y) < 11.0) continue; // steeper than 48 degrees: wider ridges
            double top = -1e9;
            for (const Segment& segment : workpiece->line({u, v}))
                if (segment.property() != airProperty) top = workpiece->grid().toMillimetres(segment.end());
            highest = std::max(highest, top - part.top(centre.x, centre.y));
        }
    qInfo("%zu + %zu ticks; of %zu over the part %.2f %% within 0.1 mm; pressed %.2f mm in the mean; least clearance "
          "%.4f mm; left at most %.3f mm",
          roughing.size(), finishing.size(), over, 100.0 * static_cast<double>(near) / static_cast<double>(over), press,
          deepest, highest);
    QVERIFY(over > 5000 && crest > 1000);
    QVERIFY(near * 100 > over * 97);
    QVERIFY(press > 1.5 && press < 2.1);
    QVERIFY(deepest > -0.05 * voxel);
    QVERIFY(highest < 0.15);
}

BURIN_TEST(OperatorSessionTest, NoApplication)

} // namespace burin::tst_operator_session

#include "tst_operator_session.moc"
