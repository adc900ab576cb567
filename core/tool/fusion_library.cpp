// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Fusion's tool library: its files contain one object for each tool, with lengths in the unit that the object states.
#include "core/base/checksum.h"
#include "core/base/clean_text.h"
#include "core/base/degrees.h"
#include "core/base/units.h"
#include "core/base/zip_archive.h"
#include "core/tool/foreign_tool.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

using nlohmann::json;

constexpr double degree = pi / 180.0;

struct Form {
    std::string_view name;
    CutterType type;
};
/// For writing, the first entry of a type is used.
constexpr std::array forms{Form{"ball end mill", CutterType::ball},
                           Form{"flat end mill", CutterType::flat},
                           Form{"bull nose end mill", CutterType::bullNose},
                           Form{"tapered mill", CutterType::taper},
                           Form{"drill", CutterType::drill},
                           Form{"chamfer mill", CutterType::chamfer},
                           Form{"lollipop mill", CutterType::lollipop},
                           Form{"face mill", CutterType::flat},
                           Form{"spot drill", CutterType::drill},
                           Form{"engrave chamfer mill", CutterType::chamfer}};

/// One tool of a library.
class FusionReader {
public:
    FusionReader(const json& item, const Tool& like)
        : item_(item), geometry_(part(item, "geometry")), like_(like), unit_(text("unit") == "inches" ? 25.4 : 1.0) {}

    /// Returns the tool's name for messages.
    std::string name() const {
        const std::string description = text("description"), product = text("product-id");
        return !description.empty() ? description : !product.empty() ? product : text("type");
    }

    /// Empty for a shape that Burin does not have.
    std::optional<ReadTool> read() {
        const auto form = std::ranges::find(forms, text("type"), &Form::name);
        if (form == forms.end() || isTaperBall(form->type)) return std::nullopt;
        Tool& tool = result_.tool;
        tool = like_;
        tool.name = cleanLine(name());
        tool.source = "Fusion tool library";
        if (const std::string vendor = text("vendor"); !vendor.empty()) tool.source += ", " + cleanLine(vendor);
        if (const std::string product = text("product-id"); !product.empty()) tool.source += " " + cleanLine(product);
        tool.sources.clear();
        tool.presets.clear();
        readNumber();
        readCutter(form->type);
        readHolder();
        note("Limits and strength are those of " + like_.id + ": enter your own.");
        readFusionPresets(item_, unit_, result_);
        if (item_.contains("expressions") && !item_["expressions"].empty())
            note("Expressions were not imported, only the numbers.");
        return std::move(result_);
    }

private:
    static const json& part(const json& of, const char* key) {
        static const json none = json::object();
        const auto found = of.find(key);
        return found != of.end() && found->is_object() ? *found : none;
    }
    std::string text(const char* key) const { return textIn(item_, key); }
    std::optional<double> number(const char* key) const {
        const auto found = geometry_.find(key);
        if (found == geometry_.end() || !found->is_number()) return std::nullopt;
        return found->get<double>();
    }
    std::optional<double> length(const char* key) const {
        const std::optional<double> value = number(key);
        return value ? std::optional(*value * unit_) : value;
    }
    void note(std::string sentence) { result_.notes.push_back(std::move(sentence)); }

    /// Whether the tool is a taper ball mill, for which files state the transition from ball to cone in different ways.
    bool isTaperBall(CutterType type) const {
        const double tip = number("DC").value_or(0.0), corner = number("RE").value_or(0.0);
        return type == CutterType::taper && corner > 0.0 && corner >= 0.499 * tip;
    }

    void readNumber() {
        const json& post = part(item_, "post-process");
        if (const auto t = post.find("number"); t != post.end() && t->is_number_integer())
            result_.tool.number = wholeNumberOf(*t);
        else
            note("No tool number: T" + std::to_string(like_.number) + " is used.");
        if (const std::optional<double> flutes = number("NOF"); flutes && *flutes >= 1.0)
            result_.tool.fluteCount = static_cast<int>(std::lround(std::min(*flutes, 1000.0)));
    }

