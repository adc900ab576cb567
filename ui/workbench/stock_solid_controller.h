// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_fit.h"
#include "core/setup/obstacle.h"
#include "core/setup/stock_solid.h"
#include "ui/workbench/setup_controller.h"

#include <map>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

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
    /// How a fixture fits the stock. Kept until the stock changes; empty while it is being judged in the background,
    /// whose end emits `changed`.
    std::optional<FixtureFit> fitOf(const std::shared_ptr<const Obstacle>& fixture);
    /// Asks the newest stock: at once if it answers quickly (StockSolid::isQuick), otherwise in the background, where a
    /// later question of the same kind replaces this one. `done` is not called if it is replaced or cancelled.
    /// @param work a value, of a const StockSolid& @param done gets the value
    /// @return whether it was answered at once
    template <class Work, class Done>
    bool ask(TaskKind kind, Work work, Done done) {
        const StockSolid& solid = stock();
        if (solid.isQuick()) {
            if (desk_.tasks.running(kind)) desk_.tasks.abandon(kind);
            done(work(solid));
            return true;
        }
        using Answer = std::invoke_result_t<Work&, const StockSolid&>;
        desk_.tasks.start(
            kind, tr("Fitting the fixture to the stock"),
            [solid, work](Progress&) -> Result<Answer> { return work(solid); },
            [done](Result<Answer> answer) {
                if (answer) done(*std::move(answer));
            });
        return false;
    }
    /// While something waits for the tasks to end, nothing is prepared; what is under way is begun again when asked
    /// for afterwards.
    void pause();
    void goOn();

private:
    void follow();
    void prepare();
    void forgetFits();

    SetupController& setup_;
    std::shared_ptr<const Model> part_; ///< the input of `stock_`
    Setup of_;
    StockSolid stock_;
    bool asked_ = false; ///< whether `stock_` is in its real form, or being prepared
    std::map<std::shared_ptr<const Obstacle>, FixtureFit> fits_;
    int pauses_ = 0;
};

} // namespace burin
