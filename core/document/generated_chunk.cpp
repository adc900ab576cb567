// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/generated_chunk.h"

#include "core/document/column_codec.h"

#include <algorithm>

namespace burin {

namespace {

constexpr char plainForm = 1, statedForm = 2; // without and with the feeds and speeds that a program states

// Columns of both forms, in this order; the last two exist only in form 2.
constexpr std::size_t tipColumn = 0, axisColumn = 3, momentColumn = 6, markColumn = 7, plainColumns = 8;
constexpr std::size_t feedColumn = 8, speedColumn = 9, statedColumns = 10;
constexpr std::uint64_t removesMark = 1, boundaryMark = 2;

} // namespace

std::string encodePoints(std::span<const GeneratedPoint> points) {
    const bool stated = std::ranges::any_of(
        points, [](const GeneratedPoint& point) { return point.feed != 0.0 || point.spindleSpeed != 0.0; });
    std::vector<Column> columns(stated ? statedColumns : plainColumns, Column(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const GeneratedPoint& point = points[i];
        for (int axis = 0; axis < 3; ++axis) {
            columns[tipColumn + static_cast<std::size_t>(axis)][i] = wordOf(point.pose.tip[axis]);
            columns[axisColumn + static_cast<std::size_t>(axis)][i] = wordOf(point.pose.axis[axis]);
        }
        columns[momentColumn][i] = static_cast<std::uint64_t>(point.moment);
        columns[markColumn][i] = (point.removes ? removesMark : 0) | (point.onBoundary ? boundaryMark : 0);
        if (!stated) continue;
        columns[feedColumn][i] = wordOf(point.feed);
        columns[speedColumn][i] = wordOf(point.spindleSpeed);
    }
    return (stated ? statedForm : plainForm) + encodeColumns(columns);
}

std::optional<std::vector<GeneratedPoint>> decodePoints(std::string_view chunk, std::size_t count) {
    if (chunk.empty() || count > pointsPerChunk) return std::nullopt;
    const bool stated = chunk.front() == statedForm;
    if (!stated && chunk.front() != plainForm) return std::nullopt;
    const std::optional<std::vector<Column>> columns =
        decodeColumns(chunk.substr(1), stated ? statedColumns : plainColumns, count);
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
        if (!stated) continue;
        points[i].feed = doubleOf((*columns)[feedColumn][i]);
        points[i].spindleSpeed = doubleOf((*columns)[speedColumn][i]);
    }
    return points;
}

} // namespace burin