    void readCutter(CutterType type) {
        Cutter& cutter = result_.tool.cutter;
        cutter.profile.clear();
        cutter.type = type;
        cutter.diameter = length("DC").value_or(0.0);
        const bool ball = type == CutterType::ball || type == CutterType::lollipop;
        cutter.cornerRadius = ball ? cutter.radius() : length("RE").value_or(0.0);
        cutter.tipDiameter = length("tip-diameter").value_or(0.0);
        cutter.taperAngle = angle(type);
        if (type == CutterType::taper) readTaper();
        cutter.fluteLength = length("LCF").value_or(like_.cutter.fluteLength);
        cutter.shankDiameter = length("SFDM").value_or(cutter.diameter);
        cutter.stickOut = std::max(length("LB").value_or(like_.cutter.stickOut), cutter.fluteLength);
        if (!number("LCF")) note("No flute length: the one of " + like_.id + " is used.");
        if (!number("LB")) note("No length below the holder: the stick-out of " + like_.id + " is used.");
        readShaft();
    }

    /// Returns the angle between axis and cone, rad. A drill states the full point angle, the others half of it.
    double angle(CutterType type) const {
        if (type == CutterType::drill) return number("SIG").value_or(118.0) * 0.5 * degree;
        return number("TA").value_or(0.0) * degree;
    }

    /// The diameter of a taper is that of its tip; in Burin it is the largest one.
    void readTaper() {
        Cutter& cutter = result_.tool.cutter;
        cutter.tipDiameter = cutter.diameter;
        cutter.diameter += 2.0 * length("LCF").value_or(0.0) * std::tan(cutter.taperAngle);
    }

    /// The widest step of the shaft is used for the shank, so that it is never too narrow.
    void readShaft() {
        const json& shaft = part(item_, "shaft");
        const auto segments = shaft.find("segments");
        if (segments == shaft.end() || !segments->is_array()) return;
        double& shank = result_.tool.cutter.shankDiameter;
        bool stepped = false;
        for (const json& segment : *segments)
            for (const char* key : {"lower-diameter", "upper-diameter"})
                if (const auto width = segment.find(key); width != segment.end() && width->is_number()) {
                    const double diameter = width->get<double>() * unit_;
                    stepped = stepped || std::abs(diameter - shank) > 1e-6;
                    shank = std::max(shank, diameter);
                }
        if (stepped) note("The shaft has steps: its largest diameter is used for the whole shank.");
    }

    void readHolder() {
        const json& holder = part(item_, "holder");
        const auto segments = holder.find("segments");
        if (segments == holder.end() || !segments->is_array() || segments->empty()) {
            note("No holder: the one of " + like_.id + " is used.");
            return;
        }
        const auto unit = holder.find("unit");
        const double size = unit != holder.end() && unit->is_string() ? (*unit == "inches" ? 25.4 : 1.0) : unit_;
        std::vector<HolderSegment>& own = result_.tool.cutter.holder;
        own.clear();
        for (const json& segment : *segments) {
            const auto value = [&](const char* key) {
                const auto found = segment.find(key);
                return found != segment.end() && found->is_number() ? found->get<double>() * size : 0.0;
            };
            const HolderSegment read{value("lower-diameter"), value("upper-diameter"), value("height")};
            if (read.length > 0.0) own.push_back(read);
        }
    }

    const json& item_;
    const json& geometry_;
    const Tool& like_;
    double unit_; ///< mm
    ReadTool result_;
};

/// Returns a GUID that is always the same for the same tool.
std::string guidOf(const Tool& tool) {
    constexpr std::array places{8, 4, 4, 4, 12};
    static constexpr std::string_view digits = "0123456789abcdef";
    std::uint64_t bits = checksum(tool.id);
    std::string guid;
    for (const int length : places) {
        if (!guid.empty()) guid += '-';
        for (int i = 0; i < length; ++i) {
            guid += digits[bits & 15U];
            bits = (bits >> 4U) | (bits << 60U);
        }
    }
    return guid;
}

