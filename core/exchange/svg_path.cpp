// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/exchange/curve_writer.h"
#include "core/exchange/svg_numbers.h"

#include <cmath>
#include <utility>

namespace burin {
namespace {

/// Draws the data of one path, https://www.w3.org/TR/SVG2/paths.html.
class PathPainter {
public:
    PathPainter(std::string_view data, CurveWriter& writer) : numbers_(data), writer_(writer) {}

    std::string paint() {
        char command = 0;
        while (!numbers_.ended() && !writer_.fault()) {
            if (const char letter = numbers_.letter())
                command = letter;
            else if (command == 0)
                return "a path that does not begin with M";
            else if (command == 'M')
                command = 'L'; // further points are lines
            else if (command == 'm')
                command = 'l';
            else if (command == 'Z' || command == 'z')
                return "a path with numbers behind Z";
            if (!begun_ && command != 'M' && command != 'm') return "a path that does not begin with M";
            if (!step(command)) return std::string("a path with wrong numbers behind ") + command;
        }
        writer_.finish();
        return {};
    }

private:
    bool number(double& value) { return numbers_.number(value); }
    bool place(glm::dvec2& value, bool relative) {
        if (!number(value.x) || !number(value.y)) return false;
        if (relative) value += writer_.at();
        return true;
    }

    bool step(char command) {
        const bool relative = command >= 'a';
        const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
        const char before = std::exchange(before_, kind);
        glm::dvec2 first, second, end;
        double value = 0.0;
        switch (kind) {
        case 'M':
            if (!place(end, relative)) return false;
            begun_ = true;
            writer_.moveTo(end);
            return true;
        case 'Z':
            writer_.close();
            reopens_ = true;
            return true;
        case 'L':
            if (!place(end, relative)) return false;
            reopen();
            writer_.lineTo(end);
            return true;
        case 'H':
        case 'V':
            if (!number(value)) return false;
            end = writer_.at();
            (kind == 'H' ? end.x : end.y) = value + (relative ? (kind == 'H' ? end.x : end.y) : 0.0);
            reopen();
            writer_.lineTo(end);
            return true;
        case 'C':
            if (!place(first, relative) || !place(second, relative) || !place(end, relative)) return false;
            cubic(first, second, end);
            return true;
        case 'S':
            if (!place(second, relative) || !place(end, relative)) return false;
            cubic(before == 'C' || before == 'S' ? 2.0 * writer_.at() - control_ : writer_.at(), second, end);
            return true;
        case 'Q':
            if (!place(first, relative) || !place(end, relative)) return false;
            quadratic(first, end);
            return true;
        case 'T':
            if (!place(end, relative)) return false;
            quadratic(before == 'Q' || before == 'T' ? 2.0 * writer_.at() - control_ : writer_.at(), end);
            return true;
        case 'A':
            return arc(relative);
        default:
            return false;
        }
    }

    /// A path that continues after Z begins at the start of the closed subpath.
    void reopen() {
        if (std::exchange(reopens_, false) && before_ != 'M') writer_.moveTo(writer_.at());
    }
    void cubic(const glm::dvec2& first, const glm::dvec2& second, const glm::dvec2& end) {
        reopen();
        writer_.cubicTo(first, second, end);
        control_ = second;
    }
    void quadratic(const glm::dvec2& control, const glm::dvec2& end) {
        reopen();
        writer_.quadraticTo(control, end);
        control_ = control;
    }

    /// Converts end points to centre and angles,
    /// https://www.w3.org/TR/SVG2/implnote.html#ArcConversionEndpointToCenter.
    bool arc(bool relative) {
        glm::dvec2 radii, end;
        double turn = 0.0;
        bool large = false, anticlockwise = false;
        if (!number(radii.x) || !number(radii.y) || !number(turn) || !numbers_.flag(large) ||
            !numbers_.flag(anticlockwise) || !place(end, relative))
            return false;
        reopen();
        const glm::dvec2 start = writer_.at();
        radii = glm::abs(radii);
        if (start == end) return true;
        if (radii.x == 0.0 || radii.y == 0.0) {
            writer_.lineTo(end);
            return true;
        }
        const double angle = turn * pi / 180.0;
        const glm::dvec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
        const glm::dvec2 half = 0.5 * (start - end);
        const glm::dvec2 seen(glm::dot(half, along) / radii.x, glm::dot(half, across) / radii.y); // of a unit circle
        const double square = glm::dot(seen, seen);
        if (square > 1.0) radii *= std::sqrt(square); // radii that are too small are scaled up
        const double reach = std::max(0.0, 1.0 / square - 1.0) * (square > 1.0 ? 0.0 : 1.0);
        const double side = (large == anticlockwise ? -1.0 : 1.0) * std::sqrt(reach);
        const glm::dvec2 unit = square > 1.0 ? seen / std::sqrt(square) : seen;
        const glm::dvec2 middle =
            side * glm::dvec2(unit.y, -unit.x); // centre from the middle of both ends, unit circle
        const glm::dvec2 u = radii.x * along, v = radii.y * across;
        const glm::dvec2 centre = 0.5 * (start + end) + middle.x * u + middle.y * v;
        const glm::dvec2 from = unit - middle, to = -unit - middle;
        const double begin = std::atan2(from.y, from.x);
        double sweep = std::atan2(to.y, to.x) - begin;
        if (anticlockwise && sweep < 0.0) sweep += 2.0 * pi;
        if (!anticlockwise && sweep > 0.0) sweep -= 2.0 * pi;
        writer_.ellipse(centre, u, v, begin, sweep);
        writer_.lineTo(end);
        return true;
    }

    SvgNumbers numbers_;
    CurveWriter& writer_;
    glm::dvec2 control_{0.0};
    char before_ = 0;
    bool begun_ = false, reopens_ = false;
};

} // namespace

std::string drawSvgPath(std::string_view data, CurveWriter& writer) {
    return PathPainter(data, writer).paint();
}

} // namespace burin
