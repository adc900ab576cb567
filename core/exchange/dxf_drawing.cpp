// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/base/numbers.h"
#include "core/base/trimmed.h"
#include "core/base/units.h"
#include "core/exchange/curve_writer.h"
#include "core/exchange/rational_spline.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <span>

namespace burin {
namespace {

constexpr int deepestInsert = 16;

/// A group of a DXF file: a code for the kind of value, and the value.
struct Group {
    int code = 0;
    std::string_view value;
};

/// One entity with its groups.
struct Entity {
    std::string_view type;
    std::vector<Group> groups;

    std::string_view text(int code) const {
        const auto found = std::ranges::find(groups, code, &Group::code);
        return found == groups.end() ? std::string_view() : found->value;
    }
    double number(int code, double otherwise = 0.0) const {
        const std::string_view value = text(code);
        return value.empty() ? otherwise : parseNumber(value).value_or(std::nan(""));
    }
    int whole(int code, int otherwise = 0) const {
        const double value = number(code, otherwise);
        return std::abs(value) < 1e9 ? static_cast<int>(value) : otherwise;
    }
    glm::dvec2 place(int code) const { return {number(code), number(code + 10)}; }
    std::vector<double> all(int code) const {
        std::vector<double> values;
        for (const Group& group : groups)
            if (group.code == code) values.push_back(parseNumber(group.value).value_or(std::nan("")));
        return values;
    }
};

struct Block {
    glm::dvec2 base{0.0};
    std::vector<Entity> entities;
};

struct DxfFile {
    int insertUnits = 0;
    std::vector<Entity> entities;
    std::map<std::string, Block, std::less<>> blocks;
};

/// mm per unit by $INSUNITS; 0 if the file states none, or one that is not used for milling.
double millimetresOf(int units) {
    switch (units) {
    case 1:
        return 25.4;
    case 2:
        return 304.8;
    case 4:
        return 1.0;
    case 5:
        return 10.0;
    case 6:
        return 1000.0;
    case 8:
        return 25.4e-6;
    case 9:
        return 25.4e-3;
    case 10:
        return 914.4;
    case 13:
        return 1e-3;
    case 14:
        return 100.0;
    default:
        return 0.0;
    }
}

/// Splits a DXF file into its entities.
class DxfReader {
public:
    explicit DxfReader(std::string_view text) : text_(text) {}

    /// The fault; empty if there is none.
    std::string read(DxfFile& file) {
        std::string_view section, variable;
        std::string block;
        bool named = false;
        std::vector<Entity>* into = nullptr;
        Group group;
        while (next(group)) {
            if (!fault_.empty()) return fault_;
            if (group.code != 0) {
                if (named && group.code == 2) section = group.value;
                named = false;
                if (section == "HEADER") {
                    if (group.code == 9)
                        variable = group.value;
                    else if (variable == "$INSUNITS" && group.code == 70)
                        file.insertUnits = Entity{{}, {group}}.whole(70);
                }
                if (section == "BLOCKS" && inBlockHead_)
                    headOfBlock(group, file, block);
                else if (into != nullptr && !into->empty() && into->back().groups.size() < mostDrawnPlaces)
                    into->back().groups.push_back(group);
                continue;
            }
            named = group.value == "SECTION";
            inBlockHead_ = section == "BLOCKS" && group.value == "BLOCK";
            if (named || group.value == "ENDSEC" || group.value == "ENDBLK" || inBlockHead_) {
                if (group.value == "ENDSEC") section = {};
                into = nullptr;
                continue;
            }
            if (group.value == "EOF") return {};
            if (section == "ENTITIES")
                into = &file.entities;
            else if (section == "BLOCKS" && !block.empty())
                into = &file.blocks[block].entities;
            else
                into = nullptr;
            if (into != nullptr) into->push_back({group.value, {}});
        }
        return fault_.empty() ? "ends before its EOF" : fault_;
    }

private:
    bool line(std::string_view& out) {
        if (at_ >= text_.size()) return false;
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        out = trimmed(text_.substr(at_, end - at_));
        at_ = end + 1;
        ++line_;
        return true;
    }
    bool next(Group& group) {
        std::string_view code;
        if (!line(code)) return false;
        const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
        if (error != std::errc() || end != code.data() + code.size()) {
            fault_ = "line " + std::to_string(line_) + ": a group code was expected";
            return true;
        }
        return line(group.value);
    }
    void headOfBlock(const Group& group, DxfFile& file, std::string& block) const {
        if (group.code == 2) {
            block = std::string(group.value);
            file.blocks[block] = {};
        }
        if (block.empty()) return;
        const double value = parseNumber(group.value).value_or(0.0);
        if (group.code == 10) file.blocks[block].base.x = value;
        if (group.code == 20) file.blocks[block].base.y = value;
    }

