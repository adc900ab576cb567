// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/base/units.h"
#include "core/exchange/curve_writer.h"
#include "core/exchange/svg_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <pugixml.hpp>

namespace burin {
namespace {

constexpr int deepestElement = 100;
constexpr double pixel = 25.4 / 96.0; // mm, CSS pixel

/// A length with its unit.
struct SvgLength {
    double millimetres = 0.0; ///< in pixels if it has no unit
    double value = 0.0;
    bool physical = false; ///< it has a physical unit
};
std::optional<SvgLength> lengthOf(std::string_view text) {
    struct Unit {
        std::string_view name;
        double millimetres;
        bool physical;
    };
    static constexpr std::array<Unit, 8> units{{{"", pixel, false},
                                                {"px", pixel, false},
                                                {"mm", 1.0, true},
                                                {"cm", 10.0, true},
                                                {"in", 25.4, true},
                                                {"pt", 25.4 / 72.0, true},
                                                {"pc", 25.4 / 6.0, true},
                                                {"Q", 0.25, true}}};
    SvgNumbers numbers(text);
    double value = 0.0;
    if (!numbers.number(value)) return {};
    const std::string_view name = numbers.rest().substr(0, numbers.rest().find_last_not_of(" \t\r\n") + 1);
    const auto unit = std::ranges::find(units, name, &Unit::name);
    if (unit == units.end()) return {};
    return SvgLength{value * unit->millimetres, value, unit->physical};
}

/// The value of the attribute `transform`; empty if it is invalid.
std::optional<PlanTransform> transformOf(std::string_view text) {
    PlanTransform whole;
    while (true) {
        const auto first = text.find_first_not_of(" \t\r\n,");
        if (first == std::string_view::npos) return whole;
        text.remove_prefix(first);
        const auto open = text.find('('), close = text.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
        const std::string_view name = text.substr(0, text.find_first_of(" \t\r\n("));
        SvgNumbers numbers(text.substr(open + 1, close - open - 1));
        std::array<double, 6> n{};
        std::size_t count = 0;
        while (!numbers.ended()) {
            if (count == n.size() || !numbers.number(n[count])) return {};
            ++count;
        }
        text.remove_prefix(close + 1);
        PlanTransform step;
        if (name == "matrix" && count == 6)
            step = {{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}};
        else if (name == "translate" && (count == 1 || count == 2))
            step.shift = {n[0], count == 2 ? n[1] : 0.0};
        else if (name == "scale" && (count == 1 || count == 2))
            step = {{n[0], 0.0}, {0.0, count == 2 ? n[1] : n[0]}, {0.0, 0.0}};
        else if (name == "rotate" && (count == 1 || count == 3)) {
            const double angle = n[0] * pi / 180.0;
            const glm::dvec2 along(std::cos(angle), std::sin(angle)), centre(n[1], n[2]);
            step = {along, {-along.y, along.x}, {0.0, 0.0}};
            step.shift = centre - step.ofVector(centre);
        } else if (name == "skewX" && count == 1)
            step.y = {std::tan(n[0] * pi / 180.0), 1.0};
        else if (name == "skewY" && count == 1)
            step.x = {1.0, std::tan(n[0] * pi / 180.0)};
        else
            return {};
        whole = combined(whole, step);
    }
}

/// Draws the elements of an SVG.
class SvgPainter {
public:
    SvgPainter(const pugi::xml_node& root, CurveWriter& writer) : root_(root), writer_(writer) {}

    /// The fault; empty if there is none.
    const std::string& fault() const noexcept { return fault_; }

