// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/plan_drawing.h"

#include "core/base/file.h"
#include "core/exchange/curve_writer.h"

#include <algorithm>
#include <cctype>

namespace burin {
namespace {

constexpr double joined = 0.01; // mm between the ends of curves that belong together

/// Past blanks, and the mark that some editors begin a text with.
std::string_view beginning(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const auto first = text.find_first_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

/// A DXF begins with a group code, and has sections.
bool looksLikeDxf(std::string_view text) {
    return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0 &&
           text.find("SECTION") != std::string_view::npos;
}

/// Joins open curves at their ends, as long as any of them fit; those that come to their own beginning are closed.
std::vector<DrawnCurve> chained(std::vector<DrawnCurve> open) {
    std::vector<DrawnCurve> closed;
    const auto near = [](const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) <= joined; };
    while (!open.empty()) {
        DrawnCurve chain = std::move(open.back());
        open.pop_back();
        bool grew = true;
        while (grew && !near(chain.places.front(), chain.places.back())) {
            grew = false;
            for (std::size_t i = 0; i < open.size(); ++i) {
                std::vector<glm::dvec2>& next = open[i].places;
                if (near(next.back(), chain.places.back())) std::ranges::reverse(next);
                if (!near(next.front(), chain.places.back())) continue;
                chain.places.insert(chain.places.end(), next.begin() + 1, next.end());
                open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
                grew = true;
                break;
            }
        }
        if (chain.places.size() < 4 || !near(chain.places.front(), chain.places.back())) continue;
        chain.places.pop_back();
        chain.closed = true;
        closed.push_back(std::move(chain));
    }
    return closed;
}

} // namespace

Result<PlanDrawing> drawingOf(std::string_view text, const std::string& origin, double unit) {
    if (text.starts_with("AutoCAD Binary DXF"))
        return Error{ErrorCode::resourceInvalid, origin, {}, "it is a binary DXF; save it as ASCII"};
    const std::string_view begun = beginning(text);
    const bool svg = begun.starts_with('<') && begun.find("<svg") != std::string_view::npos;
    if (!svg && !looksLikeDxf(begun))
        return Error{ErrorCode::resourceInvalid, origin, {}, "it is neither a DXF nor an SVG drawing"};
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
    constexpr std::size_t mostOpen = 20'000; // each is compared with each
    if (open.size() > mostOpen)
        return Error{ErrorCode::argumentInvalid, origin, std::to_string(open.size()) + " open curves",
                     "at most 20,000 of them; join them to polylines"};
    for (DrawnCurve& curve : chained(std::move(open))) region.rings.push_back(std::move(curve.places));
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
