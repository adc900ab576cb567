// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/document/sample_project.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace burin::fixture {

namespace {

/// Noise from -1 to 1 that depends only on its seed.
double noise(std::uint64_t seed) {
    std::uint64_t word = (seed + 1) * 0x9E3779B97F4A7C15u;
    word ^= word >> 32;
    word *= 0xD6E8FEB86659FD93u;
    word ^= word >> 32;
    return static_cast<double>(word >> 11) * 0x1p-52 - 1.0;
}

glm::dvec3 noiseVector(std::uint64_t seed, double amplitude) {
    return amplitude * glm::dvec3(noise(3 * seed), noise(3 * seed + 1), noise(3 * seed + 2));
}

Sample handSample(std::size_t index) {
    Sample sample;
    sample.tick = index;
    sample.time = static_cast<double>(index) * 0.001;
    const double angle = 2.0 * sample.time;
    const glm::dvec3 hand(30.0 * std::cos(angle), 30.0 * std::sin(angle), -4.0 * std::sin(0.3 * angle));
    sample.device.position = hand + noiseVector(index, 0.01);
    sample.stylusTip = 0.8 * sample.device.position + glm::dvec3(1.0, 2.0, 3.0);
    const bool held = std::sin(0.3 * angle) > 0.0; // half of the time on the boundary
    sample.proxy.tip = held ? sample.stylusTip + glm::dvec3(0.0, 0.0, 2.0 * std::sin(0.3 * angle)) : sample.stylusTip;
    sample.force = held ? (sample.proxy.tip - sample.stylusTip) * 0.5 + noiseVector(index + 7, 0.001) : glm::dvec3(0.0);
    sample.cuttingForce = held ? noiseVector(index + 11, 20.0) : glm::dvec3(0.0);
    sample.reportedRemoval = held ? 0.2 + 0.05 * noise(index + 13) : 0.0;
    if (held) sample.removed[0] = {static_cast<std::uint64_t>(5000.0 + 800.0 * noise(index + 17)), 1};
    sample.flags = held ? sampleOnBoundary : 0u;
    return sample;
}

/// A box of twelve triangles.
TriangleMesh boxMesh(glm::dvec3 low, glm::dvec3 size) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.push_back(low + size * glm::dvec3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

Body body(const char* name, glm::dvec3 low, glm::dvec3 size) {
    Body result;
    result.name = name;
    result.mesh = boxMesh(low, size);
    result.box = {low, low + size};
    result.volume = size.x * size.y * size.z;
    result.area = 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
    result.faceCount = 6;
    return result;
}

bool sameBits(double one, double other) {
    return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

bool sameBits(const glm::dvec3& one, const glm::dvec3& other) {
    return sameBits(one.x, other.x) && sameBits(one.y, other.y) && sameBits(one.z, other.z);
}

bool sameBits(const glm::dquat& one, const glm::dquat& other) {
    return sameBits(one.w, other.w) && sameBits(one.x, other.x) && sameBits(one.y, other.y) && sameBits(one.z, other.z);
}

bool identical(const Body& one, const Body& other) {
    return one.name == other.name && one.colour == other.colour && sameBits(one.volume, other.volume) &&
           sameBits(one.area, other.area) && sameBits(one.box.low, other.box.low) &&
           sameBits(one.box.high, other.box.high) && one.openEdges == other.openEdges &&
           one.faceCount == other.faceCount && one.faceColours == other.faceColours &&
           one.mesh.triangles == other.mesh.triangles &&
           std::ranges::equal(one.mesh.vertices, other.mesh.vertices,
                              [](const glm::dvec3& a, const glm::dvec3& b) { return sameBits(a, b); });
}

} // namespace

std::vector<Sample> handSamples(std::size_t first, std::size_t count) {
    std::vector<Sample> samples;
    samples.reserve(count);
    for (std::size_t index = first; index < first + count; ++index) samples.push_back(handSample(index));
    return samples;
}

TakeInfo takeInfo(const char* name) {
    TakeInfo info;
    info.name = name;
    info.toolId = "ball-6";
    info.allowance = 0.1; // no binary fraction
    info.startedUnixTime = 1.7e9 + 1.0 / 3.0;
    info.stylus = "virtual operator";
    info.materials = {"air", "machinable-wax", "stahl-ä"};
    return info;
}

Model model() {
    Model result;
    result.sourceFile = "/parts/Gehäuse \"A\".step";
    result.format = "STEP AP214";
    result.lengthUnit = "inch";
    result.unitScale = 25.4;
    result.meshChord = 0.1 / 3.0;
    result.bodies.push_back(body("Body 1", {-1.0 / 3.0, -0.0, 0.1}, {10.0, 20.0, 30.0}));
    result.bodies.back().colour = {255, 0, 128};
    result.bodies.push_back(body("名", {20.0, 1e-17, -1e9}, {1.0, 2.0 / 3.0, 3.0}));
    result.bodies.back().openEdges = 3;
    result.notes = {{ImportNote::Kind::unit, "inch"}, {ImportNote::Kind::healing, "2 gaps closed"}, {}};
    for (std::uint32_t i = 0; i < 100000; ++i) result.brep.push_back(static_cast<char>(i * i % 251));
    return result;
}

namespace {

/// Two materials of its own in a small grid.
StockVolume::Shared stockVolume() {
    PropertyList list;
    for (const char* id : {"gegossen-ß", "lattice"}) {
        Property property;
        property.id = property.name = id;
        property.values.emplace(std::string(specificCuttingEnergy),
                                NamedValue{1.0 / 3.0, "J/mm^3", "an estimate", true});
        (void)list.add(std::move(property));
    }
    RunVolume volume = *RunVolume::make(*Grid::make({-1.0 / 3.0, 0.1, 0.0}, 0.1, {9, 10, 11}, RunAxis::y), list);
    for (LineIndex line; line.v < volume.grid().lineCountV(); ++line.v)
        for (line.u = 0; line.u < volume.grid().lineCountU(); ++line.u)
            volume.fillSpan(line, static_cast<RunPosition>(line.u * 7 + 3), 2000, line.v % 2 == 0 ? 1 : 2);
    Progress progress;
    return *StockVolume::of(volume.snapshot(), "Guß \"7\".nrrd", progress);
}

bool sameVolume(const Setup& one, const Setup& other) {
    if (!one.volume || !other.volume) return one.volume == other.volume;
    return one.volume->content() == other.volume->content() && one.volume->name() == other.volume->name();
}

} // namespace

Setup setup(int version) {
    Setup result;
    result.voxel = 0.1;
    result.marginLow = {5.0, 1.0 / 3.0, 0.0};
    result.marginHigh = {0.0, 2.5, 1e-9};
    result.stockMaterial = "machinable-wax";
    result.bodyMaterials = {"", "aluminium-6061"};
    result.stock = {{-0.1, -0.2, -0.3}, {100.1, 60.2, 40.3}};
    result.workOffset = {50.0, 30.0, 40.3};
    if (version < 5) return result;
    result.roles = {BodyRole::part, BodyRole::protectedInsert};
    result.form = StockForm::cylinder;
    result.stated = true;
    result.cylinder = {{1.0 / 3.0, 0.1, -7.0}, {0.6, 0.0, 0.8}, 70.7, 1e3 / 7.0};
    result.freeCarving = true;
    MaterialRegion skin;
    skin.name = "Haut";
    skin.material = "aluminium-6061";
    skin.axis = 1;
    skin.to = 1.0 / 7.0;
    MaterialRegion graded = skin;
    graded.name = "graded";
    graded.from = -0.1;
    graded.grade.emplace();
    graded.grade->formula = "0.1 + Z / 3";
    graded.grade->entries = 5;
    MaterialRegion table = graded;
    table.name = "table";
    table.grade->formula.clear();
    table.grade->value = std::string(density);
    table.grade->axis = 0;
    table.grade->table = {{-1.0 / 3.0, 0.1}, {0.0, 2.7}, {1e9, 0.7}};
    result.regions = {skin, graded, table};
    if (version < 6) return result;
    result.form = StockForm::file;
    result.volume = stockVolume();
    if (version < 7) return result;
    result.placement = combined(turnedAbout({0.0, 1.0, 0.0}, 0.5, {1.0 / 3.0, 2.0, 3.0}), movedBy({0.0, -1e-9, 7.7}));
    result.leftBy = LeftBy{SetupId{2}, -1234567890123};
    if (version < 8) return result;
    result.zero = {592, ZeroReference::point, {BoxSide::low, BoxSide::high, BoxSide::middle}, {1.0 / 3.0, -1e-9, 7.7}};
    return result;
}

static bool sameOrigin(const Setup& one, const Setup& other) {
    if (!one.leftBy || !other.leftBy) return one.leftBy.has_value() == other.leftBy.has_value();
    return one.leftBy->setup == other.leftBy->setup && one.leftBy->digest == other.leftBy->digest;
}

bool identical(const Setup& one, const Setup& other) {
    return one.voxel == other.voxel && one.marginLow == other.marginLow && one.marginHigh == other.marginHigh &&
           one.stockMaterial == other.stockMaterial && one.bodyMaterials == other.bodyMaterials &&
           one.stock.low == other.stock.low && one.stock.high == other.stock.high &&
           one.workOffset == other.workOffset && one.roles == other.roles && one.form == other.form &&
           one.stated == other.stated && one.cylinder == other.cylinder && one.freeCarving == other.freeCarving &&
           one.regions == other.regions && one.runs == other.runs && one.zero == other.zero &&
           one.placement == other.placement && sameOrigin(one, other) && sameVolume(one, other);
}

std::vector<Property> materials() {
    Property wax;
    wax.id = "machinable-wax";
    wax.name = "Machinable wax";
    wax.colour = {20, 90, 160};
    wax.values.emplace(std::string(specificCuttingEnergy), NamedValue{0.1, "J/mm^3", "an estimate", true});
    Property aluminium = wax;
    aluminium.id = "aluminium-6061";
    aluminium.machinability = Machinability::isProtected;
    aluminium.values.emplace(std::string(density), NamedValue{2.7, "g/cm^3", "a table", false});
    return {wax, aluminium};
}

Tool tool() {
    Tool result;
    result.id = "ball-6";
    result.name = "Ball 6 mm";
    result.number = 3;
    result.maximumDepthOfCut = 3.0;
    result.maximumSpindleSpeed = 24000.0;
    result.source = "a catalogue";
    result.cutter.type = CutterType::ball;
    result.cutter.diameter = 6.0;
    result.cutter.cornerRadius = 3.0;
    result.cutter.fluteLength = 13.0;
    result.cutter.shankDiameter = 6.0;
    result.cutter.stickOut = 30.0;
    result.cutter.holder = {{20.0, 25.0, 30.0}, {40.0, 40.0, 20.0}};
    return result;
}

std::vector<Obstacle> obstacles() {
    Obstacle jaw, column, above;
    jaw.name = "Schraubstock: \"Backe\"";
    jaw.shape = boxMesh({-30.0, -1.0 / 3.0, -0.1}, {10.0, 20.0, 30.0});
    jaw.margin = 0.1;
    column.name = "column";
    column.shape = CylinderShape{{1.0 / 7.0, 2.0, 3.0}, glm::normalize(glm::dvec3(1.0, 2.0, 3.0)), 4.5, 1e-3};
    above.name = "名";
    above.shape = Box{{-0.1, -0.2, 50.0}, {0.3, 0.4, 60.0}};
    above.margin = 1.0;
    above.on = false;
    above.kind = ObstacleKind::keepOut;
    return {jaw, column, above};
}

GeneratedMoves generatedMoves(int version) {
    GeneratedMoves moves;
    moves.info.name = "Parallele Bahnen";
    moves.info.toolId = tool().id;
    moves.info.allowance = 0.3;
    if (version >= 9) moves.info.request = R"({"pass":"parallel","allowance_mm":0.3,"step_over_mm":0.1})";
    for (std::int64_t stroke = 0; stroke < 2; ++stroke) {
        std::vector<GeneratedPoint>& points = moves.strokes.emplace_back();
        for (std::int64_t i = 0; i < 3; ++i) {
            const auto seed = static_cast<std::uint64_t>(3 * stroke + i);
            points.push_back({{noiseVector(seed, 10.0)}, 100 * stroke + 7 * i, i > 0, i == 2});
            if (version >= 11 && stroke == 1 && i > 0) points.back().feed = 600.0 + 0.1 * static_cast<double>(i);
            if (version >= 11 && stroke == 1 && i > 0) points.back().spindleSpeed = 12'000.0;
            if (version >= 13 && stroke == 1 && i > 0) points.back().coolant = i == 1 ? Coolant::mist : Coolant::off;
        }
    }
    return moves;
}

bool identical(const GeneratedMoves& one, const GeneratedMoves& other) {
    const auto same = [](const GeneratedPoint& a, const GeneratedPoint& b) {
        return a.pose.tip == b.pose.tip && a.pose.axis == b.pose.axis && a.moment == b.moment &&
               a.removes == b.removes && a.onBoundary == b.onBoundary && a.feed == b.feed &&
               a.spindleSpeed == b.spindleSpeed && a.coolant == b.coolant;
    };
    return one.info.name == other.info.name && one.info.toolId == other.info.toolId &&
           one.info.allowance == other.info.allowance && one.info.request == other.info.request &&
           std::ranges::equal(one.strokes, other.strokes,
                              [&](const auto& a, const auto& b) { return std::ranges::equal(a, b, same); });
}

AxisMode axisMode() {
    return {false, glm::normalize(glm::dvec3(0.1, -0.2, 0.9))};
}

TravelPlacement travelPlacement() {
    return {true, glm::dvec3(250.0, 200.1, 1.0 / 3.0)};
}

KeptGuides guides() {
    KeptGuides kept;
    kept.stepButton = 4;
    const auto curve = std::make_shared<const GuideCurve>(
        *GuideCurve::make({{0.0, 0.1, 0.2}, {1.0, 1.0 / 3.0, 0.2}, {2.0, 0.0, -1e-9}},
                          {{1.0, 0.0, 0.0}, {1.0, 0.1, 0.0}, {0.0, 1.0, 1.0}}));
    kept.curves = {curve};
    for (const GuideKind kind : {GuideKind::plane, GuideKind::levels, GuideKind::line, GuideKind::curve,
                                 GuideKind::surface, GuideKind::stepOver, GuideKind::axis}) {
        Guide guide;
        guide.kind = kind;
        guide.on = kind != GuideKind::line;
        guide.point = {0.1, 0.2, 0.3};
        guide.direction = glm::normalize(glm::dvec3(1.0, 1.0, 3.0));
        guide.distance = 0.7;
        guide.lead = 0.1;
        guide.tilt = -0.2;
        guide.onSurface = kind == GuideKind::axis;
        if (kind == GuideKind::curve) guide.curve = curve.get();
        kept.guides.push_back(guide);
    }
    return kept;
}

bool identical(const KeptGuides& one, const KeptGuides& other) {
    constexpr double rounding = 1e-15; // of a tangent that is normalised again
    const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) <= rounding; };
    const auto sameGuide = [&](Guide a, Guide b) {
        const GuideCurve *first = std::exchange(a.curve, nullptr), *second = std::exchange(b.curve, nullptr);
        if (!(a == b) || (first == nullptr) != (second == nullptr)) return false;
        return first == nullptr || (std::ranges::equal(first->points(), second->points()) &&
                                    std::ranges::equal(first->tangents(), second->tangents(), near));
    };
    return one.stepButton == other.stepButton && std::ranges::equal(one.guides, other.guides, sameGuide);
}

