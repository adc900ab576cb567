// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/pass_request.h"
#include "core/passes/thread_size.h"
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

/// Defaults of the values of a pass, mm.
struct PassDefaults {
    double roughStep = 0.0, fineStep = 0.0; ///< step-overs
    double levelDepth = 0.0, stairs = 0.0;
    double top = 0.0;     ///< of the stock
    double bottom = 0.0;  ///< the part's lowest point
    double partTop = 0.0; ///< the part's highest point, the bottom of facing
    ThreadSize thread;    ///< that the tool is made for; none: another one
};

/// Asks for the kind of a pass and the values that apply to it: "passKind", one field for each value ("passStepOver",
/// …). Values that the user does not enter follow the kind.
class PassForm final : public QWidget {
    Q_OBJECT
public:
    /// @param last initial values @param kinds that the tool can do, at least one
    PassForm(const PassRequest& last, const PassDefaults& defaults, LengthUnit unit, const std::vector<PassKind>& kinds,
             QWidget* parent);

    PassKind kind() const;
    bool external() const;       ///< whether a thread is to be on studs instead of in holes
    bool extendsStrokes() const; ///< whether the rows continue strokes of the hand, and follow no lines
    /// Accepts text that is being typed.
    void commitTyping();
    /// Kind and values; values that the user did not enter are left to the planner if it can determine them.
    void writeTo(PassRequest& request) const;

signals:
    /// Or what the pass does about strokes of the hand, or whether a thread is external: other choices may apply.
    void kindChanged();
    void changed(); ///< of a value

private:
    /// One value, and the kinds that it applies to.
    struct Figure {
        QuantityField* field = nullptr;
        FieldRow* row = nullptr;
        double PassRequest::*member = nullptr;
        std::optional<double> PassRequest::*height = nullptr; ///< instead of `member`
        std::vector<PassKind> kinds;
        bool edited = false; ///< the user entered its value
    };
    struct Switch {
        QCheckBox* box = nullptr;
        bool PassRequest::*member = nullptr;
        std::vector<PassKind> kinds;
    };
    void addKinds(const std::vector<PassKind>& kinds, PassKind chosen);
    void addFigures();
    void addSwitches(const PassRequest& last);
    void addTabs(int count);
    void addThread(int radialPasses);
    void addHand(HandStrokes chosen);
    void offerHand(HandStrokes chosen);
    HandStrokes hand() const;
    void takeThreadSize(int index);
    void showThreadSize();
    void setFigure(double PassRequest::*member, double value);
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
    ChoiceBox* hand_ = nullptr;
    FieldRow* handRow_ = nullptr;
    ChoiceBox* threadSize_ = nullptr;
    QSpinBox* radialPasses_ = nullptr;
    FieldRow *threadSizeRow_ = nullptr, *radialPassesRow_ = nullptr;
    std::vector<Figure> figures_;
    std::vector<Switch> switches_;
};

/// Groups of kinds of passes, for the lists in the window.
bool milledInLevels(PassKind kind) noexcept;
bool laidOnPart(PassKind kind) noexcept; ///< kinds for which an area may bound the points that the tool touches

} // namespace burin
