// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>

#include <functional>
#include <utility>

namespace burin {

/// Setting one value, as an entry of the undo stack. Entries of the same kind that follow each other become one, so
/// that turning a field up by ten steps is one undo.
template <class T>
class ValueCommand final : public QUndoCommand {
public:
    /// @param kind of value, for merging; -1: never merged. @param apply sets the value
    ValueCommand(const QString& title, int kind, T before, T after, std::function<void(const T&)> apply)
        : QUndoCommand(title)
        , kind_(kind)
        , before_(std::move(before))
        , after_(std::move(after))
        , apply_(std::move(apply)) {}

    int id() const override { return kind_; }
    void redo() override { apply_(after_); }
    void undo() override { apply_(before_); }
    bool mergeWith(const QUndoCommand* next) override {
        after_ = static_cast<const ValueCommand*>(next)->after_; // one id, one type
        return true;
    }

private:
    int kind_;
    T before_, after_;
    std::function<void(const T&)> apply_;
};

/// Kinds of values, for merging.
enum ValueKind : int {
    allowanceValue = 1,
    voxelValue,
    marginValue,
    pathEditValue,
    guideValue, ///< and, with its place, of each guide
    axisValue = 500,
    obstacleValue = 1000, ///< and, with its place, of each obstacle
    handValue = 2000      ///< and, with its number, of each device
};

} // namespace burin