bool identical(const Sample& one, const Sample& other) {
    bool removed = true;
    for (std::size_t i = 0; i < one.removed.size(); ++i)
        removed = removed && one.removed[i].units == other.removed[i].units &&
                  one.removed[i].property == other.removed[i].property;
    return removed && one.tick == other.tick && sameBits(one.time, other.time) &&
           sameBits(one.device.position, other.device.position) &&
           sameBits(one.device.rotation, other.device.rotation) && sameBits(one.stylusTip, other.stylusTip) &&
           sameBits(one.proxy.tip, other.proxy.tip) && sameBits(one.proxy.axis, other.proxy.axis) &&
           sameBits(one.force, other.force) && sameBits(one.torque, other.torque) &&
           sameBits(one.cuttingForce, other.cuttingForce) && sameBits(one.reportedRemoval, other.reportedRemoval) &&
           one.buttons == other.buttons && one.flags == other.flags;
}

bool identical(const std::vector<Sample>& one, const std::vector<Sample>& other) {
    return std::ranges::equal(one, other, [](const Sample& a, const Sample& b) { return identical(a, b); });
}

bool identical(const Model& one, const Model& other) {
    return one.sourceFile == other.sourceFile && one.format == other.format && one.lengthUnit == other.lengthUnit &&
           sameBits(one.unitScale, other.unitScale) && sameBits(one.meshChord, other.meshChord) &&
           one.brep == other.brep &&
           std::ranges::equal(one.bodies, other.bodies, [](const Body& a, const Body& b) { return identical(a, b); }) &&
           std::ranges::equal(one.notes, other.notes, [](const ImportNote& a, const ImportNote& b) {
               return a.kind == b.kind && a.text == b.text;
           });
}

Model modelNamed(const std::string& name) {
    Model named = model();
    named.bodies.front().name = name;
    return named;
}

std::string nameIn(const Project& project) {
    const Result<Model> held = project.model();
    return held ? held->bodies.front().name : "none: " + held.error().detail;
}

} // namespace burin::fixture