    void paint(const pugi::xml_node& element, int depth) {
        if (!fault_.empty() || writer_.fault()) return;
        const std::string_view name = localName(element);
        if (isHidden(element) || isNoFigure(name)) return;
        if (depth > deepestElement) return writer_.note("elements nested deeper than 100 are left out");
        const PlanTransform before = writer_.transform;
        const std::string layer = writer_.layer;
        const std::optional<PlanTransform> own = transformOf(element.attribute("transform").value());
        if (!own) return fail(element, "a transform that can't be read");
        writer_.transform = combined(before, *own);
        if (name == "g" || name == "a" || name == "switch" || (name == "svg" && depth == 0)) {
            if (const pugi::xml_attribute id = element.attribute("id")) writer_.layer = cleanLine(id.value());
            for (const pugi::xml_node& child : element.children())
                if (child.type() == pugi::node_element) paint(child, depth + 1);
        } else {
            figure(element, name, depth);
            writer_.finish();
        }
        writer_.transform = before;
        writer_.layer = layer;
    }

private:
    static std::string_view localName(const pugi::xml_node& element) {
        const std::string_view name = element.name();
        const auto colon = name.find(':');
        return colon == std::string_view::npos ? name : name.substr(colon + 1);
    }
    static bool isHidden(const pugi::xml_node& element) {
        const std::string_view style = element.attribute("style").value();
        return std::string_view(element.attribute("display").value()) == "none" ||
               style.find("display:none") != std::string_view::npos ||
               style.find("display: none") != std::string_view::npos;
    }
    static bool isNoFigure(std::string_view name) {
        static constexpr std::array<std::string_view, 16> names{
            "defs", "symbol", "clipPath", "mask",      "pattern",        "marker",         "metadata", "title",
            "desc", "style",  "script",   "namedview", "linearGradient", "radialGradient", "filter",   "RDF"};
        return std::ranges::find(names, name) != names.end();
    }
    void fail(const pugi::xml_node& element, const std::string& what) {
        if (fault_.empty())
            fault_ =
                "byte " + std::to_string(element.offset_debug()) + ": <" + cleanLine(element.name()) + "> has " + what;
    }

    /// A length in user units; percentages are not supported.
    double number(const pugi::xml_node& element, const char* key) {
        const std::string_view text = element.attribute(key).value();
        if (text.empty()) return 0.0;
        const std::optional<SvgLength> length = lengthOf(text);
        if (!length) {
            fail(element, std::string("a length \"") + key + "\" that can't be read");
            return 0.0;
        }
        return length->physical ? length->millimetres / pixel : length->value;
    }

    void figure(const pugi::xml_node& element, std::string_view name, int depth) {
        const auto at = [&](const char* x, const char* y) {
            const double first = number(element, x);
            return glm::dvec2(first, number(element, y));
        };
        if (name == "path") {
            if (const std::string wrong = drawSvgPath(element.attribute("d").value(), writer_); !wrong.empty())
                fail(element, wrong);
        } else if (name == "rect") {
            rectangle(at("x", "y"), at("width", "height"), element);
        } else if (name == "circle" || name == "ellipse") {
            const glm::dvec2 centre = at("cx", "cy");
            const glm::dvec2 radii = name == "circle" ? glm::dvec2(number(element, "r")) : at("rx", "ry");
            if (!(radii.x > 0.0 && radii.y > 0.0)) return;
            writer_.ellipse(centre, {radii.x, 0.0}, {0.0, radii.y}, 0.0, 2.0 * pi);
            writer_.close();
            if (name == "circle") writer_.point(centre);
        } else if (name == "line") {
            writer_.moveTo(at("x1", "y1"));
            writer_.lineTo(at("x2", "y2"));
        } else if (name == "polyline" || name == "polygon") {
            corners(element, name == "polygon");
        } else if (name == "use") {
            use(element, at("x", "y"), depth);
        } else {
            writer_.note("<" + cleanLine(std::string(name)) + "> is left out");
        }
    }

    void rectangle(const glm::dvec2& low, const glm::dvec2& size, const pugi::xml_node& element) {
        if (!(size.x > 0.0 && size.y > 0.0)) return;
        double rx = number(element, "rx"), ry = number(element, "ry");
        if (!element.attribute("rx")) rx = ry;
        if (!element.attribute("ry")) ry = rx;
        rx = std::clamp(rx, 0.0, 0.5 * size.x);
        ry = std::clamp(ry, 0.0, 0.5 * size.y);
        const glm::dvec2 u(rx, 0.0), v(0.0, ry), high = low + size, inner = low + glm::dvec2(rx, ry),
                                                 outer = high - glm::dvec2(rx, ry);
        if (rx == 0.0 || ry == 0.0) {
            writer_.moveTo(low);
            for (const glm::dvec2& corner : {glm::dvec2(high.x, low.y), high, glm::dvec2(low.x, high.y)})
                writer_.lineTo(corner);
        } else {
            const std::array<glm::dvec2, 4> centres{glm::dvec2(outer.x, inner.y), outer, glm::dvec2(inner.x, outer.y),
                                                    inner};
            for (std::size_t i = 0; i < centres.size(); ++i)
                writer_.ellipse(centres[i], u, v, (static_cast<double>(i) - 1.0) * 0.5 * pi, 0.5 * pi);
        }
        writer_.close();
    }