    std::string_view text_;
    std::size_t at_ = 0, line_ = 0;
    bool inBlockHead_ = false;
    std::string fault_;
};

/// Draws the entities of a DXF file.
class DxfPainter {
public:
    DxfPainter(const DxfFile& file, CurveWriter& writer) : file_(file), writer_(writer) {}

    void paint(const std::vector<Entity>& entities, int depth) {
        for (std::size_t i = 0; i < entities.size() && !writer_.fault(); ++i) {
            const Entity& entity = entities[i];
            if (entity.whole(67) == 1) continue; // in paper space
            if (depth == 0 || entity.text(8) != "0") writer_.layer = cleanLine(std::string(entity.text(8)));
            const PlanTransform before = writer_.transform;
            if (entity.type == "POLYLINE") {
                std::size_t last = i + 1;
                while (last < entities.size() && entities[last].type == "VERTEX") ++last;
                if (turnToPlan(entity)) polyline(entity, std::span(entities).subspan(i + 1, last - i - 1));
                i = last - 1;
            } else if (entity.type != "SEQEND" && entity.type != "VERTEX" && turnToPlan(entity)) {
                paint(entity, depth);
            }
            writer_.finish();
            writer_.transform = before;
        }
    }

private:
    /// Some entities have coordinates of their own, given by an extrusion direction. From below they are mirrored.
    bool turnToPlan(const Entity& entity) {
        if (entity.type == "LINE" || entity.type == "POINT" || entity.type == "ELLIPSE" || entity.type == "SPLINE")
            return true;
        const double x = entity.number(210), y = entity.number(220), z = entity.number(230, 1.0);
        constexpr double askew = 1e-9;
        if (!(std::abs(x) < askew && std::abs(y) < askew && std::abs(z) > 0.5)) {
            writer_.note("figures that do not lie in the XY plane are left out");
            return false;
        }
        if (z < 0.0) writer_.transform = combined(writer_.transform, {{-1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}});
        return true;
    }

    void paint(const Entity& entity, int depth) {
        if (entity.type == "LINE") {
            writer_.moveTo(entity.place(10));
            writer_.lineTo(entity.place(11));
        } else if (entity.type == "CIRCLE") {
            circle(entity);
        } else if (entity.type == "ARC") {
            arc(entity);
        } else if (entity.type == "ELLIPSE") {
            ellipse(entity);
        } else if (entity.type == "LWPOLYLINE") {
            lightPolyline(entity);
        } else if (entity.type == "SPLINE") {
            spline(entity);
        } else if (entity.type == "POINT") {
            writer_.point(entity.place(10));
        } else if (entity.type == "INSERT") {
            insert(entity, depth);
        } else if (entity.type != "ATTRIB" && entity.type != "ATTDEF") {
            writer_.note(cleanLine(std::string(entity.type)) + " is left out");
        }
    }

    void circle(const Entity& entity) {
        const double radius = entity.number(40);
        if (!(radius > 0.0)) return;
        writer_.ellipse(entity.place(10), {radius, 0.0}, {0.0, radius}, 0.0, 2.0 * pi);
        writer_.close();
        writer_.point(entity.place(10));
    }
    void arc(const Entity& entity) {
        const double radius = entity.number(40), from = entity.number(50) * pi / 180.0;
        double sweep = entity.number(51) * pi / 180.0 - from;
        if (!(radius > 0.0) || !std::isfinite(sweep)) return;
        sweep = std::fmod(sweep, 2.0 * pi);
        if (sweep <= 0.0) sweep += 2.0 * pi;
        writer_.ellipse(entity.place(10), {radius, 0.0}, {0.0, radius}, from, sweep);
    }
    void ellipse(const Entity& entity) {
        const glm::dvec2 major = entity.place(11);
        const double side = entity.number(230, 1.0) < 0.0 ? -1.0 : 1.0;
        const glm::dvec2 minor = side * entity.number(40, 1.0) * glm::dvec2(-major.y, major.x);
        const double from = entity.number(41), to = entity.number(42, 2.0 * pi);
        if (!std::isfinite(from) || !std::isfinite(to)) return;
        double sweep = std::fmod(to - from, 2.0 * pi);
        const bool whole = std::abs(to - from) >= 2.0 * pi - 1e-9;
        if (sweep <= 0.0 || whole) sweep = whole ? 2.0 * pi : sweep + 2.0 * pi;
        writer_.ellipse(entity.place(10), major, minor, from, sweep);
        if (whole) writer_.close();
    }

