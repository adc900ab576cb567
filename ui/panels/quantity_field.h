// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/quantity.h"

#include <QDoubleSpinBox>

namespace burin {

/// A field for one measured number. `value()` is in the inner unit (mm, mm/s, s, Hz); it is shown in the display unit
/// with that unit behind it, and read as `readQuantity` does. What is out of range is refused: the value stays, and a
/// message under the field says the range. Steps are a tenth of the number's own size. The wheel turns it only when it
/// has the focus. Escape takes typing back.
class QuantityField : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit QuantityField(Quantity quantity, QWidget* parent = nullptr);

    void setLengthUnit(LengthUnit unit);
    void setQuantity(Quantity quantity);
    /// What may be entered, in the inner unit, without a signal.
    void limit(double low, double high);
    /// Shows a value without a signal. While the user types, the text stays; their entry then counts against this
    /// value.
    void showValue(double value);
    Quantity quantity() const noexcept { return quantity_; }

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
    void stepBy(int steps) override;

signals:
    /// The user committed another value (Enter, Tab, a click elsewhere) or stepped; in the inner unit.
    void valueEdited(double value);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    StepEnabled stepEnabled() const override;

private:
    bool isTyping() const;
    void commit();
    void restore();
    void sayRange();
    std::optional<double> read(const QString& text) const;
    std::optional<double> withinRange(double typed) const;

    Quantity quantity_;
    LengthUnit unit_ = LengthUnit::millimetre;
    double shown_ = 0.0;                    ///< what was last shown or told
    mutable std::optional<double> refused_; ///< out of range, typed and not reported yet; `fixup` is const
};

} // namespace burin
