// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/fixture_kind.h"

#include "core/setup/fixture_library.h"

#include "core/base/numbers.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double farthestFixture = 1e5; // mm, of its origin from that of the setup

/// A length that limits another one of the same fixture.
struct FixtureLimit {
    FixtureKind kind;
    const char* key;
    double (*least)(const FixtureDesign&);
};

constexpr double slotWall = 1.0; // mm of the bar that stay before and behind the slot

constexpr std::array limits{
    FixtureLimit{FixtureKind::vise, "jaw-height", [](const FixtureDesign& of) { return valueOf(of, "grip"); }},
    FixtureLimit{FixtureKind::stepClamp, "slot",
                 [](const FixtureDesign& of) { return valueOf(of, "stud") + 2.0 * leastClearance; }},
    FixtureLimit{FixtureKind::stepClamp, "width",
                 [](const FixtureDesign& of) { return valueOf(of, "slot") + 2.0 * slotWall; }},
    FixtureLimit{
        FixtureKind::stepClamp, "stud-distance",
        [](const FixtureDesign& of) { return 0.5 * (valueOf(of, "slot") - valueOf(of, "contact")) + slotWall; }},
    FixtureLimit{FixtureKind::stepClamp, "length",
                 [](const FixtureDesign& of) {
                     return 0.5 * valueOf(of, "contact") + valueOf(of, "stud-distance") + 0.5 * valueOf(of, "slot") +
                            valueOf(of, "block-length") / blockSteps + slotWall;
                 }},
    FixtureLimit{FixtureKind::stepClamp, "washer", [](const FixtureDesign& of) { return valueOf(of, "stud"); }},
    FixtureLimit{FixtureKind::toeClamp, "grip-height",
                 [](const FixtureDesign& of) { return valueOf(of, "nose-thickness"); }},
    FixtureLimit{FixtureKind::toeClamp, "height", [](const FixtureDesign& of) { return valueOf(of, "grip-height"); }},
    FixtureLimit{FixtureKind::hexScrew, "washer", [](const FixtureDesign& of) { return valueOf(of, "diameter"); }},
    FixtureLimit{FixtureKind::socketScrew, "washer", [](const FixtureDesign& of) { return valueOf(of, "diameter"); }},
    FixtureLimit{FixtureKind::parallels, "distance",
                 [](const FixtureDesign& of) { return valueOf(of, "thickness") + 2.0 * leastClearance; }}};

} // namespace

const FixtureKindRow& rowOf(FixtureKind kind) noexcept {
    return fixtureKinds[static_cast<std::size_t>(kind)];
}

std::optional<FixtureKind> fixtureKindFromId(std::string_view id) noexcept {
    const auto found = std::ranges::find(fixtureKinds, id, &FixtureKindRow::id);
    return found == fixtureKinds.end() ? std::nullopt : std::optional(found->kind);
}

FixtureDesign standardFixture(FixtureKind kind) {
    FixtureDesign design;
    design.kind = kind;
    for (const FixtureParameter& parameter : rowOf(kind).parameters) design.values.push_back(parameter.standard);
    return design;
}

std::optional<std::size_t> indexOf(FixtureKind kind, std::string_view key) noexcept {
    const std::span<const FixtureParameter> parameters = rowOf(kind).parameters;
    const auto found = std::ranges::find(parameters, key, &FixtureParameter::key);
    if (found == parameters.end()) return std::nullopt;
    return static_cast<std::size_t>(found - parameters.begin());
}

double valueOf(const FixtureDesign& design, std::string_view key) noexcept {
    return design.values[*indexOf(design.kind, key)];
}

void setValue(FixtureDesign& design, std::string_view key, double value) noexcept {
    design.values[*indexOf(design.kind, key)] = value;
}

Result<void> checkFixture(const FixtureDesign& design) {
    const std::span<const FixtureParameter> parameters = rowOf(design.kind).parameters;
    if (design.values.size() != parameters.size())
        return Error{ErrorCode::argumentInvalid, rowOf(design.kind).id, std::to_string(design.values.size()),
                     "a value for each parameter"};
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const double value = design.values[i];
        const auto [low, high] = parameters[i].range;
        if (!(value >= low && value <= high))
            return Error{ErrorCode::argumentInvalid, parameters[i].key, formatShortest(value),
                         "a length of " + formatShortest(low) + " to " + formatShortest(high) + " mm"};
    }
    for (const FixtureLimit& limit : limits) {
        if (limit.kind != design.kind) continue;
        const double value = valueOf(design, limit.key), least = limit.least(design);
        if (value < least - 1e-9)
            return Error{ErrorCode::argumentInvalid, limit.key, formatShortest(value),
                         formatLimit(least, 3) + " mm or more for the other sizes of this fixture"};
    }
    if (!isFinite(design.place) || glm::length(design.place) > farthestFixture)
        return Error{ErrorCode::argumentInvalid, "place", {}, "places within 1e5 mm"};
    if (!(std::abs(design.turn) <= 1e3)) return Error{ErrorCode::argumentInvalid, "turn", {}, "a finite angle"};
    return {};
}

} // namespace burin
