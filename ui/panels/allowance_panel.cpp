// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/allowance_panel.h"

#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/length_field.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"

namespace burin {

class AllowancePanel::Fields : public QObject {
public:
    explicit Fields(AllowancePanel* panel);
    LengthField* allowance;
    QLabel* meaning;
    Notice* locked;
};

AllowancePanel::Fields::Fields(AllowancePanel* panel) : QObject(panel) {
    QVBoxLayout* column = makePanelLayout(panel);
    column->addWidget(makeSectionTitle(AllowancePanel::tr("Allowance"), panel));
    allowance = new LengthField(panel);
    allowance->setObjectName(QStringLiteral("allowanceField"));
    column->addWidget(new FieldRow(AllowancePanel::tr("Stock to leave"), allowance,
                                   AllowancePanel::tr("Distance of the boundary from the part"), panel));
    locked = new Notice(panel);
    column->addWidget(locked);
    meaning = makeWrappedLabel(panel);
    meaning->setProperty("look", "quiet");
    setWrappedText(meaning, AllowancePanel::tr("Smallest distance between the tool and the part. Leave some stock "
                                               "while roughing; with 0 the cutter may touch the part and finish it."));
    column->addWidget(meaning);
    column->addStretch(1);
    connect(allowance, &LengthField::valueEdited, panel, &AllowancePanel::allowanceEdited);
}

AllowancePanel::AllowancePanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("allowancePanel"));
    setState({});
}

void AllowancePanel::setUnit(LengthUnit unit) {
    fields_->allowance->setLengthUnit(unit);
}

void AllowancePanel::setState(const AllowanceState& state) {
    fields_->allowance->limit(0.0, state.maximum);
    fields_->allowance->showValue(state.allowance);
    setEnabledKeepingFocus(fields_->allowance, !state.locked);
    fields_->locked->tell(Notice::Kind::information,
                          state.locked ? AllowancePanel::tr("The allowance can't be changed while recording.")
                                       : QString());
}

} // namespace burin
