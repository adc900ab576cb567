// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_placement.h"
#include "ui/workbench/stock_solid_controller.h"
#include "ui/workbench/surroundings_controller.h"

#include <memory>
#include <optional>
#include <set>
#include <string>

namespace burin {

/// A fixture of the library that the user is placing: a new one, or one of the setup's that is being changed. Nothing
/// of it is in the project until it is accepted, as one entry of the undo stack.
class FixtureController final : public Controller {
    Q_OBJECT
public:
    FixtureController(const Desk& desk, WorkpieceController& workpiece, StockSolidController& stock,
                      SurroundingsController& surroundings, QObject* parent);

    bool possible() const; ///< whether there is a part and no recording is running
    bool placing() const noexcept { return design_.has_value(); }
    const FixtureDesign& design() const { return *design_; } ///< only while placing
    /// Index of the fixture that is being changed; empty: a new one.
    std::optional<std::size_t> instead() const noexcept { return instead_; }
    /// The solid as it would be added, null if its sizes can't be used; `problem` is why it can't be accepted, once it
    /// is judged. A large stock is asked in the background.
    const std::shared_ptr<const Obstacle>& preview() const noexcept { return preview_; }
    const std::optional<Error>& problem() const noexcept { return problem_; }
    /// The gap between the fixture and the stock, mm, as gapTo (core/setup/fixture_fit.h); 0: it touches, or need not.
    double gap() const noexcept { return gap_; }
    bool judged() const noexcept { return judged_; }
    FixtureSite site() const;

    void begin(); ///< with the kind used last
    void beginChange(std::size_t place);
    void cancel(); ///< does nothing unless placing
    void accept(); ///< as soon as it is judged; does nothing while there is a problem

    // While placing:
    void chooseKind(FixtureKind kind);
    void placeAt(const glm::dvec3& point); ///< as by a click, mm, setup frame
    void setValue(std::size_t parameter, double value);
    void setPlace(const glm::dvec3& place);
    void moveBy(const glm::dvec3& shift) { setPlace(design_->place + shift); }
    void setTurn(double turn); ///< rad, brought to -pi … pi
    void turnBy(double angle) { setTurn(design_->turn + angle); }

private:
    std::string name() const;
    double margin() const;
    void follow();
    void refresh();
    void judge();
    void take(const FixtureFit& fit);
    std::vector<Obstacle> others() const;

    WorkpieceController& workpiece_;
    StockSolidController& stock_;
    SurroundingsController& surroundings_;
    FixtureKind last_ = FixtureKind::vise;
    std::optional<FixtureDesign> design_;
    std::set<std::string> given_; ///< sizes entered by the user, which no longer follow the stock
    std::optional<std::size_t> instead_;
    std::shared_ptr<const Obstacle> changed_; ///< the fixture at `instead_`
    std::shared_ptr<const Obstacle> preview_;
    std::optional<Error> problem_;
    double gap_ = 0.0;
    bool judged_ = false, acceptsOnceJudged_ = false;
    std::optional<glm::dvec3> nextPoint_; ///< of a click while the one before is still being answered
};

} // namespace burin
