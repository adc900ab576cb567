// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/meters.h"
#include "ui/panels/mill_panel.h"
#include "ui/window/mill_mode.h"
#include "ui/window/presenter.h"

#include <QElapsedTimer>

namespace burin {

/// The mill panel.
class MillPresenter final : public Presenter {
    Q_OBJECT
public:
    MillPresenter(Workbench& workbench, MillMode& mode, MillPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// Raster, repetitions, and the demonstration by the virtual operator.
    void connectActions(const Actions& actions);

signals:
    void takeRemovalRequested(qint64 take);

private:
    void present() override;
    void edit(void (*change)(MillToolSettings&, double), double value);
    void setRaster(bool on);
    QString lockText() const;
    QString missing() const;
    QString hint();
    MillMode& mode_;
    MillPanel& panel_;
    const Actions* actions_ = nullptr;
    QString hint_; ///< shown at present
    QElapsedTimer hintSince_;
};

/// Force, removal, rate: during a session.
class MeterPresenter final : public Presenter {
    Q_OBJECT
public:
    MeterPresenter(Workbench& workbench, Meters& meters, QObject* parent);
    void setUnit(LengthUnit unit) override;
    const MeterState& state() const noexcept { return state_; }

signals:
    void presented();

private:
    void present() override;
    void tick();
    void takeForceLimit();
    void takeProposedFeed();
    Meters& meters_;
    MeterState state_;
};

} // namespace burin
