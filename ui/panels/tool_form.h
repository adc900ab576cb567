// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/holder_library.h"
#include "core/tool/tool.h"
#include "ui/panels/value_form.h"

namespace burin {

class SegmentTable;

/// Fields for every value of a tool: name, number, form and lengths of the flutes, shank, the segments of its holder,
/// and what it bears. What the type of the cutter gives or leaves out can't be entered.
class ToolForm final : public RecordForm<Tool> {
    Q_OBJECT
public:
    /// @param holders whose segments can be taken over
    explicit ToolForm(std::vector<Holder> holders, QWidget* parent = nullptr);
    /// Never emits. @param locked the values are shown and can't be changed
    void showTool(const Tool& tool, bool locked);
    const Tool& tool() const noexcept { return record_; } ///< as the fields say
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