    void corners(const pugi::xml_node& element, bool closed) {
        SvgNumbers numbers(element.attribute("points").value());
        bool first = true;
        while (!numbers.ended()) {
            glm::dvec2 place;
            if (!numbers.number(place.x) || !numbers.number(place.y)) return fail(element, "points that can't be read");
            if (first)
                writer_.moveTo(place);
            else
                writer_.lineTo(place);
            first = false;
        }
        if (closed && !first) writer_.close();
    }

    void use(const pugi::xml_node& element, const glm::dvec2& shift, int depth) {
        std::string_view name = element.attribute("href").value();
        if (name.empty()) name = element.attribute("xlink:href").value();
        if (!name.starts_with('#')) return writer_.note("<use> of another file is left out");
        if (++uses_ > mostUses) return writer_.note("more than 10,000 <use> are left out");
        const std::string id(name.substr(1));
        const pugi::xml_node used =
            root_.find_node([&](const pugi::xml_node& node) { return id == node.attribute("id").value(); });
        if (!used) return writer_.note("<use> of something that is not there is left out");
        writer_.transform = combined(writer_.transform, {{1.0, 0.0}, {0.0, 1.0}, shift});
        constexpr int price = 10; // added to the depth per use, so that recursive uses end soon
        paint(used, depth + price);
    }

    static constexpr std::size_t mostUses = 10'000;
    const pugi::xml_node& root_;
    CurveWriter& writer_;
    std::string fault_;
    std::size_t uses_ = 0;
};

/// Maps user units to mm, y upwards: width and height of the page, over its view box.
/// @return the fault; empty if there is none
std::string pageOf(const pugi::xml_node& svg, double unit, PlanTransform& transform, PlanDrawing& drawing) {
    const auto size = [&](const char* key) -> std::optional<SvgLength> {
        const std::string_view text = svg.attribute(key).value();
        return text.empty() || text.ends_with('%') ? std::nullopt : lengthOf(text);
    };
    const std::optional<SvgLength> width = size("width"), height = size("height");
    SvgNumbers box(svg.attribute("viewBox").value());
    glm::dvec2 low(0.0), extent(0.0);
    const bool boxed = !box.ended();
    if (boxed && !(box.number(low.x) && box.number(low.y) && box.number(extent.x) && box.number(extent.y) &&
                   extent.x > 0.0 && extent.y > 0.0))
        return "its viewBox can't be read";
    glm::dvec2 scale(pixel);
    if (boxed && width && width->millimetres > 0.0) scale = glm::dvec2(width->millimetres / extent.x);
    if (boxed && height && height->millimetres > 0.0) {
        scale.y = height->millimetres / extent.y;
        if (!width) scale.x = scale.y;
    }
    const bool stretched = std::string_view(svg.attribute("preserveAspectRatio").value()).starts_with("none");
    glm::dvec2 shift(0.0);
    if (!stretched) {
        const double even = std::min(scale.x, scale.y);
        shift = 0.5 * (scale - even) * extent; // centred on the page
        scale = glm::dvec2(even);
    }
    drawing.unitStated = unit > 0.0 || (width && width->physical) || (height && height->physical);
    if (unit > 0.0) {
        scale = glm::dvec2(unit);
        shift = glm::dvec2(0.0);
    }
    drawing.unit = scale.x;
    const double page = boxed    ? extent.y * scale.y + 2.0 * shift.y
                        : height ? (unit > 0.0 ? height->value * unit : height->millimetres)
                                 : 0.0;
    transform = {{scale.x, 0.0}, {0.0, -scale.y}, {shift.x - low.x * scale.x, page - shift.y + low.y * scale.y}};
    return {};
}

} // namespace

Result<PlanDrawing> svgDrawing(std::string_view text, const std::string& origin, double unit) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed)
        return Error{ErrorCode::resourceInvalid,
                     origin,
                     {},
                     "byte " + std::to_string(parsed.offset) + ": " + parsed.description()};
    const pugi::xml_node root = document.document_element();
    PlanDrawing drawing;
    CurveWriter writer(drawing);
    if (const std::string wrong = pageOf(root, unit, writer.transform, drawing); !wrong.empty())
        return Error{ErrorCode::resourceInvalid, origin, {}, wrong};
    SvgPainter painter(root, writer);
    painter.paint(root, 0);
    if (!painter.fault().empty()) return Error{ErrorCode::resourceInvalid, origin, {}, painter.fault()};
    if (writer.fault()) return Error{ErrorCode::resourceInvalid, origin, {}, *writer.fault()};
    return drawing;
}

} // namespace burin
