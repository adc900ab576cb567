// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/pass_request.h"
#include "ui/panels/quantity_field.h"

#include <QWidget>

#include <optional>
#include <vector>

class QCheckBox;
class QSpinBox;
class QVBoxLayout;

namespace burin {

class ChoiceBox;
class FieldRow;

/// What figures of a pass are where the user states none, mm.
struct PassDefaults {
    double roughStep = 0.0, fineStep = 0.0; ///< step-overs
    double levelDepth = 0.0, stairs = 0.0;
    double top = 0.0;     ///< of the stock
    double bottom = 0.0;  ///< the part's lowest point
    double partTop = 0.0; ///< the part's highest point, the bottom of facing
};

/// Asks for the kind of a pass and the figures that belong to it: "passKind", a field a figure ("passStepOver", …).
/// What nobody enters follows the kind.
class PassForm final : public QWidget {
    Q_OBJECT
public:
    /// @param last what it begins with @param drills the tool is a drill, which does nothing else; another tool can't
    PassForm(const PassRequest& last, const PassDefaults& defaults, LengthUnit unit, bool drills, QWidget* parent);

    PassKind kind() const;
    /// What is typed and not entered yet counts from now on.
    void commitTyping();
    /// Kind and figures; what is not the user's is left to the planner where the planner knows it.
    void writeTo(PassRequest& request) const;

signals:
    void kindChanged();
    void changed(); ///< a figure

private:
    /// One figure, and the kinds that it counts for.
    struct Figure {
        QuantityField* field = nullptr;
        FieldRow* row = nullptr;
        double PassRequest::*member = nullptr;
        std::optional<double> PassRequest::*height = nullptr; ///< in place of a member
        std::vector<PassKind> kinds;
        bool edited = false; ///< its value is the user's
    };
    struct Switch {
        QCheckBox* box = nullptr;
        bool PassRequest::*member = nullptr;
        std::vector<PassKind> kinds;
    };
    void addKinds(bool drills, PassKind chosen);
    void addFigures();
    void addSwitches(const PassRequest& last);
    void addTabs(int count);
    void addFigure(Figure figure, const char* name, const QString& label, const QString& toolTip, Quantity quantity,
                   double low, double high);
    void addSwitch(Switch one, const char* name, const QString& label, const QString& toolTip, bool on);
    void showLast(const PassRequest& last);
    double defaultOf(const Figure& figure) const;
    void update();

    LengthUnit unit_;
    PassDefaults defaults_;
    ChoiceBox* kind_ = nullptr;
    QSpinBox* tabs_ = nullptr;
    FieldRow* tabsRow_ = nullptr;
    std::vector<Figure> figures_;
    std::vector<Switch> switches_;
};

/// Kinds of passes that the window's lists put together.
bool milledInLevels(PassKind kind) noexcept;
bool laidOnPart(PassKind kind) noexcept; ///< where an area may be of what the tool touches

} // namespace burin
