// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/quantity.h"

#include <QDoubleSpinBox>

namespace burin {

/// A field for one number with a unit. `value()` is in the internal unit (mm, mm/s, s, Hz); it is displayed in the
/// display unit, followed by that unit, and parsed by `readQuantity`. Values out of range are rejected: the value
/// remains unchanged, and a message below the field states the range. Steps are a tenth of the number's magnitude. The
/// wheel changes the value only when the field has the focus. Escape discards typed text.
class QuantityField : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit QuantityField(Quantity quantity, QWidget* parent = nullptr);

    void setLengthUnit(LengthUnit unit);
    void setQuantity(Quantity quantity);
    /// Sets the permitted range, in the internal unit; emits no signal.
    void limit(double low, double high);
    /// Shows a value without emitting a signal. While the user types, the text is kept; the entry is then compared with
    /// this value.
    void showValue(double value);
    Quantity quantity() const noexcept { return quantity_; }

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
    void stepBy(int steps) override;

signals:
    /// The user committed another value (Enter, Tab, a click elsewhere) or stepped; in the internal unit.
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
    double shown_ = 0.0;                    ///< the value that was last shown or reported
    mutable std::optional<double> refused_; ///< out of range, typed and not reported yet; `fixup` is const
};

} // namespace burin
