// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/tool_form.h"

#include "core/base/units.h"
#include "core/tool/cutter_shape.h"
#include "core/tool/tool_ranges.h"
#include "core/tool/tool_solid.h"
#include "ui/panels/preset_table.h"
#include "ui/panels/segment_table.h"

#include <QCoreApplication>
#include <QLineEdit>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr NumberRange aboveZero{0.001, tool_range::length.high}; // mm
constexpr double degree = pi / 180.0;

bool alike(const HolderSegment& one, const HolderSegment& other) {
    return one.lowerDiameter == other.lowerDiameter && one.upperDiameter == other.upperDiameter &&
           one.length == other.length;
}

auto ofCutter(double Cutter::*value) {
    return [value](const Tool& tool) { return tool.cutter.*value; };
}
auto setCutter(double Cutter::*value) {
    return [value](Tool& tool, double entered) { tool.cutter.*value = entered; };
}
auto ofTool(double Tool::*value) {
    return [value](const Tool& tool) { return tool.*value; };
}
auto setTool(double Tool::*value) {
    return [value](Tool& tool, double entered) { tool.*value = entered; };
}
bool isFixedTool(const Tool& tool) {
    return !tool.cutter.turns();
}
double bladeDirection(const Tool& tool) {
    return isFixedTool(tool) ? tool.cutter.solid->angle : 0.0;
}
void setBladeDirection(Tool& tool, double entered) {
    if (!isFixedTool(tool)) return;
    ToolSolid solid = *tool.cutter.solid;
    solid.angle = entered;
    tool.cutter.solid = std::make_shared<const ToolSolid>(std::move(solid));
}
auto freeIn(CutterValue value) {
    return [value](const Tool& tool) { return isFree(tool.cutter.type, value); };
}

} // namespace

ToolForm::ToolForm(std::vector<Holder> holders, std::vector<Property> materials, QWidget* parent)
    : RecordForm(tr("as stated in the tool's source"), parent), holders_(std::move(holders)) {
    setObjectName(QStringLiteral("toolForm"));
    addGeneral();
    addFlutes();
    addShank();
    addHolder();
    addLimits();
    addPresets(std::move(materials));
    closeRows();
}

void ToolForm::addGeneral() {
    addText("toolName", tr("Name"), tr("Name in the list of tools"), &Tool::name);
    addNumbers("number", tr("Number"), tr("T in programs"),
               {{Quantity::count,
                 {1, tool_range::highestNumber},
                 false,
                 [](const Tool& tool) { return static_cast<double>(tool.number); },
                 [](Tool& tool, double value) { tool.number = static_cast<int>(std::lround(value)); }}},
               false);
    addText("toolSource", tr("Source"), tr("Source of the values that have none of their own"), &Tool::source);
}

