// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"
#include "ui/window/library_dialog.h"
#include "ui/workbench/tool_controller.h"

namespace burin {

class ToolDrawing;
class ToolForm;
class ToolLibraryBar;

/// The tools shipped with Burin and the user's own, by libraries: to view, with a drawing to scale, copy, change,
/// delete, put into another library, add from a file, export and load into the spindle. Each step is an entry of the
/// undo stack. `tools` outlives the dialog.
class ToolDialog final : public LibraryDialog {
    Q_OBJECT
public:
    ToolDialog(ToolController& tools, LengthUnit unit, QWidget* parent);

private:
    std::vector<Entry> entries() const override;
    bool listed(const Entry& entry) const override;
    void fill(const std::string& id, bool shipped) override;
    bool edited() const override;
    QString problem() const override;
    QString about(bool shipped) const override;
    std::string copy(const std::string& id) override;
    void erase(const std::string& id) override;
    Result<void> keep() override;
    QString askFile() override;
    Result<Incoming> read(const std::string& file) override;
    void followFoot() override;

    void addButtons();
    void exportTools();
    std::vector<Tool> listedTools() const;
    void showLibrary();
    void offerLibraries();
    void moveTo(std::string library);
    void copyTo(std::string library);
    QWidget* makePage();
    const Tool* tool(const std::string& id) const;

    ToolController& tools_;
    LengthUnit unit_;
    ToolLibraryBar* bar_ = nullptr;
    ToolForm* form_ = nullptr;
    ToolDrawing* drawing_ = nullptr;
    QPushButton *use_ = nullptr, *place_ = nullptr;
};

} // namespace burin
