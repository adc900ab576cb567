// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The tool library: a drawing of the selected tool to scale, its dimensions, feed and speed.
class ToolPanel : public QWidget {
    Q_OBJECT
public:
    explicit ToolPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const ToolState& state); ///< never emits

signals:
    void toolChosen(const std::string& id);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