void ToolForm::addFlutes() {
    addTitle(tr("Flutes"));
    addChoice("cutter", tr("Form"), tr("What the flutes sweep"),
              {{tr("Ball end"), tr("Flat end"), tr("Bull nose"), tr("Tapered"), tr("Tapered ball"), tr("Drill"),
                tr("Chamfer"), tr("Lollipop"), tr("Profile of lines and arcs")},
               [](const Tool& tool) { return static_cast<int>(tool.cutter.type); },
               [](Tool& tool, int type) {
                   // A profile is drawn in a file or comes from a model: it can't be selected here.
                   if (static_cast<CutterType>(type) != CutterType::profile)
                       tool.cutter.type = static_cast<CutterType>(type);
               }});
    const auto add = [this](const char* key, const QString& label, const QString& toolTip, double Cutter::*value,
                            CutterValue free, NumberRange range) {
        addNumbers(key, label, toolTip,
                   {{Quantity::length, range, false, ofCutter(value), setCutter(value), freeIn(free)}}, false);
    };
    add("cutter.diameter_mm", tr("Diameter"), tr("Of the flutes where they are widest"), &Cutter::diameter,
        CutterValue::diameter, aboveZero);
    add("cutter.corner_radius_mm", tr("Corner radius"), tr("Of the rounded edge, or of the ball at the tip"),
        &Cutter::cornerRadius, CutterValue::cornerRadius, tool_range::length);
    add("cutter.tip_diameter_mm", tr("Tip diameter"), tr("Of the flat at the tip, before its edge is rounded"),
        &Cutter::tipDiameter, CutterValue::tipDiameter, tool_range::length);
    addNumbers("cutter.taper_angle_deg", tr("Angle per side"), tr("Between axis and cone: half of a point angle"),
               {{Quantity::angle,
                 {0.0, 89.0 * degree},
                 false,
                 ofCutter(&Cutter::taperAngle),
                 setCutter(&Cutter::taperAngle),
                 freeIn(CutterValue::taperAngle)}},
               false);
    add("cutter.flute_length_mm", tr("Length of the flutes"), tr("From the tip"), &Cutter::fluteLength,
        CutterValue::fluteLength, aboveZero);
    addNumbers("flute_count", tr("Number of flutes"), tr("Teeth that cut in one revolution"),
               {{Quantity::count,
                 {1, tool_range::mostFlutes},
                 false,
                 [](const Tool& tool) { return static_cast<double>(tool.fluteCount); },
                 [](Tool& tool, double value) { tool.fluteCount = static_cast<int>(std::lround(value)); }}});
    addNumbers(
        "cutter.angle_deg", tr("Direction"),
        tr("Of a tool that doesn't turn, about its axis: from X of the setup to X of its models, counterclockwise "
           "seen from above"),
        {{Quantity::angle, {-360.0 * degree, 360.0 * degree}, false, bladeDirection, setBladeDirection, isFixedTool}},
        false);
    addChoice("centre_cutting", tr("Cuts at its centre"), tr("May plunge straight down"),
              {{tr("No"), tr("Yes")},
               [](const Tool& tool) { return tool.centreCutting ? 1 : 0; },
               [](Tool& tool, int yes) { tool.centreCutting = yes == 1; }});
}

void ToolForm::addShank() {
    addTitle(tr("Shank"));
    addNumbers(
        "cutter.shank_diameter_mm", tr("Shank diameter"), tr("Between flutes and holder"),
        {{Quantity::length, aboveZero, false, ofCutter(&Cutter::shankDiameter), setCutter(&Cutter::shankDiameter)}},
        false);
    addNumbers("cutter.stick_out_mm", tr("Stick-out"), tr("From the tip to the face of the holder"),
               {{Quantity::length, aboveZero, false, ofCutter(&Cutter::stickOut), setCutter(&Cutter::stickOut)}},
               false);
}

QStringList ToolForm::holderTexts() const {
    QStringList texts{tr("As entered below")};
    for (const Holder& holder : holders_) texts << QCoreApplication::translate("Resource", holder.name.c_str());
    return texts;
}

int ToolForm::holderOf(const Tool& tool) const {
    const auto found = std::ranges::find_if(
        holders_, [&](const Holder& holder) { return std::ranges::equal(holder.segments, tool.cutter.holder, alike); });
    return found == holders_.end() ? 0 : static_cast<int>(found - holders_.begin()) + 1;
}

void ToolForm::addHolder() {
    addTitle(tr("Holder"));
    addChoice("holder", tr("Holder"), tr("Take over the segments of a holder of the library"),
              {holderTexts(), [this](const Tool& tool) { return holderOf(tool); },
               [this](Tool& tool, int index) {
                   if (index > 0) tool.cutter.holder = holders_[static_cast<std::size_t>(index) - 1].segments;
               }},
              false);
    segments_ = new SegmentTable(this);
    const int row =
        beginRow(tr("Segments"), segments_, tr("From the face upwards: diameter below, diameter above, length"));
    placeWide(segments_, row);
    connect(segments_, &SegmentTable::edited, this, [this](const std::vector<HolderSegment>& segments) {
        record_.cutter.holder = segments;
        changed("cutter");
    });
    onRefresh([this] { segments_->showSegments(record_.cutter.holder); });
}

