// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/edit_card.h"

#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/edit_field_editor.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/entry_labels.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/named_switch.h"
#include "ui/panels/omission_labels.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace burin {

EditCard::EditCard(std::size_t place, const Edit& edit, QWidget* parent) : QFrame(parent), edit_(edit) {
    setProperty("look", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 8, 8);
    column->setSpacing(4);
    const QString name = QStringLiteral("edit%1").arg(place);
    addHead(name);
    addFields(name);
    report_ = new ElidedLabel({}, this);
    report_->setObjectName(name + QStringLiteral("Report"));
    report_->setProperty("look", "small");
    report_->setFont(numberFont(report_->font()));
    worst_ = makeIconButton(QStringLiteral("eye"), tr("Show in the view where the error is the largest"),
                            name + QStringLiteral("Worst"), this);
    connect(worst_, &QToolButton::clicked, this, [this] { emit placeRequested(worstPlace_); });
    auto* line = new QHBoxLayout;
    line->setSpacing(0);
    line->addWidget(report_, 1);
    line->addWidget(worst_);
    column->addLayout(line);
    showEdit(edit, zero_, {});
    showReport(nullptr, LengthUnit::millimetre, zero_);
}

void EditCard::addHead(const QString& name) {
    switch_ = new NamedSwitch(name, tr("Switch this edit on or off"), this);
    connect(switch_, &NamedSwitch::switched, this, [this](bool on) {
        edit_.enabled = on;
        showEdit(edit_, zero_, std::vector(takes_));
        emit edited(edit_);
    });
    const QString title = Messages::text(titleOf(edit_.parameters));
    const auto button = [&](const char* icon, const QString& toolTip, const char* part) {
        QToolButton* made = makeIconButton(QLatin1String(icon), toolTip, name + QLatin1String(part), this);
        made->setAccessibleName(title + QStringLiteral(", ") + toolTip);
        return made;
    };
    earlier_ = button("previous", tr("Apply this edit earlier"), "Earlier");
    later_ = button("next", tr("Apply this edit later"), "Later");
    auto* remove = button("remove", tr("Delete this edit"), "Remove");
    connect(earlier_, &QToolButton::clicked, this, [this] { emit moveRequested(-1); });
    connect(later_, &QToolButton::clicked, this, [this] { emit moveRequested(1); });
    connect(remove, &QToolButton::clicked, this, &EditCard::removalRequested);
    auto* update = button("refresh", tr("Update this edit to its current version; its result changes"), "Update");
    update->setVisible(updated(edit_).has_value());
    connect(update, &QToolButton::clicked, this, [this] {
        if (const std::optional<Edit> newer = updated(edit_)) emit edited(*newer);
    });
    auto* head = new QHBoxLayout;
    head->setSpacing(0);
    head->addWidget(switch_, 1);
    for (QToolButton* each : {update, earlier_, later_, remove}) head->addWidget(each);
    static_cast<QVBoxLayout*>(layout())->addLayout(head);
}

void EditCard::addFields(const QString& name) {
    const QString title = Messages::text(titleOf(edit_.parameters));
    for (const EditParameter& parameter : parametersOf(edit_.parameters, zero_)) {
        const std::string_view key = parameter.field.key;
        // Look the key up by index: the key of a value may depend on another value.
        const auto keyNow = [this, place = fields_.size()] { return fieldsOf(edit_.parameters)[place].key; };
        auto* field = new EditFieldEditor(
            parameter, name + QLatin1Char('_') + QLatin1String(key.data(), static_cast<qsizetype>(key.size())),
            title + QStringLiteral(", ") + parameter.label, this);
        layout()->addWidget(field);
        connect(field, &EditFieldEditor::edited, this, [this, keyNow](const EditValue& value) {
            setField(edit_.parameters, keyNow(), value);
            emit edited(edit_);
        });
        connect(field, &EditFieldEditor::drawingRequested, this, [this, keyNow](bool wanted) {
            const std::string_view now = keyNow();
            emit drawingRequested(QLatin1String(now.data(), static_cast<qsizetype>(now.size())), wanted);
        });
        fields_.push_back(field);
    }
}

void EditCard::showEdit(const Edit& edit, const glm::dvec3& zero, const std::vector<TakeInfo>& takes) {
    edit_ = edit;
    zero_ = zero;
    takes_ = takes;
    switch_->show(Messages::text(titleOf(edit.parameters)), edit.enabled, {});
    const std::vector<EditParameter> parameters = parametersOf(edit.parameters, zero, takes_);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        fields_[i]->showParameter(parameters[i]);
        setEnabledKeepingFocus(fields_[i], edit.enabled);
    }
}

void EditCard::setDrawing(std::string_view key) {
    const std::vector<EditField> fields = fieldsOf(edit_.parameters);
    for (std::size_t i = 0; i < fields_.size(); ++i) fields_[i]->setDrawing(fields[i].key == key);
}

void EditCard::setMovable(bool earlier, bool later) {
    setEnabledKeepingFocus(earlier_, earlier);
    setEnabledKeepingFocus(later_, later);
}

void EditCard::showReport(const EditReport* report, LengthUnit unit, const glm::dvec3& zero) {
    QStringList lines;
    if (report != nullptr) lines = {omissionLines(*report, zero, unit), plungeLines(*report, zero, unit)};
    lines.removeAll(QString());
    report_->setToolTip(lines.join(QLatin1Char('\n')));
    const bool hasError = report != nullptr && report->largestDeviation > 0.0;
    setEnabledKeepingFocus(worst_, hasError);
    if (hasError) worstPlace_ = report->worstPlace;
    if (report == nullptr) return report_->setText(QString(QChar::Nbsp)); // as high as a report: nothing below moves
    QString text = tr("%1 → %2 points").arg(countText(report->pointsBefore), countText(report->pointsAfter));
    for (const QString& first : {entriesText(*report), omittedText(*report, unit)})
        if (!first.isEmpty()) text = first + QStringLiteral(" · ") + text; // first, because the end may be elided
    if (report->largestDeviation > 0.0)
        text += QStringLiteral(" · ") + tr("error %1").arg(lengthText(report->largestDeviation, unit));
    if (report_->text() != text) report_->setText(text);
}

void EditCard::setUnit(LengthUnit unit) {
    for (EditFieldEditor* field : fields_) field->setUnit(unit);
}

} // namespace burin
