// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/path_values.h"
#include "ui/workbench/path_controller.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// Works out a quantity along the path in force, in the background, and anew whenever that path is another.
class PathValuer final : public Controller {
    Q_OBJECT
public:
    PathValuer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path, QObject* parent);

    /// Nothing: none is wanted.
    void choose(std::optional<PathQuantity> quantity);
    std::optional<PathQuantity> chosen() const noexcept { return chosen_; }
    /// Of the path as it was evaluated last; null: none is wanted, or they are being worked out.
    std::shared_ptr<const PathValues> values() const;
    void forget(); ///< another project

private:
    struct Matter;
    void goOn();
    void run(Matter matter);

    const WorkpieceController& workpiece_;
    const PathController& path_;
    std::optional<PathQuantity> chosen_;
    std::shared_ptr<const EvaluatedPath> of_, asked_; ///< what the values are of; what they are being made of
    std::shared_ptr<const PathValues> values_;
    quint64 questions_ = 0;
};

} // namespace burin
