// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "ui/panels/length_field.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include <cmath>

namespace burin::tst_length_field {

namespace {

/// A field that shows 5 mm and a second field to move the focus to, in an active window.
struct Rig {
    explicit Rig(const char* locale = "en_US", LengthUnit unit = LengthUnit::millimetre)
        : edited(&field, &QuantityField::valueEdited) {
        auto* row = new QHBoxLayout(&window);
        row->addWidget(&field);
        row->addWidget(&other);
        for (QWidget* widget : {static_cast<QWidget*>(&field), static_cast<QWidget*>(&other)})
            widget->setLocale(QLocale(QString::fromLatin1(locale)));
        field.limit(0.0, 100.0);
        field.setLengthUnit(unit);
        field.showValue(5.0);
        window.show();
        window.activateWindow();
        window.raise();
        shown = QTest::qWaitForWindowActive(&window);
        field.setFocus(Qt::TabFocusReason);
    }
    ~Rig() { // because of the members' order: a layout must not delete widgets that it did not create
        field.setParent(nullptr);
        other.setParent(nullptr);
    }
    void type(const QString& text) {
        field.selectAll();
        QTest::keyClicks(&field, text);
    }
    void commit() { QTest::keyClick(&field, Qt::Key_Return); }
    QString text() const { return field.text().replace(QChar(QChar::Nbsp), QLatin1Char(' ')); }

    QWidget window;
    LengthField field, other;
    QSignalSpy edited;
    bool shown = false;
};

bool near(double a, double b) {
    return std::abs(a - b) < 1e-8;
}

} // namespace

class TestLengthField : public QObject {
    Q_OBJECT
private slots:
    void whatIsTypedIsMillimetres_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<int>("unit");
        QTest::addColumn<double>("mm");
        const int mm = static_cast<int>(LengthUnit::millimetre), inch = static_cast<int>(LengthUnit::inch);
        QTest::newRow("a number") << "12.5" << mm << 12.5;
        QTest::newRow("a comma") << "12,5" << mm << 12.5;
        QTest::newRow("its unit") << "12,5 mm" << mm << 12.5;
        QTest::newRow("inches in millimetres") << "0.5in" << mm << 12.7;
        QTest::newRow("inches by their sign") << "0.5\"" << mm << 12.7;
        QTest::newRow("in words") << "2 inch" << mm << 50.8;
        QTest::newRow("micrometres") << "80 um" << mm << 0.08;
        QTest::newRow("centimetres") << "1,5cm" << mm << 15.0;
        QTest::newRow("capitals") << "3 MM" << mm << 3.0;
        QTest::newRow("no leading nought") << ".5" << mm << 0.5;
        QTest::newRow("trailing point") << "7." << mm << 7.0;
        QTest::newRow("inches") << "0.5" << inch << 12.7;
        QTest::newRow("inches with a comma") << "0,5" << inch << 12.7;
        QTest::newRow("millimetres in inches") << "3 mm" << inch << 3.0;
        QTest::newRow("finer than is shown") << "1.23456" << mm << 1.23456;
    }
    void whatIsTypedIsMillimetres() {
        QFETCH(QString, typed);
        QFETCH(int, unit);
        QFETCH(double, mm);
        for (const char* locale : {"C", "de_DE"}) {
            Rig rig(locale, static_cast<LengthUnit>(unit));
            QVERIFY(rig.shown);
            rig.type(typed);
            QCOMPARE(rig.edited.size(), 0); // not before the value is committed
            rig.commit();
            QCOMPARE(rig.edited.size(), 1);
            QVERIFY2(near(rig.edited[0][0].toDouble(), mm), qPrintable(QString::number(rig.edited[0][0].toDouble())));
            QVERIFY(near(rig.field.value(), mm));
            rig.commit();
            QCOMPARE(rig.edited.size(), 1); // once
        }
    }

    void itShowsWhatTheLocaleWrites() {
        QCOMPARE(Rig("de_DE").text(), QStringLiteral("5,000 mm"));
        QCOMPARE(Rig("C").text(), QStringLiteral("5.000 mm"));
        QCOMPARE(Rig("de_DE", LengthUnit::inch).text(), QStringLiteral("0,1969 in"));
    }

