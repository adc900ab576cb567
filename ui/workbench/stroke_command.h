// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>

#include <functional>
#include <utility>

namespace burin {

/// A stroke that was milled, as an entry of the undo stack: undo takes it back, redo puts it back.
class StrokeCommand final : public QUndoCommand {
public:
    /// @param takeBack called with true for undo, false for redo
    StrokeCommand(const QString& title, std::function<void(bool)> takeBack)
        : QUndoCommand(title), takeBack_(std::move(takeBack)) {}

    void redo() override {
        if (std::exchange(milled_, true)) takeBack_(false); // the first time the hand did it
    }
    void undo() override { takeBack_(true); }

private:
    std::function<void(bool)> takeBack_;
    bool milled_ = false;
};

} // namespace burin
