// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>

#include <chrono>
#include <functional>
#include <utility>

namespace burin {

/// Sets one value, as an entry of the undo stack. Consecutive entries of the same kind are merged if they follow each
/// other quickly, so that raising a field by ten steps is one undo, and a later input another.
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
        const auto* later = static_cast<const ValueCommand*>(next); // same id, same type
        if (later->made_ - made_ > mergedWithin) return false;
        after_ = later->after_;
        made_ = later->made_;
        return true;
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds mergedWithin{1000};

    int kind_;
    T before_, after_;
    std::function<void(const T&)> apply_;
    Clock::time_point made_ = Clock::now();
};

/// Kinds of values, for merging.
enum ValueKind : int {
    allowanceValue = 1,
    voxelValue,
    marginValue,
    stockShapeValue,
    guideValue, ///< plus the index of each guide
    axisValue = 500,
    obstacleValue = 1000, ///< plus the index of each obstacle
    handValue = 2000      ///< plus the number of each device
};

} // namespace burin
