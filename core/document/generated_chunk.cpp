// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/generated_chunk.h"

#include "core/document/column_codec.h"

namespace burin {

namespace {

constexpr char pointFormVersion = 1;

// Columns of form 1, in this order.
constexpr std::size_t tipColumn = 0, axisColumn = 3, momentColumn = 6, markColumn = 7, pointColumns = 8;
constexpr std::uint64_t removesMark = 1, boundaryMark = 2;

} // namespace

std::string encodePoints(std::span<const GeneratedPoint> points) {
    std::vector<Column> columns(pointColumns, Column(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const GeneratedPoint& point = points[i];
        for (int axis = 0; axis < 3; ++axis) {
            columns[tipColumn + static_cast<std::size_t>(axis)][i] = wordOf(point.pose.tip[axis]);
            columns[axisColumn + static_cast<std::size_t>(axis)][i] = wordOf(point.pose.axis[axis]);
        }
        columns[momentColumn][i] = static_cast<std::uint64_t>(point.moment);
        columns[markColumn][i] = (point.removes ? removesMark : 0) | (point.onBoundary ? boundaryMark : 0);
    }
    return pointFormVersion + encodeColumns(columns);
}

std::optional<std::vector<GeneratedPoint>> decodePoints(std::string_view chunk, std::size_t count) {
    if (chunk.empty() || chunk.front() != pointFormVersion || count > pointsPerChunk) return std::nullopt;
    const std::optional<std::vector<Column>> columns = decodeColumns(chunk.substr(1), pointColumns, count);
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
    }
    return points;
}

} // namespace burin
