// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// FreeCAD's tool bits: src/Mod/CAM/Path/Tool/shape/models and src/Mod/CAM/Tools/Bit of its sources.
#include "core/base/degrees.h"
#include "core/base/numbers.h"
#include "core/base/resource_folder.h"
#include "core/base/units.h"
#include "core/tool/cutter_shape.h"
#include "core/tool/foreign_tool.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace burin {

namespace {

using nlohmann::json;

constexpr double degree = pi / 180.0;

struct Shape {
    std::string_view name; ///< in lower case
    CutterType type;
};
constexpr std::array shapes{Shape{"endmill", CutterType::flat},      Shape{"ballend", CutterType::ball},
                            Shape{"bullnose", CutterType::bullNose}, Shape{"torus", CutterType::bullNose},
                            Shape{"drill", CutterType::drill},       Shape{"vbit", CutterType::chamfer},
                            Shape{"v-bit", CutterType::chamfer},     Shape{"chamfer", CutterType::chamfer}};

struct BitUnit {
    std::string_view name;
    double size; ///< mm or rad
};
constexpr std::array lengthUnits{BitUnit{"mm", 1.0},   BitUnit{"cm", 10.0},  BitUnit{"m", 1000.0},
                                 BitUnit{"um", 0.001}, BitUnit{"µm", 0.001}, BitUnit{"in", 25.4},
                                 BitUnit{"\"", 25.4},  BitUnit{"ft", 304.8}, BitUnit{"'", 304.8}};
constexpr std::array angleUnits{BitUnit{"°", degree}, BitUnit{"deg", degree}, BitUnit{"rad", 1.0}};

std::string smallLetters(std::string text) {
    for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

/// Reads the values of a bit, and keeps the first error.
class BitReader {
public:
    BitReader(const json& bit, std::string origin, const Tool& like)
        : parameters_(part(bit, "parameter"))
        , attributes_(part(bit, "attribute"))
        , bit_(bit)
        , origin_(std::move(origin))
        , like_(like) {}

    Result<ReadTool> read() {
        Result<CutterType> type = shape();
        if (!type) return type.error();
        Tool& tool = result_.tool;
        tool = like_;
        tool.name = textOf("name");
        if (tool.name.empty()) return wrong("name", "has to be there");
        tool.id = resourceIdFrom(tool.name);
        if (tool.id.empty()) return wrong("name", "has to have a letter or a digit");
        tool.source = "FreeCAD tool bit " + origin_.substr(origin_.find_last_of('/') + 1);
        tool.sources.clear();
        tool.presets.clear();
        readCutter(*type);
        if (fault_) return *fault_;
        tool.cutter = fitted(tool.cutter);
        tool.maximumDepthOfCut = std::min(tool.cutter.fluteLength, like_.maximumDepthOfCut);
        readFreecadPresets(bit_, result_);
        keepSoundPresets(result_);
        // The values must be valid in one of Burin's own files.
        if (Result<Tool> sound = toolFromJson(toJson(tool), origin_); !sound) return sound.error();
        return std::move(result_);
    }

private:
    static const json& part(const json& bit, const char* key) {
        static const json none = json::object();
        const auto found = bit.find(key);
        return found != bit.end() && found->is_object() ? *found : none;
    }
    Error wrong(std::string_view key, std::string why) const {
        return {ErrorCode::resourceInvalid, origin_, std::string(key), std::move(why)};
    }
    std::string textOf(const char* key) const {
        const auto found = bit_.find(key);
        return found != bit_.end() && found->is_string() ? found->get<std::string>() : std::string();
    }

    Result<CutterType> shape() const {
        std::string name = smallLetters(textOf("shape-type"));
        if (name.empty()) {
            name = smallLetters(textOf("shape"));
            name = name.substr(name.find_last_of('/') + 1);
            name = name.substr(0, name.find('.'));
        }
        const auto found = std::ranges::find(shapes, name, &Shape::name);
        if (found != shapes.end()) return found->type;
        return Error{ErrorCode::notSupported, "a FreeCAD tool bit of the form \"" + name + "\"",
                     "an end mill, a ball end, a bull nose, a drill, a V-bit or a chamfer", ""};
    }

    void readCutter(CutterType type) {
        Cutter& cutter = result_.tool.cutter;
        cutter.profile.clear();
        cutter.type = type;
        cutter.diameter = length("Diameter").value_or(0.0);
        if (!(cutter.diameter > 0.0)) fail("parameter.Diameter", "has to be there, above 0");
        cutter.cornerRadius = length("CornerRadius").value_or(0.0);
        if (const auto flat = length("FlatRadius");
            type == CutterType::bullNose && !(cutter.cornerRadius > 0.0) && flat) {
            cutter.cornerRadius = cutter.radius() - *flat;
            note("FlatRadius was read as the radius of the flat: a corner radius of " +
                 formatShortest(cutter.cornerRadius) + " mm.");
        }
        if (type == CutterType::bullNose && !(cutter.cornerRadius > 0.0 && cutter.cornerRadius < cutter.radius()))
            fail("parameter.CornerRadius", "has to be there, above 0 and below half the diameter");
        cutter.tipDiameter = length("TipDiameter").value_or(0.0);
        const std::optional<double> angle = type == CutterType::drill ? full("TipAngle") : full("CuttingEdgeAngle");
        cutter.taperAngle = angle.value_or(0.0) / 2.0;
        if (type == CutterType::chamfer && !angle) fail("parameter.CuttingEdgeAngle", "has to be there");
        if (type == CutterType::drill && !angle) note("The bit has no TipAngle; 118° is used.");
        if (const auto height = length("CuttingEdgeHeight"))
            cutter.fluteLength = *height;
        else
            note("The bit has no length of the flutes: " + formatShortest(cutter.fluteLength) + " mm of " + like_.id +
                 " were taken.");
        cutter.shankDiameter = length("ShankDiameter").value_or(cutter.diameter);
        readHeld();
    }

    /// A bit does not state how it is held: a stick-out that is too short places the holder too low, never too high.
    void readHeld() {
        Cutter& cutter = result_.tool.cutter;
        if (const auto whole = length("Length")) cutter.stickOut = std::min(cutter.stickOut, *whole);
        note("Stick-out, holder, number and limits are those of " + like_.id + ": enter your own.");
        if (const auto flutes = count("Flutes"))
            result_.tool.fluteCount = *flutes;
        else
            note("The bit has no number of flutes: " + std::to_string(like_.fluteCount) + " were taken.");
    }

    const json* value(const char* key) const {
        for (const json* each : {&parameters_, &attributes_})
            if (const auto found = each->find(key); found != each->end()) return &*found;
        return nullptr;
    }

    /// Returns a number followed by a unit; a number without unit is in the first unit.
    template <std::size_t size>
    std::optional<double> quantity(const char* key, const std::array<BitUnit, size>& units) {
        const json* written = value(key);
        if (written == nullptr) return std::nullopt;
        if (written->is_number()) return written->get<double>() * units.front().size;
        const std::string whole = written->is_string() ? written->get<std::string>() : std::string();
        const auto [number, unit] = numberWithUnit(whole);
        const auto known = std::ranges::find(units, unit, &BitUnit::name);
        if (!number || (!unit.empty() && known == units.end())) {
            fail(std::string("parameter.") + key, "is no number with a unit that is known: \"" + whole + "\"");
            return std::nullopt;
        }
        return *number * (unit.empty() ? units.front().size : known->size);
    }
    std::optional<double> length(const char* key) { return quantity(key, lengthUnits); }
    std::optional<double> full(const char* key) { return quantity(key, angleUnits); }

    std::optional<int> count(const char* key) {
        const json* written = value(key);
        if (written == nullptr) return std::nullopt;
        const std::optional<double> number = written->is_number()   ? std::optional(written->get<double>())
                                             : written->is_string() ? parseNumber(written->get<std::string>())
                                                                    : std::nullopt;
        if (number && *number >= 1.0 && *number <= 100.0) return static_cast<int>(std::lround(*number));
        if (number && *number == 0.0) return std::nullopt; // FreeCAD's "not stated"
        fail(std::string("parameter.") + key, "has to be a count from 1 to 100");
        return std::nullopt;
    }

    void fail(const std::string& key, std::string why) {
        if (!fault_) fault_ = wrong(key, std::move(why));
    }
    void note(std::string text) { result_.notes.push_back(std::move(text)); }

    const json& parameters_;
    const json& attributes_;
    const json& bit_;
    std::string origin_;
    const Tool& like_;
    std::optional<Error> fault_;
    ReadTool result_;
};

bool hasSteps(const CuttingPreset& preset) {
    return preset.stepDown > 0.0 || preset.stepOver > 0.0 || preset.coolant;
}

std::string millimetres(double value) {
    return formatShortest(value) + " mm";
}

} // namespace

Result<ReadTool> toolFromText(std::string_view text, const std::string& origin, const Tool& like) {
    const json file = json::parse(text, nullptr, false);
    if (file.is_object() && file.contains("shape") && file.contains("parameter"))
        return BitReader(file, origin, like).read();
    Result<Tool> tool = toolFromJson(text, origin);
    if (!tool) return tool.error();
    return ReadTool{std::move(*tool), {}};
}

Result<WrittenTools> freecadBit(const Tool& tool) {
    const Cutter& cutter = tool.cutter;
    struct Form {
        CutterType type;
        const char *shape, *name;
    };
    constexpr std::array forms{
        Form{CutterType::flat, "endmill.fcstd", "Endmill"}, Form{CutterType::ball, "ballend.fcstd", "Ballend"},
        Form{CutterType::bullNose, "bullnose.fcstd", "Bullnose"}, Form{CutterType::drill, "drill.fcstd", "Drill"},
        Form{CutterType::chamfer, "chamfer.fcstd", "Chamfer"}};
    const auto form = std::ranges::find(forms, cutter.type, &Form::type);
    if (form == forms.end())
        return Error{ErrorCode::notSupported, "a FreeCAD tool bit of the form of " + tool.id,
                     "an end mill, a ball end, a bull nose, a drill or a chamfer", ""};
    using nlohmann::ordered_json;
    ordered_json parameters{{"CuttingEdgeHeight", millimetres(cutter.fluteLength)},
                            {"Diameter", millimetres(cutter.diameter)},
                            {"Flutes", tool.fluteCount},
                            {"Length", millimetres(cutter.stickOut)},
                            {"ShankDiameter", millimetres(cutter.shankDiameter)}};
    const auto angle = [&] { return formatShortest(roundedDegrees(2.0 * cutter.taperAngle)) + " °"; };
    if (cutter.type == CutterType::bullNose) parameters["CornerRadius"] = millimetres(cutter.cornerRadius);
    if (cutter.type == CutterType::drill) parameters["TipAngle"] = angle();
    if (cutter.type == CutterType::chamfer) {
        parameters["CuttingEdgeAngle"] = angle();
        parameters["TipDiameter"] = millimetres(cutter.tipDiameter);
    }
    ordered_json bit{{"version", 2},
                     {"name", tool.name},
                     {"shape", form->shape},
                     {"shape-type", form->name},
                     {"parameter", parameters},
                     {"attribute", ordered_json::object()}};
    WrittenTools written;
    written.notes = {"Length is the stick-out, as far as Burin knows the tool.", lostInBit};
    if (!tool.presets.empty()) bit["presets"] = freecadPresets(tool);
    if (std::ranges::any_of(tool.presets, hasSteps))
        written.notes.emplace_back(
            "Step-down, step-over and coolant of presets can't be stored in a FreeCAD tool bit.");
    written.text = bit.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
    return written;
}

} // namespace burin
