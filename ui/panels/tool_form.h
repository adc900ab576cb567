// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/holder_library.h"
#include "core/tool/tool.h"
#include "core/volume/runs/property_list.h"
#include "ui/panels/value_form.h"

namespace burin {

class PresetTable;
class SegmentTable;

/// Fields for every value of a tool: name, number, form and lengths of the flutes, shank, the segments of its holder,
/// its load limits, and its presets of feeds and speeds. Values that the cutter type determines or doesn't have can't
/// be entered.
class ToolForm final : public RecordForm<Tool> {
    Q_OBJECT
public:
    /// @param holders holders whose segments can be copied @param materials that presets can be for
    ToolForm(std::vector<Holder> holders, std::vector<Property> materials, QWidget* parent = nullptr);
    /// Never emits. @param locked whether the values are read-only
    void showTool(const Tool& tool, bool locked);
    const Tool& tool() const noexcept { return record_; } ///< the tool with the values of the fields
    void setLengthUnit(LengthUnit unit);

private:
    void settle(const std::string& key) override;

    void addGeneral();
    void addFlutes();
    void addShank();
    void addHolder();
    void addLimits();
    void addPresets(std::vector<Property> materials);
    QStringList holderTexts() const;
    int holderOf(const Tool& tool) const;

    std::vector<Holder> holders_;
    SegmentTable* segments_ = nullptr;
    PresetTable* presets_ = nullptr;
};

} // namespace burin
