// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/tool_controller.h"

#include <QWidget>

#include <string>

class QToolButton;

namespace burin {

class ChoiceBox;

/// Returns the name of a library as users read it.
QString toolLibraryName(const std::string& library);

/// Chooses the tool library that is shown: all tools, those shipped, or one of the user's own libraries, which can be
/// added, renamed and deleted here. `tools` outlives the bar.
class ToolLibraryBar final : public QWidget {
    Q_OBJECT
public:
    ToolLibraryBar(ToolController& tools, QWidget* parent);

    const std::string& library() const noexcept { return library_; } ///< allTools, starterLibrary, ownLibrary or a name
    /// Returns the library that new tools are put into: the shown one, if own tools can be in it.
    std::string ownTarget() const;
    void choose(const std::string& library); ///< emits chosen
    /// Asks for a name and adds a library. Empty: none was added.
    std::string addLibrary();

signals:
    void chosen();                          ///< another library
    void failed(const burin::Error& error); ///< of a name

private:
    QToolButton* addButton(const char* icon, const char* name, const QString& text, const QKeySequence& key);
    void follow();
    void renameLibrary();
    void deleteLibrary();

    ToolController& tools_;
    std::string library_;
    ChoiceBox* box_;
    QToolButton *rename_ = nullptr, *delete_ = nullptr;
};

} // namespace burin
