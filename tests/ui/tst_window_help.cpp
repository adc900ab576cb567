// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The help, opened by keys and compared with the window.
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include "ui/help/help_dialog.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QtTest>

#include <set>

namespace burin::tst_window_help {

using namespace burin::testing;

namespace {

QString topicIn(const HelpDialog& help) {
    const QListWidgetItem* item = help.findChild<QListWidget*>("helpTopics")->currentItem();
    return item != nullptr ? item->text() : QString();
}

/// Keys that a page names, as on an English keyboard.
std::multiset<QString> keysIn(QString text) {
    text.replace("Strg", "Ctrl").replace("Umschalt", "Shift");
    static const QRegularExpression keys("(?:(?:Ctrl|Shift|Alt)\\+)+(?:F[0-9]+|[A-Z0-9]\\b|,)|\\bF[0-9]+\\b");
    std::multiset<QString> found;
    for (auto at = keys.globalMatch(text); at.hasNext();) found.insert(at.next().captured(0));
    return found;
}

} // namespace

class TestWindowHelp : public QObject {
    Q_OBJECT
private slots:
    /// F1 opens the page of the current step; searching finds what is typed.
    void theHelpIsOnTheStep() {
        WindowDriver driver;
        driver.key(Qt::Key_F1);
        auto* help = driver.window().findChild<HelpDialog*>();
        QVERIFY(help && help->isVisible());
        QCOMPARE(topicIn(*help), QString("From a part to a program"));
        help->close();
        QVERIFY(makeReady(driver, 1.0));
        for (const auto& [step, title] : {std::pair{JobStep::part, "Part and setups"},
                                          {JobStep::stock, "Stock, material and program zero"},
                                          {JobStep::tool, "Tool and allowance"},
                                          {JobStep::mill, "Milling by hand"}}) {
            QVERIFY(driver.step(step));
            driver.key(Qt::Key_F1);
            QTRY_VERIFY((help = driver.window().findChild<HelpDialog*>()) != nullptr && help->isVisible());
            QCOMPARE(topicIn(*help), QString(title));
            QVERIFY(help->findChild<QTextBrowser*>("helpPage")->toPlainText().startsWith(title));
        }
        auto* search = help->findChild<QLineEdit*>("helpSearch");
        search->setFocus();
        QTest::keyClicks(search, "worn cutter");
        QCOMPARE(topicIn(*help), QString("Tool and allowance"));
        QVERIFY(!help->findChild<QTextBrowser*>("helpPage")->extraSelections().isEmpty());
        help->grab().save(QStringLiteral(BURIN_BUILD_DIRECTORY "/tests/screenshots/help.png"));
        search->selectAll();
        QTest::keyClicks(search, "submarine");
        QVERIFY(help->findChild<QLabel*>("helpEmpty")->isVisible());
    }

    /// The keys that a page names for an action are the action's shortcuts.
    void itSaysTheKeysThatActionsHave() {
        WindowDriver driver;
        std::map<QString, QString> known;
        for (const QAction* action : menuActions(driver))
            known[action->iconText().remove(QChar(0x2026))] = action->shortcut().toString();
        static const QRegularExpression named("(?<!\\*)\\*([^*\\n]+)\\*(?!\\*) \\(([^)]+)\\)"); // in italics
        int checked = 0;
        for (const HelpPage& page : helpPages("en"))
            for (auto at = named.globalMatch(page.text); at.hasNext();) {
                const QRegularExpressionMatch match = at.next();
                const auto action = known.find(match.captured(1).remove(QChar(0x2026)));
                if (action == known.end()) continue;
                QVERIFY2(match.captured(2) == action->second, qPrintable(match.captured(0) + " is " + action->second));
                ++checked;
            }
        QVERIFY2(checked >= 10, qPrintable(QString::number(checked)));
    }

    void translationsAreComplete_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("German") << "de_AT";
        QTest::newRow("Chinese") << "zh_CN";
    }
    /// A translation has as many pages and paragraphs and the same keys.
    void translationsAreComplete() {
        QFETCH(QString, language);
        const std::vector<HelpPage> english = helpPages("en"), translated = helpPages(language);
        QCOMPARE(translated.size(), english.size());
        for (std::size_t i = 0; i < english.size(); ++i) {
            QVERIFY(translated[i].text != english[i].text);
            QCOMPARE(translated[i].text.count('\n'), english[i].text.count('\n'));
            QCOMPARE(translated[i].text.count("**"), english[i].text.count("**"));
            QVERIFY2(keysIn(translated[i].text) == keysIn(english[i].text), qPrintable(english[i].topic));
        }
        QCOMPARE(helpPages("xx").size(), english.size()); // a language without help gets the English one
    }
};

BURIN_TEST(TestWindowHelp, QApplication)

} // namespace burin::tst_window_help

#include "tst_window_help.moc"
