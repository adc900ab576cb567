// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/path_values.h"
#include "ui/workbench/path_controller.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// Computes a quantity along the path in force in the background, and again whenever that path changes.
class PathValuer final : public Controller {
    Q_OBJECT
public:
    PathValuer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path, QObject* parent);

    /// Empty: no quantity.
    void choose(std::optional<PathQuantity> quantity);
    std::optional<PathQuantity> chosen() const noexcept { return chosen_; }
    /// Of the path as last evaluated; null if none is chosen or computing is under way.
    std::shared_ptr<const PathValues> values() const;
    void forget(); ///< another project

private:
    struct Matter;
    void goOn();
    void run(Matter matter);

    const WorkpieceController& workpiece_;
    const PathController& path_;
    std::optional<PathQuantity> chosen_;
    /// Path that `values_` belong to; path they are being computed for
    std::shared_ptr<const EvaluatedPath> of_, asked_;
    std::shared_ptr<const PathValues> values_;
    quint64 questions_ = 0;
};

} // namespace burin