void ToolForm::addLimits() {
    addTitle(tr("Limits"));
    const auto add = [this](const char* key, const QString& label, const QString& toolTip, Quantity quantity,
                            NumberRange range, bool optional, double Tool::*value) {
        addNumbers(key, label, toolTip, {{quantity, range, optional, ofTool(value), setTool(value)}});
    };
    add("maximum_depth_of_cut_mm", tr("Deepest cut"), tr("Along the axis; at most the length of the flutes"),
        Quantity::length, aboveZero, false, &Tool::maximumDepthOfCut);
    add("maximum_width_of_cut_mm", tr("Greatest width of cut"), tr("Across the axis"), Quantity::length,
        tool_range::length, true, &Tool::maximumWidthOfCut);
    add("maximum_chip_load_mm", tr("Greatest chip thickness"), tr("Per tooth"), Quantity::length, tool_range::length,
        true, &Tool::maximumChipLoad);
    add("maximum_spindle_speed_rpm", tr("Highest speed"), tr("Of the spindle, by the tool's maker"), Quantity::rotation,
        tool_range::spindleSpeed, true, &Tool::maximumSpindleSpeed);
    add("modulus_n_per_mm2", tr("Modulus of elasticity"), tr("Of what shank and flutes are made of"), Quantity::stress,
        tool_range::stiffness, true, &Tool::modulus);
    add("strength_n_per_mm2", tr("Strength"), tr("Stress at which it breaks when it is bent"), Quantity::stress,
        tool_range::breakage, true, &Tool::strength);
}

void ToolForm::addPresets(std::vector<Property> materials) {
    addTitle(tr("Feeds and speeds"));
    presets_ = new PresetTable(std::move(materials), this);
    const int row =
        beginRow(tr("Presets"), presets_,
                 tr("Feeds and speeds of your own. The first preset for the stock's material is used, without "
                    "one the first for any material, without one the values that the material states"));
    placeToEnd(presets_, row);
    connect(presets_, &PresetTable::edited, this, [this](const std::vector<CuttingPreset>& presets) {
        record_.presets = presets;
        changed("presets");
    });
    onRefresh([this] { presets_->showPresets(record_.presets, record_.cutter.radius(), record_.maximumDepthOfCut); });
}

/// Values that depend on the form are updated, and a value that is not stated has no source.
void ToolForm::settle(const std::string& key) {
    record_.cutter = fitted(record_.cutter);
    record_.maximumDepthOfCut = std::min(record_.maximumDepthOfCut, record_.cutter.fluteLength);
    record_.sources.erase("holder"); // not a key of its own, but part of the cutter
    record_.sources.erase("number");
    if (record_.presets.empty()) record_.sources.erase("presets");
    if (key == "holder") record_.sources["cutter"] = tr("entered by the user").toStdString();
    for (const auto& [name, value] : {std::pair{"modulus_n_per_mm2", record_.modulus},
                                      {"strength_n_per_mm2", record_.strength},
                                      {"maximum_chip_load_mm", record_.maximumChipLoad},
                                      {"maximum_width_of_cut_mm", record_.maximumWidthOfCut}})
        if (!(value > 0.0)) record_.sources.erase(name);
}

void ToolForm::setLengthUnit(LengthUnit unit) {
    setUnit(unit);
    segments_->setUnit(unit);
    presets_->setUnit(unit);
}

void ToolForm::showTool(const Tool& tool, bool locked) {
    record_ = tool;
    lock(locked);
    segments_->setEnabled(true); // enabled, so that they can be viewed
    segments_->setReadOnly(locked);
    presets_->setEnabled(true);
    presets_->setReadOnly(locked);
    refresh();
}

} // namespace burin