    /// A corner with the bulge of the side that begins there.
    struct Corner {
        glm::dvec2 place{0.0};
        double bulge = 0.0;
    };
    void corners(const std::vector<Corner>& corners, bool closed) {
        if (corners.empty()) return;
        writer_.moveTo(corners.front().place);
        for (std::size_t i = 1; i < corners.size(); ++i) writer_.bulgeTo(corners[i].place, corners[i - 1].bulge);
        if (!closed) return;
        writer_.bulgeTo(corners.front().place, corners.back().bulge);
        writer_.close();
    }
    void lightPolyline(const Entity& entity) {
        std::vector<Corner> all;
        for (const Group& group : entity.groups) {
            const double value = parseNumber(group.value).value_or(std::nan(""));
            if (group.code == 10) all.push_back({{value, 0.0}, 0.0});
            if (all.empty()) continue;
            if (group.code == 20) all.back().place.y = value;
            if (group.code == 42) all.back().bulge = value;
        }
        corners(all, (entity.whole(70) & 1) != 0);
    }
    void polyline(const Entity& entity, std::span<const Entity> vertices) {
        constexpr int mesh = 16 | 64, frame = 16;
        const int flags = entity.whole(70);
        if ((flags & mesh) != 0) return writer_.note("a mesh of polygons is left out");
        std::vector<Corner> all;
        for (const Entity& vertex : vertices)
            if ((vertex.whole(70) & frame) == 0) all.push_back({vertex.place(10), vertex.number(42)});
        corners(all, (flags & 1) != 0);
    }

    void spline(const Entity& entity) {
        const std::vector<double> x = entity.all(10), y = entity.all(20);
        RationalSpline curve{entity.whole(71, 3), entity.all(40), {}, entity.all(41)};
        for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
            curve.controls.push_back(writer_.transform.of({x[i], y[i]}));
        const bool closed = (entity.whole(70) & 1) != 0;
        if (!isValid(curve)) {
            if (x.empty() && !entity.all(11).empty())
                return writer_.note("a spline that states fit points alone is left out");
            return writer_.note("a spline with wrong knots or weights is left out");
        }
        writer_.transform = {};
        const std::vector<glm::dvec2> places = flattened(curve, drawingChord);
        writer_.moveTo(places.front());
        for (std::size_t i = 1; i < places.size(); ++i) writer_.lineTo(places[i]);
        if (closed) writer_.close();
    }

    void insert(const Entity& entity, int depth) {
        const auto block = file_.blocks.find(entity.text(2));
        if (block == file_.blocks.end()) return writer_.note("a block that the file does not define is left out");
        if (depth >= deepestInsert) return writer_.note("blocks within blocks deeper than 16 are left out");
        const double turn = entity.number(50) * pi / 180.0;
        const glm::dvec2 scale(entity.number(41, 1.0), entity.number(42, 1.0));
        const glm::dvec2 along(std::cos(turn), std::sin(turn)), across(-along.y, along.x);
        const int columns = std::clamp(entity.whole(70, 1), 1, 1000), rows = std::clamp(entity.whole(71, 1), 1, 1000);
        const PlanTransform outside = writer_.transform;
        const std::string layer = writer_.layer;
        for (int row = 0; row < rows && !writer_.fault(); ++row)
            for (int column = 0; column < columns && !writer_.fault(); ++column) {
                const glm::dvec2 shift =
                    entity.place(10) + column * entity.number(44) * along + row * entity.number(45) * across;
                PlanTransform placed{scale.x * along, scale.y * across, shift};
                placed.shift -= placed.ofVector(block->second.base);
                writer_.transform = combined(outside, placed);
                writer_.layer = layer;
                if (++inserts_ > mostInserts) return writer_.note("more than 100,000 blocks are left out");
                paint(block->second.entities, depth + 1);
            }
        writer_.transform = outside;
    }

    static constexpr std::size_t mostInserts = 100'000;
    const DxfFile& file_;
    CurveWriter& writer_;
    std::size_t inserts_ = 0;
};

} // namespace

Result<PlanDrawing> dxfDrawing(std::string_view text, const std::string& origin, double unit) {
    DxfFile file;
    if (const std::string fault = DxfReader(text).read(file); !fault.empty())
        return Error{ErrorCode::resourceInvalid, origin, {}, fault};
    PlanDrawing drawing;
    const double stated = millimetresOf(file.insertUnits);
    drawing.unitStated = unit > 0.0 || stated > 0.0;
    drawing.unit = unit > 0.0 ? unit : stated > 0.0 ? stated : 1.0;
    CurveWriter writer(drawing);
    writer.transform = {{drawing.unit, 0.0}, {0.0, drawing.unit}, {0.0, 0.0}};
    DxfPainter(file, writer).paint(file.entities, 0);
    if (writer.fault()) return Error{ErrorCode::resourceInvalid, origin, {}, *writer.fault()};
    return drawing;
}

} // namespace burin
