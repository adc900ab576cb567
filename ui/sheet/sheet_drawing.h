// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/picture.h"
#include "ui/sheet/setup_sheet.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Draws the pictures of a setup sheet between the events of the user interface, and makes the page of them.
class SheetDrawing final : public QObject {
    Q_OBJECT
public:
    SheetDrawing(std::shared_ptr<const SheetContent> content, LengthUnit unit, QObject* parent);

signals:
    /// Once: the page, or what its pictures lack.
    void drawn(const burin::Result<std::string>& page);

private:
    void goOn();

    std::shared_ptr<const SheetContent> content_;
    LengthUnit unit_;
    std::vector<std::string> pictures_; ///< PNG, those that are drawn
    std::optional<PictureDrawing> drawing_;
    QTimer turn_;
};

} // namespace burin
