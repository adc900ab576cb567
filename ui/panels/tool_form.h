// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/holder_library.h"
#include "core/tool/tool.h"
#include "ui/panels/value_form.h"

namespace burin {

class SegmentTable;

/// Fields for every value of a tool: name, number, form and lengths of the flutes, shank, the segments of its holder,
/// and its load limits. Values that the cutter type determines or doesn't have can't be entered.
class ToolForm final : public RecordForm<Tool> {
    Q_OBJECT
public:
    /// @param holders holders whose segments can be copied
    explicit ToolForm(std::vector<Holder> holders, QWidget* parent = nullptr);
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
    QStringList holderTexts() const;
    int holderOf(const Tool& tool) const;

    std::vector<Holder> holders_;
    SegmentTable* segments_ = nullptr;
};

} // namespace burin
