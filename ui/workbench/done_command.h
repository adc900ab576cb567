// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>

#include <functional>
#include <utility>

namespace burin {

/// An action that was done before it became an entry of the undo stack, such as a milled stroke: undo reverts it, redo
/// restores it.
class DoneCommand final : public QUndoCommand {
public:
    /// @param takeBack called with true for undo, false for redo
    DoneCommand(const QString& title, std::function<void(bool)> takeBack)
        : QUndoCommand(title), takeBack_(std::move(takeBack)) {}

    void redo() override {
        if (std::exchange(done_, true)) takeBack_(false); // the first call: already done
    }
    void undo() override { takeBack_(true); }

private:
    std::function<void(bool)> takeBack_;
    bool done_ = false;
};

} // namespace burin
