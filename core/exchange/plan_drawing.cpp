// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/plan_drawing.h"

#include "core/base/file.h"
#include "core/exchange/curve_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace burin {
namespace {

constexpr double joined = 0.01; // mm, largest gap between the ends of curves that are joined

/// Skips blanks, and the byte order mark that some editors write.
std::string_view beginning(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const auto first = text.find_first_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

/// A DXF file begins with a group code, and has sections.
bool looksLikeDxf(std::string_view text) {
    return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0 &&
           text.find("SECTION") != std::string_view::npos;
}

/// Ends of open curves, by squares of a grid, for fast search.
class CurveEnds {
public:
    explicit CurveEnds(const std::vector<DrawnCurve>& curves) : curves_(curves), taken_(curves.size(), 0) {
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (const glm::dvec2& end : {curves[i].places.front(), curves[i].places.back()})
                squares_.emplace(squareOf(end), i);
    }
    bool take(std::size_t curve) { return std::exchange(taken_[curve], 1) == 0; }
    /// Takes a curve that begins or ends at a point and was not taken yet.
    std::optional<std::size_t> takeAt(const glm::dvec2& place) {
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                const auto [x, y] = squareOf(place);
                const auto [first, last] = squares_.equal_range({x + dx, y + dy});
                for (auto it = first; it != last; ++it)
                    if (fits(curves_[it->second], place) && take(it->second)) return it->second;
            }
        return {};
    }
    static bool near(const glm::dvec2& a, const glm::dvec2& b) noexcept { return glm::distance(a, b) <= joined; }

private:
    static bool fits(const DrawnCurve& curve, const glm::dvec2& place) noexcept {
        return near(curve.places.front(), place) || near(curve.places.back(), place);
    }
    static std::pair<std::int64_t, std::int64_t> squareOf(const glm::dvec2& place) {
        return {std::llround(place.x / joined), std::llround(place.y / joined)};
    }

    const std::vector<DrawnCurve>& curves_;
    std::vector<char> taken_; ///< 1: taken
    std::multimap<std::pair<std::int64_t, std::int64_t>, std::size_t> squares_;
};

/// Joins open curves at their ends, as long as any match; those that return to their own start are closed.
std::vector<PlanRing> chained(const std::vector<DrawnCurve>& open) {
    std::vector<PlanRing> closed;
    CurveEnds ends(open);
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (!ends.take(i)) continue;
        PlanRing chain = open[i].places;
        while (!CurveEnds::near(chain.front(), chain.back())) {
            const std::optional<std::size_t> next = ends.takeAt(chain.back());
            if (!next) break;
            std::vector<glm::dvec2> places = open[*next].places;
            if (!CurveEnds::near(places.front(), chain.back())) std::ranges::reverse(places);
            chain.insert(chain.end(), places.begin() + 1, places.end());
        }
        if (chain.size() < 4 || !CurveEnds::near(chain.front(), chain.back())) continue;
        chain.pop_back();
        closed.push_back(std::move(chain));
    }
    return closed;
}

} // namespace

Result<PlanDrawing> drawingOf(std::string_view text, const std::string& origin, double unit) {
    if (text.starts_with("AutoCAD Binary DXF"))
        return Error{ErrorCode::resourceInvalid, origin, "its beginning", "it is a binary DXF; save it as ASCII"};
    const std::string_view begun = beginning(text);
    const bool svg = begun.starts_with('<') && begun.find("<svg") != std::string_view::npos;
    if (!svg && !looksLikeDxf(begun))
        return Error{ErrorCode::resourceInvalid, origin, "its beginning", "it is neither a DXF nor an SVG drawing"};
    Result<PlanDrawing> drawing = svg ? svgDrawing(begun, origin, unit) : dxfDrawing(begun, origin, unit);
    if (drawing && drawing->curves.empty() && drawing->points.empty())
        return Error{ErrorCode::resourceInvalid, origin, {}, "there is no curve in it"};
    return drawing;
}

Result<PlanDrawing> readDrawing(const std::filesystem::path& file, double unit) {
    std::error_code unknown;
    if (const auto size = std::filesystem::file_size(file, unknown); !unknown && size > largestDrawing)
        return Error{ErrorCode::resourceInvalid, file.string(), {}, "it is larger than 64 MB"};
    const Result<std::string> text = readFile(file);
    if (!text) return text.error();
    return drawingOf(*text, file.string(), unit);
}

Result<PlanRegion> regionOf(const PlanDrawing& drawing, const std::string& origin) {
    PlanRegion region;
    std::vector<DrawnCurve> open;
    for (const DrawnCurve& curve : drawing.curves) {
        if (curve.closed)
            region.rings.push_back(curve.places);
        else
            open.push_back(curve);
    }
    std::ranges::move(chained(open), std::back_inserter(region.rings));
    if (region.empty())
        return Error{ErrorCode::argumentInvalid, origin, "its curves", "a closed curve at least, as border of an area"};
    return region;
}

std::vector<std::vector<glm::dvec3>> linesOf(const PlanDrawing& drawing) {
    std::vector<std::vector<glm::dvec3>> lines;
    for (const DrawnCurve& curve : drawing.curves) {
        std::vector<glm::dvec3>& line = lines.emplace_back();
        for (const glm::dvec2& place : curve.places) line.emplace_back(place, 0.0);
        if (curve.closed) line.push_back(line.front());
    }
    return lines;
}

} // namespace burin
