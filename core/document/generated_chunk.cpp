// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/generated_chunk.h"

#include "core/document/column_codec.h"

#include <algorithm>

namespace burin {

namespace {

// Without the values that a program states; with feeds and speeds; with coolants as well.
constexpr char plainForm = 1, statedForm = 2, cooledForm = 3;

// Columns of all forms, in this order; those behind the marks exist in forms 2 and 3, the last one in form 3.
constexpr std::size_t tipColumn = 0, axisColumn = 3, momentColumn = 6, markColumn = 7, plainColumns = 8;
constexpr std::size_t feedColumn = 8, speedColumn = 9, statedColumns = 10;
constexpr std::size_t coolantColumn = 10, cooledColumns = 11;
constexpr std::uint64_t removesMark = 1, boundaryMark = 2;

constexpr std::size_t columnsOf(char form) noexcept {
    return form == cooledForm ? cooledColumns : form == statedForm ? statedColumns : plainColumns;
}

/// The least form that holds all values of some points.
char formFor(std::span<const GeneratedPoint> points) {
    const auto cooled = [](const GeneratedPoint& point) { return point.coolant.has_value(); };
    const auto stated = [](const GeneratedPoint& point) { return point.feed != 0.0 || point.spindleSpeed != 0.0; };
    return std::ranges::any_of(points, cooled)   ? cooledForm
           : std::ranges::any_of(points, stated) ? statedForm
                                                 : plainForm;
}

/// 0: not stated.
std::uint64_t wordOfCoolant(const std::optional<Coolant>& coolant) noexcept {
    return coolant ? static_cast<std::uint64_t>(*coolant) + 1 : 0;
}

} // namespace

std::string encodePoints(std::span<const GeneratedPoint> points) {
    const char form = formFor(points);
    std::vector<Column> columns(columnsOf(form), Column(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const GeneratedPoint& point = points[i];
        for (int axis = 0; axis < 3; ++axis) {
            columns[tipColumn + static_cast<std::size_t>(axis)][i] = wordOf(point.pose.tip[axis]);
            columns[axisColumn + static_cast<std::size_t>(axis)][i] = wordOf(point.pose.axis[axis]);
        }
        columns[momentColumn][i] = static_cast<std::uint64_t>(point.moment);
        columns[markColumn][i] = (point.removes ? removesMark : 0) | (point.onBoundary ? boundaryMark : 0);
        if (form == plainForm) continue;
        columns[feedColumn][i] = wordOf(point.feed);
        columns[speedColumn][i] = wordOf(point.spindleSpeed);
        if (form == cooledForm) columns[coolantColumn][i] = wordOfCoolant(point.coolant);
    }
    return form + encodeColumns(columns);
}

std::optional<std::vector<GeneratedPoint>> decodePoints(std::string_view chunk, std::size_t count) {
    if (chunk.empty() || count > pointsPerChunk) return std::nullopt;
    const char form = chunk.front();
    if (form < plainForm || form > cooledForm) return std::nullopt;
    const std::optional<std::vector<Column>> columns = decodeColumns(chunk.substr(1), columnsOf(form), count);
    if (!columns) return std::nullopt;
    std::vector<GeneratedPoint> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            points[i].pose.tip[axis] = doubleOf((*columns)[tipColumn + static_cast<std::size_t>(axis)][i]);
            points[i].pose.axis[axis] = doubleOf((*columns)[axisColumn + static_cast<std::size_t>(axis)][i]);
        }
        points[i].moment = static_cast<std::int64_t>((*columns)[momentColumn][i]);
        const std::uint64_t marks = (*columns)[markColumn][i];
        if ((marks & ~(removesMark | boundaryMark)) != 0) return std::nullopt;
        points[i].removes = (marks & removesMark) != 0;
        points[i].onBoundary = (marks & boundaryMark) != 0;
        if (form == plainForm) continue;
        points[i].feed = doubleOf((*columns)[feedColumn][i]);
        points[i].spindleSpeed = doubleOf((*columns)[speedColumn][i]);
        if (form != cooledForm) continue;
        const std::uint64_t coolant = (*columns)[coolantColumn][i];
        if (coolant > wordOfCoolant(Coolant::flood)) return std::nullopt;
        if (coolant != 0) points[i].coolant = static_cast<Coolant>(coolant - 1);
    }
    return points;
}

} // namespace burin
