// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/comparison_dialog.h"

#include "core/path/path_comparison.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/notice.h"
#include "ui/panels/quantity_field.h"
#include "ui/theme/number_font.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace burin {

namespace {

constexpr int comparisonWidth = 600; // pixels
const QString noValue(QStringLiteral("–"));

QLabel* headOf(const QString& text, QWidget* parent) {
    auto* head = new QLabel(text, parent);
    head->setProperty("look", "section");
    head->setAlignment(Qt::AlignRight);
    return head;
}

} // namespace

ComparisonDialog::ComparisonDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("comparisonDialog"));
    setWindowTitle(tr("Compare paths"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(8);
    version_ = new ChoiceBox(this);
    version_->setObjectName(QStringLiteral("comparedVersion"));
    column->addWidget(new FieldRow(tr("Compare with"), version_,
                                   tr("This path in another version, or another path of the setup"), this,
                                   FieldRow::wholeWidth));
    tolerance_ = new QuantityField(Quantity::length, this);
    tolerance_->setObjectName(QStringLiteral("comparedTolerance"));
    tolerance_->limit(comparedTolerances.low, comparedTolerances.high);
    column->addWidget(
        new FieldRow(tr("Tolerance"), tolerance_, tr("Cuts farther apart than this are marked red in the view"), this));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(0, 1);
    grid->addWidget(headOf(tr("This path"), this), 0, 1);
    grid->addWidget(headOf(tr("Other"), this), 0, 2);
    grid->addWidget(headOf(tr("Difference"), this), 0, 3);
    addRow(*grid, tr("Cuts"), "Cutting", &ComparisonState::cutting);
    addRow(*grid, tr("Plunges"), "Plunging", &ComparisonState::plunging);
    addRow(*grid, tr("Rapids and retracts"), "Air", &ComparisonState::air);
    addRow(*grid, tr("Points"), "Points", &ComparisonState::points);
    addRow(*grid, tr("Arcs"), "Arcs", &ComparisonState::arcs);
    addRow(*grid, tr("Time at feed"), "Time", &ComparisonState::time);
    addLargest(*grid);
    addRow(*grid, tr("Mean deviation"), "Mean", &ComparisonState::mean);
    addRow(*grid, tr("Farther than the tolerance"), "Farther", &ComparisonState::farther);
    column->addLayout(grid);
    auto* about = new QLabel(tr("The other path is drawn thin, in turquoise. Deviations are those of the cuts of "
                                "either path from the cuts of the other."),
                             this);
    about->setProperty("look", "small");
    about->setWordWrap(true);
    column->addWidget(about);
    auto* notices = new NoticePlace(this);
    notice_ = notices->add("comparisonNotice");
    column->addWidget(notices);
    QDialogButtonBox* close = makeCloseRow(*this);
    close->button(QDialogButtonBox::Close)->setAutoDefault(false); // Enter is the tolerance's
    column->addWidget(close);
    setMinimumWidth(comparisonWidth);
    connect(version_, &QComboBox::activated, this, &ComparisonDialog::versionChosen);
    connect(tolerance_, &QuantityField::valueEdited, this, &ComparisonDialog::toleranceEdited);
}

void ComparisonDialog::addRow(QGridLayout& grid, const QString& title, const char* name, Member value) {
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(title, this), row, 0);
    Row added{value, {}};
    constexpr const char* columns[] = {"First", "Second", "Difference"};
    const std::array heads{tr("This path"), tr("Other"), tr("Difference")};
    for (std::size_t i = 0; i < added.cells.size(); ++i) {
        auto* cell = new QLabel(noValue, this);
        cell->setObjectName(QStringLiteral("compared%1%2").arg(QLatin1String(name), QLatin1String(columns[i])));
        cell->setFont(numberFont(cell->font()));
        cell->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        cell->setAccessibleName(QStringLiteral("%1, %2").arg(title, heads[i]));
        cell->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        grid.addWidget(cell, row, static_cast<int>(i) + 1);
        added.cells[i] = cell;
    }
    rows_.push_back(added);
}

/// The values are buttons that move the view to the deviation.
void ComparisonDialog::addLargest(QGridLayout& grid) {
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(tr("Largest deviation"), this), row, 0);
    for (const bool second : {false, true}) {
        auto* button = makeButton(noValue, QStringLiteral("eye"),
                                  second ? QStringLiteral("largestSecond") : QStringLiteral("largestFirst"), this);
        button->setFont(numberFont(button->font()));
        button->setAccessibleName(second ? tr("Largest deviation of the other path")
                                         : tr("Largest deviation of this path"));
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, second] { emit largestRequested(second); });
        grid.addWidget(button, row, second ? 2 : 1, Qt::AlignRight);
        largest_[second ? 1 : 0] = button;
    }
}

void ComparisonDialog::setState(const ComparisonState& state) {
    QStringList ids;
    for (int i = 0; i < state.versions.size(); ++i) ids << QString::number(i);
    version_->offer(state.versions, ids, QString::number(state.version));
    tolerance_->setLengthUnit(state.unit);
    tolerance_->showValue(state.tolerance);
    for (const Row& row : rows_) {
        const ComparedValue& value = state.*row.value;
        const std::array texts{&value.first, &value.second, &value.difference};
        for (std::size_t i = 0; i < texts.size(); ++i) {
            row.cells[i]->setText(state.known && !texts[i]->isEmpty() ? *texts[i] : noValue);
            row.cells[i]->setAccessibleDescription(row.cells[i]->text()); // the name hides it from a screen reader
        }
    }
    for (std::size_t i = 0; i < largest_.size(); ++i) {
        largest_[i]->setText(state.known && state.deviates ? (i == 0 ? state.largest.first : state.largest.second)
                                                           : noValue);
        largest_[i]->setAccessibleDescription(largest_[i]->text());
        enableUnless(largest_[i], state.known && state.deviates ? QString() : tr("There is no deviation to show"),
                     tr("Show the point in the view"));
    }
    notice_->tell(state.problem ? Notice::Kind::error : Notice::Kind::information, state.news);
}

} // namespace burin
