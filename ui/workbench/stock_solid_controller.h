// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/obstacle.h"
#include "core/setup/stock_solid.h"
#include "ui/workbench/setup_controller.h"

#include <map>
#include <memory>
#include <optional>

namespace burin {

/// The stock of the setup in its real form, by which fixtures are placed and judged. A stock of solids or from a file
/// is prepared in the background when it is first asked for; until then, and if that fails or is cancelled, its box
/// counts.
class StockSolidController final : public Controller {
    Q_OBJECT
public:
    StockSolidController(const Desk& desk, SetupController& setup, QObject* parent);

    const StockSolid& stock(); ///< the newest; starts preparing it
    bool preparing() const { return desk_.tasks.running(TaskKind::stockSolid); }
    /// How deep a fixture of the library is in the stock, mm, as depthIn; 0 for any other. Kept until the stock
    /// changes.
    double depthOf(const std::shared_ptr<const Obstacle>& fixture);

private:
    void follow();
    void prepare();

    SetupController& setup_;
    std::shared_ptr<const Model> part_; ///< the input of `stock_`
    Setup of_;
    StockSolid stock_;
    bool asked_ = false; ///< whether `stock_` is in its real form, or being prepared
    std::map<std::shared_ptr<const Obstacle>, double> depths_;
};

} // namespace burin