    void leavingTheFieldCommits() {
        Rig rig;
        rig.type(QStringLiteral("8"));
        QTest::keyClick(&rig.field, Qt::Key_Tab);
        QVERIFY(rig.other.hasFocus());
        QCOMPARE(rig.edited.size(), 1);
        QCOMPARE(rig.edited[0][0].toDouble(), 8.0);
    }

    void passingThroughChangesNothing() {
        // 1 mm is 0.03937… in: the display is rounded, and must not become the value.
        Rig rig("C", LengthUnit::inch);
        rig.field.showValue(1.0);
        QTest::keyClick(&rig.field, Qt::Key_Tab);
        QTest::keyClick(&rig.other, Qt::Key_Tab, Qt::ShiftModifier);
        rig.commit();
        QCOMPARE(rig.edited.size(), 0);
        QCOMPARE(rig.field.value(), 1.0);
        rig.type(QStringLiteral("0.0394")); // typing the displayed text is no change either
        rig.commit();
        QCOMPARE(rig.field.value(), 1.0);
        QCOMPARE(rig.edited.size(), 0);
        rig.field.setLengthUnit(LengthUnit::millimetre);
        QCOMPARE(rig.text(), QStringLiteral("1.000 mm"));
        QCOMPARE(rig.edited.size(), 0);
    }