json geometryOf(const Tool& tool) {
    const Cutter& cutter = tool.cutter;
    json geometry{
        {"DC", cutter.diameter},  {"LCF", cutter.fluteLength}, {"LB", cutter.stickOut}, {"SFDM", cutter.shankDiameter},
        {"NOF", tool.fluteCount}, {"OAL", cutter.stickOut},    {"HAND", true},          {"CSP", false}};
    const double half = roundedDegrees(cutter.taperAngle);
    switch (cutter.type) {
    case CutterType::ball:
    case CutterType::bullNose:
        geometry["RE"] = cutter.cornerRadius;
        break;
    case CutterType::taper:
        geometry["DC"] = cutter.tipDiameter;
        geometry["TA"] = half;
        geometry["RE"] = cutter.cornerRadius;
        break;
    case CutterType::drill:
        geometry["SIG"] = 2.0 * half;
        break;
    case CutterType::chamfer:
        geometry["TA"] = half;
        geometry["tip-diameter"] = cutter.tipDiameter;
        break;
    default:
        break;
    }
    return geometry;
}

/// Whether Fusion has the shape: of tapers, only those whose cone reaches to the end of the flutes, and no taper ball.
bool fits(const Cutter& cutter) {
    if (cutter.type == CutterType::profile || cutter.type == CutterType::taperBall) return false;
    if (cutter.type != CutterType::taper) return true;
    return std::abs(cutter.tipDiameter + 2.0 * cutter.fluteLength * std::tan(cutter.taperAngle) - cutter.diameter) <
           1e-6;
}

json itemOf(const Tool& tool) {
    json segments = json::array();
    for (const HolderSegment& segment : tool.cutter.holder)
        segments.push_back({{"height", segment.length},
                            {"lower-diameter", segment.lowerDiameter},
                            {"upper-diameter", segment.upperDiameter}});
    json item{{"type", std::ranges::find(forms, tool.cutter.type, &Form::type)->name},
              {"unit", "millimeters"},
              {"guid", guidOf(tool)},
              {"description", tool.name},
              {"vendor", ""},
              {"product-id", tool.id},
              {"BMC", "carbide"},
              {"geometry", geometryOf(tool)},
              {"post-process",
               {{"number", tool.number},
                {"length-offset", tool.number},
                {"diameter-offset", tool.number},
                {"turret", 0},
                {"break-control", false},
                {"live", true},
                {"manual-tool-change", false},
                {"comment", ""}}},
              {"start-values", {{"presets", fusionPresets(tool)}}}};
    if (!segments.empty())
        item["holder"] = {{"type", "holder"}, {"unit", "millimeters"}, {"segments", std::move(segments)}};
    return item;
}

} // namespace

Result<ReadTools> readFusion(const json& library, const std::string& origin, const Tool& like) {
    ReadTools read;
    for (const json& item : library.at("data")) {
        if (!item.is_object()) continue;
        FusionReader reader(item, like);
        const std::string name = reader.name();
        std::optional<ReadTool> tool = reader.read();
        if (!tool) {
            read.leftOut.push_back(name + ": Burin does not support this shape.");
            continue;
        }
        Result<ReadTool> sound = soundTool(std::move(*tool), origin, like);
        if (sound)
            read.tools.push_back(std::move(*sound));
        else
            read.leftOut.push_back(name + ": " + sound.error().place + " " + sound.error().detail + ".");
    }
    return read;
}

Result<WrittenTools> fusionLibrary(const std::vector<Tool>& tools) {
    WrittenTools written;
    json data = json::array();
    for (const Tool& tool : tools) {
        if (fits(tool.cutter))
            data.push_back(itemOf(tool));
        else
            written.notes.push_back(tool.id + ": Fusion does not support this shape.");
    }
    if (data.empty()) return Error{ErrorCode::notSupported, "a Fusion tool library of these tools", "other forms", ""};
    const json library{{"data", std::move(data)}, {"version", 36}};
    std::optional<std::string> packed =
        zippedFile("tools.json", library.dump(2, ' ', false, json::error_handler_t::replace));
    if (!packed) return Error{ErrorCode::outOfMemory, "tools", {}, {}};
    written.text = std::move(*packed);
    written.notes.emplace_back("Limits, strength and sources of values can't be stored in this format.");
    return written;
}

} // namespace burin
