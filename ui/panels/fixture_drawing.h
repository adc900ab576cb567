// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_measures.h"
#include "ui/theme/length_unit.h"

#include <QPixmap>
#include <QWidget>

#include <optional>

namespace burin {

/// A fixture of the library, to scale, from the side and from above, with its measures by the letters that
/// `measureLetter` gives them. The measure that is being edited is marked and shown with its name and value.
class FixtureDrawing : public QWidget {
    Q_OBJECT
public:
    explicit FixtureDrawing(QWidget* parent = nullptr);
    /// @param design that has passed checkFixture; empty: nothing is drawn
    void setDesign(const std::optional<FixtureDesign>& design);
    void setUnit(LengthUnit unit);
    void mark(const std::optional<std::size_t>& parameter); ///< empty: none
    const std::optional<std::size_t>& marked() const noexcept { return marked_; }

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<FixtureDesign> design_;
    std::optional<std::size_t> marked_;
    LengthUnit unit_ = LengthUnit::millimetre;
};

/// "A", "B", … in the order of a kind's parameters.
QString measureLetter(std::size_t parameter);

/// A picture of a fixture with its standard sizes, from the side. @param ratio screen pixels per device-independent
/// pixel
QPixmap fixturePicture(FixtureKind kind, const QSize& size, double ratio);

} // namespace burin