    /// The value does not change; the message states what was refused, the range and the value that stays, also if the
    /// field was left by a click.
    void outOfRangeIsRefusedAndSaysTheRange_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("refused");
        QTest::addColumn<bool>("byEnter");
        for (const bool byEnter : {true, false}) {
            const char* how = byEnter ? "Enter" : "click";
            QTest::addRow("too large, %s", how) << "500"
                                                << "500.000 mm" << byEnter;
            QTest::addRow("too large in inches, %s", how) << "30 in"
                                                          << "762.000 mm" << byEnter;
            QTest::addRow("below nought, %s", how) << "-3"
                                                   << "-3.000 mm" << byEnter;
        }
    }
    void outOfRangeIsRefusedAndSaysTheRange() {
        QFETCH(QString, typed);
        QFETCH(QString, refused);
        QFETCH(bool, byEnter);
        Rig rig;
        rig.type(typed);
        if (byEnter)
            rig.commit();
        else
            QTest::mouseClick(&rig.other, Qt::LeftButton);
        QCOMPARE(rig.field.value(), 5.0);
        QCOMPARE(rig.text(), QStringLiteral("5.000 mm"));
        QCOMPARE(rig.edited.size(), 0);
        auto* message = rig.window.findChild<QLabel*>(QStringLiteral("fieldMessage"));
        QVERIFY(message != nullptr && message->isVisible());
        QString sentence = message->text().replace(QChar(QChar::Nbsp), QLatin1Char(' '));
        sentence.replace(QChar(0x2212), QLatin1Char('-'));
        for (const QString& figure : {refused, QStringLiteral("0.000 mm to 100.000 mm"), QStringLiteral("5.000 mm")})
            QVERIFY2(sentence.contains(figure), qPrintable(sentence));
    }

    /// 5 mm is 0.19685 in, which is displayed as 0.1969 in = 5.001 mm and is still accepted as the end of the range.
    void anEndOfTheRangeMayBeTypedAsItIsShown() {
        Rig rig("C", LengthUnit::inch);
        rig.field.limit(0.0, 5.0);
        rig.field.showValue(1.0);
        rig.type(QStringLiteral("0.1969"));
        rig.commit();
        QCOMPARE(rig.field.value(), 5.0);
        QCOMPARE(rig.edited.size(), 1);
        QVERIFY(rig.window.findChild<QLabel*>(QStringLiteral("fieldMessage")) == nullptr);
    }

    void anEntryWithinTheRangeSaysNothing() {
        Rig rig;
        rig.type(QStringLiteral("100"));
        rig.commit();
        QCOMPARE(rig.field.value(), 100.0);
        rig.type(QStringLiteral("500"));
        QTest::keyClick(&rig.field, Qt::Key_Escape); // discarded before it is committed
        rig.commit();
        QVERIFY(rig.window.findChild<QLabel*>(QStringLiteral("fieldMessage")) == nullptr);
    }

    void nonsenseChangesNothing_data() {
        QTest::addColumn<QString>("typed");
        QTest::newRow("letters") << "abc";
        QTest::newRow("an unknown unit") << "5 furlong";
        QTest::newRow("a weight") << "5 kg";
        QTest::newRow("two points") << "1.2.3";
        QTest::newRow("groups") << "1.234,5";
        QTest::newRow("a sign alone") << "-";
        QTest::newRow("nothing") << " ";
    }
    void nonsenseChangesNothing() {
        QFETCH(QString, typed);
        Rig rig;
        rig.type(typed);
        rig.commit();
        QCOMPARE(rig.edited.size(), 0);
        QCOMPARE(rig.field.value(), 5.0);
        QCOMPARE(rig.text(), QStringLiteral("5.000 mm"));
    }

    void escapeTakesTypingBack() {
        Rig rig;
        rig.type(QStringLiteral("77"));
        QTest::keyClick(&rig.field, Qt::Key_Escape);
        QCOMPARE(rig.text(), QStringLiteral("5.000 mm"));
        rig.commit();
        QCOMPARE(rig.edited.size(), 0);
    }

    /// Ctrl+Z belongs to the window once the number is committed, and to the text while the user types.
    void undoIsTheWindowsUnlessTheUserTypes() {
        Rig rig;
        QVERIFY(rig.shown);
        int undone = 0;
        auto* undo = new QShortcut(QKeySequence::Undo, &rig.window);
        connect(undo, &QShortcut::activated, this, [&] { ++undone; });
        rig.type("12");
        QTest::keyClick(&rig.field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(undone, 0);
        rig.type("12");
        rig.commit();
        QVERIFY(rig.field.hasFocus());
        QTest::keyClick(&rig.field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(undone, 1);
    }

    void stepsFitTheNumber_data() {
        QTest::addColumn<double>("from");
        QTest::addColumn<int>("unit");
        QTest::addColumn<QString>("up");
        QTest::addColumn<QString>("down");
        const int mm = static_cast<int>(LengthUnit::millimetre), inch = static_cast<int>(LengthUnit::inch);
        QTest::newRow("some") << 5.0 << mm << "5.100 mm"
                              << "4.900 mm";
        QTest::newRow("a tolerance") << 0.02 << mm << "0.021 mm"
                                     << "0.019 mm";
        QTest::newRow("large") << 40.0 << mm << "41.000 mm"
                               << "39.000 mm";
        QTest::newRow("a power of ten") << 10.0 << mm << "11.000 mm"
                                        << "9.900 mm";
        QTest::newRow("nothing") << 0.0 << mm << "0.001 mm"
                                 << "0.000 mm";
        QTest::newRow("inch") << 25.4 << inch << "1.1000 in"
                              << "0.9900 in";
        QTest::newRow("the end") << 99.5 << mm << "100.000 mm"
                                 << "99.000 mm";
    }
    void stepsFitTheNumber() {
        QFETCH(double, from);
        QFETCH(int, unit);
        QFETCH(QString, up);
        QFETCH(QString, down);
        Rig rig("C", static_cast<LengthUnit>(unit));
        rig.field.showValue(from);
        QTest::keyClick(&rig.field, Qt::Key_Up);
        QCOMPARE(rig.text(), up);
        QCOMPARE(rig.edited.size(), 1);
        QCOMPARE(rig.edited[0][0].toDouble(), rig.field.value());
        rig.field.showValue(from);
        QTest::keyClick(&rig.field, Qt::Key_Down);
        QCOMPARE(rig.text(), down);
        QCOMPARE(rig.edited.size(), from > 0.0 ? 2 : 1);
    }

    void theWheelNeedsTheFocus() {
        Rig rig;
        const auto turn = [&rig](QWidget& field) {
            const QPointF place = field.rect().center();
            QWheelEvent event(place, field.mapToGlobal(place), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&field, &event);
        };
        rig.other.setFocus();
        turn(rig.field);
        QCOMPARE(rig.field.value(), 5.0);
        QCOMPARE(rig.edited.size(), 0);
        rig.field.setFocus();
        turn(rig.field);
        QVERIFY(near(rig.field.value(), 5.1));
        QCOMPARE(rig.edited.size(), 1);
    }

    void showingNeverTells() {
        Rig rig;
        rig.field.showValue(7.0);
        rig.field.limit(0.0, 6.0);
        rig.field.setLengthUnit(LengthUnit::inch);
        QCOMPARE(rig.edited.size(), 0);
        QCOMPARE(rig.field.value(), 6.0);
        QTest::keyClick(&rig.field, Qt::Key_Tab);
        QCOMPARE(rig.edited.size(), 0);
    }

    void typingIsLeftAlone() {
        Rig rig;
        rig.type(QStringLiteral("12"));
        rig.field.findChild<QLineEdit*>()->setCursorPosition(1);
        for (const double news : {5.0, 6.0, 6.5}) rig.field.showValue(news); // as state updates do, many times a second
        QVERIFY(rig.text().startsWith(QStringLiteral("12")));
        QCOMPARE(rig.field.findChild<QLineEdit*>()->cursorPosition(), 1);
        rig.commit();
        QCOMPARE(rig.edited.size(), 1);
        QCOMPARE(rig.edited[0][0].toDouble(), 12.0);
        rig.type(QStringLiteral("30"));
        rig.field.showValue(9.0);
        QTest::keyClick(&rig.field, Qt::Key_Escape); // back to the latest value
        QCOMPARE(rig.field.value(), 9.0);
        QCOMPARE(rig.edited.size(), 1);
    }

    void otherQuantitiesHaveTheirUnits_data() {
        QTest::addColumn<int>("quantity");
        QTest::addColumn<int>("unit");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("shown");
        const auto row = [](const char* name, Quantity quantity, LengthUnit unit, const char* typed, double value,
                            const char* shown) {
            QTest::newRow(name) << static_cast<int>(quantity) << static_cast<int>(unit) << typed << value << shown;
        };
        row("speed", Quantity::speed, LengthUnit::millimetre, "60", 60.0, "60 mm/s");
        row("speed a minute", Quantity::speed, LengthUnit::millimetre, "600 mm/min", 10.0, "10 mm/s");
        row("speed in inches", Quantity::speed, LengthUnit::inch, "2", 50.8, "2 in/s");
        row("time", Quantity::time, LengthUnit::millimetre, "0,15", 0.15, "0.15 s");
        row("milliseconds", Quantity::time, LengthUnit::millimetre, "250 ms", 0.25, "0.25 s");
        row("frequency", Quantity::frequency, LengthUnit::inch, "7.5 Hz", 7.5, "7.5 Hz");
        row("force", Quantity::force, LengthUnit::inch, "40 N", 40.0, "40 N");
        row("removal", Quantity::removalRate, LengthUnit::millimetre, "12.5 mm³/s", 12.5, "12.5 mm³/s");
        row("removal a minute", Quantity::removalRate, LengthUnit::millimetre, "6 cm³/min", 100.0, "100 mm³/s");
        row("removal in inches", Quantity::removalRate, LengthUnit::inch, "3", 819.3532, "3 in³/min");
    }
    void otherQuantitiesHaveTheirUnits() {
        QFETCH(int, quantity);
        QFETCH(int, unit);
        QFETCH(QString, typed);
        QFETCH(double, value);
        QFETCH(QString, shown);
        QuantityField field(static_cast<Quantity>(quantity));
        field.setLocale(QLocale::c());
        field.setLengthUnit(static_cast<LengthUnit>(unit));
        QSignalSpy edited(&field, &QuantityField::valueEdited);
        field.show();
        QVERIFY(QTest::qWaitForWindowExposed(&field));
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, typed);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(edited.size(), 1);
        QVERIFY(near(edited[0][0].toDouble(), value));
        QCOMPARE(field.text().replace(QChar(QChar::Nbsp), QLatin1Char(' ')), shown);
    }
};

BURIN_TEST(TestLengthField, QApplication)

} // namespace burin::tst_length_field

#include "tst_length_field.moc"
