// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/plan_drawing.h"
#include "core/recording/sample.h"
#include "ui/window/pass_form.h"
#include "ui/workbench/pass_controller.h"

#include <QDialog>
#include <QTimer>

#include <optional>
#include <vector>

class QCheckBox;
class QLabel;

namespace burin {

class ChoiceBox;
class FieldRow;
class Notice;

/// Asks what a pass is to do: its kind and figures (PassForm), the drawing of its area and what leads it. Dialog
/// "passDialog" with "passArea", "passLines", "passUnit", "computePassButton", "cancelPassButton".
class PassDialog final : public QDialog {
    Q_OBJECT
public:
    /// What it begins with, and what it may choose from.
    struct Offer {
        QString toolName;
        std::vector<TakeInfo> takes; ///< whose strokes may lead
        WantedPass last;             ///< what was asked for before
        PassDefaults defaults;
        PlanRegion painted;  ///< empty: nothing is
        QString folder;      ///< of drawings
        bool drills = false; ///< the tool is a drill
        QString holes{};     ///< of the part, by their diameters; empty: it has none
        LengthUnit unit = LengthUnit::millimetre;
    };
    PassDialog(const Offer& offer, QWidget* parent);

    const WantedPass& wanted() const noexcept { return wanted_; } ///< after it was accepted

    /// What the pass would come to: "passPreview". @param empty there is nothing to say
    void showPreview(const QString& text);

signals:
    /// What the pass would be as the dialog stands, a moment after it changed.
    void previewWanted(const burin::WantedPass& wanted);
    void previewUnwanted(); ///< it lacks something as the dialog stands

private:
    void layOut(const Offer& offer);
    void addDrawings(const Offer& offer);
    void chooseDrawing(ChoiceBox* box, QString& file);
    QString missing(const WantedPass& wanted) const;
    void update();
    void previewSoon() { previewTimer_.start(); }
    void askPreview();
    Result<PlanDrawing> drawingOf(const QString& file);
    /// The kinds' needs aside. Errors: those of readDrawing, regionOf and validate.
    Result<WantedPass> wantedNow();
    void confirm();

    QString folder_, areaFile_, linesFile_;
    PlanRegion painted_;
    std::vector<TakeInfo> takes_;
    WantedPass wanted_;
    PassForm* form_ = nullptr;
    ChoiceBox *area_ = nullptr, *lines_ = nullptr, *fileUnit_ = nullptr;
    QCheckBox* areaOnPart_ = nullptr;
    FieldRow *areaRow_ = nullptr, *linesRow_ = nullptr, *fileUnitRow_ = nullptr;
    Notice* notice_ = nullptr;
    QLabel* preview_ = nullptr;
    QTimer previewTimer_;
    struct {
        QString file;
        double unit = 0.0;
        std::optional<PlanDrawing> drawing;
    } read_; ///< last
};

} // namespace burin
