// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/quantity_field.h"

#include "ui/theme/number_font.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

// Far more than is displayed: changing the display unit must not change the value.
constexpr int innerDecimals = 9;
constexpr double largest = 1e6;

/// Leaves the undo and redo keys to the window while nothing is being typed: a line edit would consume them and do
/// nothing.
class UndoKeysOfWindow final : public QObject {
public:
    UndoKeysOfWindow(QObject* parent, QLineEdit* text) : QObject(parent), text_(text) {}
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride || text_->isModified()) return false;
        const auto* key = static_cast<QKeyEvent*>(event);
        if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
        event->ignore();
        return true;
    }

private:
    QLineEdit* text_;
};

/// Shows a message below a field for a while, over other widgets. A tooltip would disappear with the next click, which
/// may be the click that left the field.
void showUnder(QWidget* field, const QString& sentence) {
    constexpr int width = 260, stays = 6000; // px, ms
    QWidget* window = field->window();
    delete window->findChild<QLabel*>(QStringLiteral("fieldMessage"));
    auto* message = new QLabel(sentence, window);
    message->setObjectName(QStringLiteral("fieldMessage"));
    message->setWordWrap(true);
    message->setProperty("look", "message");
    message->setAutoFillBackground(true);
    message->setAttribute(Qt::WA_TransparentForMouseEvents);
    message->setFixedWidth(std::min(width, window->width()));
    message->adjustSize();
    const QPoint under = field->mapTo(window, field->rect().bottomLeft());
    message->move(std::clamp(under.x(), 0, std::max(0, window->width() - message->width())),
                  std::clamp(under.y() + 2, 0, std::max(0, window->height() - message->height())));
    message->show();
    message->raise();
    QTimer::singleShot(stays, message, &QObject::deleteLater);
}

/// A tenth of the magnitude of `shown`, as a power of ten, but at least the last displayed digit.
double stepOf(double shown, int decimals) {
    const double smallest = std::pow(10.0, -decimals);
    const double size = std::abs(shown);
    if (size < smallest) return smallest;
    return std::max(smallest, std::pow(10.0, std::floor(std::log10(size) + 1e-9) - 1.0));
}

} // namespace

QuantityField::QuantityField(Quantity quantity, QWidget* parent) : QDoubleSpinBox(parent), quantity_(quantity) {
    setDecimals(innerDecimals);
    limit(0.0, largest);
    setKeyboardTracking(false);
    setButtonSymbols(QAbstractSpinBox::NoButtons);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setFocusPolicy(Qt::StrongFocus);
    setFont(numberFont(font()));
    setLengthUnit(unit_);
    installEventFilter(new UndoKeysOfWindow(this, lineEdit()));
    connect(this, &QAbstractSpinBox::editingFinished, this, &QuantityField::commit);
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] { refused_.reset(); });
}

void QuantityField::setLengthUnit(LengthUnit unit) {
    const QSignalBlocker quiet(this);
    if (isTyping()) restore();
    unit_ = unit;
    const QString text = displayUnit(quantity_, unit).text;
    setSuffix(text.isEmpty() ? QString() : QChar(QChar::Nbsp) + text);
}

void QuantityField::setQuantity(Quantity quantity) {
    if (quantity == quantity_) return;
    quantity_ = quantity;
    setLengthUnit(unit_);
}

void QuantityField::limit(double low, double high) {
    if (low == minimum() && high == maximum()) return;
    const QSignalBlocker quiet(this);
    setRange(low, high);
    if (!isTyping()) shown_ = value(); // a change caused by the limits is not a change by the user
}

void QuantityField::showValue(double value) {
    shown_ = value;
    if (isTyping()) return;
    const QSignalBlocker quiet(this);
    setValue(value);
    shown_ = this->value();
}

QString QuantityField::textFromValue(double value) const {
    return quantityNumber(value, quantity_, unit_, locale());
}

std::optional<double> QuantityField::read(const QString& text) const {
    QString bare = text;
    if (!suffix().isEmpty() && bare.endsWith(suffix())) bare.chop(suffix().size());
    return readQuantity(bare, quantity_, unit_);
}

/// std::nullopt if the value is out of range. A limit of the range that is typed as it is displayed, rounded, counts as
/// that limit.
std::optional<double> QuantityField::withinRange(double typed) const {
    const DisplayUnit unit = displayUnit(quantity_, unit_);
    const double rounding = 0.5 * unit.size * std::pow(10.0, -unit.decimals);
    if (typed < minimum() - rounding || typed > maximum() + rounding) return std::nullopt;
    return std::clamp(typed, minimum(), maximum());
}

double QuantityField::valueFromText(const QString& text) const {
    // The displayed value is rounded: reading it back must not change the value.
    if (text == textFromValue(value()) + suffix() || text == textFromValue(value())) return value();
    return withinRange(read(text).value_or(value())).value_or(value());
}

QValidator::State QuantityField::validate(QString& text, int&) const {
    const std::optional<double> typed = read(text);
    if (!typed) {
        const bool possible = std::ranges::all_of(text, [](QChar c) {
            return c.isDigit() || c.isLetter() || c.isSpace() || QStringLiteral(".,+-−/\"″°×·²³").contains(c);
        });
        return possible ? QValidator::Intermediate : QValidator::Invalid;
    }
    return withinRange(*typed) ? QValidator::Acceptable : QValidator::Intermediate;
}

void QuantityField::fixup(QString& text) const {
    const std::optional<double> typed = read(text);
    const std::optional<double> possible = typed ? withinRange(*typed) : value();
    if (!possible) refused_ = typed;
    text = textFromValue(possible.value_or(value())) + suffix();
}

void QuantityField::stepBy(int steps) {
    interpretText();
    const DisplayUnit unit = displayUnit(quantity_, unit_);
    const double shown = value() / unit.size;
    // Stepping down from 1 uses the step for values below 1.
    const double step = stepOf(steps < 0 ? shown * (1.0 - 1e-6) : shown, unit.decimals);
    const double before = value();
    {
        const QSignalBlocker quiet(this);
        setValue((std::round(shown / step) + steps) * step * unit.size);
    }
    selectAll();
    if (value() != before || value() != shown_) commit();
}

QAbstractSpinBox::StepEnabled QuantityField::stepEnabled() const {
    if (isReadOnly()) return StepNone;
    StepEnabled enabled = StepNone;
    if (value() < maximum()) enabled |= StepUpEnabled;
    if (value() > minimum()) enabled |= StepDownEnabled;
    return enabled;
}

/// Esc first discards typed text, before the window handles it.
bool QuantityField::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isTyping() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QDoubleSpinBox::event(event);
}

void QuantityField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && isTyping()) {
        restore();
        selectAll();
        event->accept();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
}

void QuantityField::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore(); // scrolling the panel must not change a number
}

bool QuantityField::isTyping() const {
    return hasFocus() && lineEdit()->isModified();
}

void QuantityField::commit() {
    lineEdit()->setModified(false);
    if (refused_) sayRange();
    if (value() == shown_) return;
    shown_ = value();
    emit valueEdited(shown_);
}

void QuantityField::sayRange() {
    const auto text = [this](double number) { return quantityText(number, quantity_, unit_, locale()); };
    showUnder(this, tr("%1 is out of range (%2 to %3). The value stays at %4.")
                        .arg(text(*refused_), text(minimum()), text(maximum()), text(value())));
    refused_.reset();
}

void QuantityField::restore() {
    const QSignalBlocker quiet(this);
    refused_.reset();
    lineEdit()->setModified(false);
    setValue(shown_);
}

} // namespace burin
