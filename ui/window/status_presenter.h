// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/window/mill_presenter.h"
#include "ui/window/status_line.h"

#include <QTimer>

namespace burin {

/// The status line.
class StatusPresenter final : public Presenter {
    Q_OBJECT
public:
    StatusPresenter(Workbench& workbench, const MeterPresenter& meters, const MillMode& mill, const Viewport& viewport,
                    StatusLine& line, QObject* parent);

private:
    void present() override;
    void presentStroke();
    void presentSession();
    void presentTask();
    QString savedText() const;
    QString healthText() const;

    const MeterPresenter& meters_;
    const Viewport& viewport_;
    StatusLine& line_;
    QTimer minute_;
};

} // namespace burin
