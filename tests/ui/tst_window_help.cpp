// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The help, opened by keys and compared with the window.
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include "ui/help/help_dialog.h"

#include <QApplication>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTextBlock>
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

constexpr qint64 largestPicture = 40 * 1024, allPictures = 2'500'000; // bytes

/// The text that stands for a picture, and the picture's file relative to the page.
struct PictureLink {
    QString text, file;
};

std::vector<PictureLink> picturesOf(const HelpPage& page) {
    static const QRegularExpression link("!\\[([^\\]]*)\\]\\(([^)]+)\\)");
    std::vector<PictureLink> links;
    for (auto at = link.globalMatch(page.text); at.hasNext();) {
        const QRegularExpressionMatch match = at.next();
        links.push_back({match.captured(1), match.captured(2)});
    }
    return links;
}

QString fileOf(const HelpPage& page, const PictureLink& picture) {
    return QDir::cleanPath(QDir(page.folder).filePath(picture.file));
}

/// The formats of the pictures in a page as it is shown.
std::vector<QTextImageFormat> shownPictures(const QTextDocument& document) {
    std::vector<QTextImageFormat> formats;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        for (auto piece = block.begin(); !piece.atEnd(); ++piece)
            if (piece.fragment().charFormat().isImageFormat())
                formats.push_back(piece.fragment().charFormat().toImageFormat());
    return formats;
}

/// The width at which a picture is drawn, in pixels of the window. 0: it was not found.
double drawnWidth(const QTextDocument& document, const QTextImageFormat& format) {
    const auto image = document.resource(QTextDocument::ImageResource, QUrl(format.name())).value<QImage>();
    return image.isNull() ? 0.0 : image.width() / image.devicePixelRatio();
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
        keepPicture(*help, "help");
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

    /// Every page of every language has a picture of its own language, with a text in that language; all are small.
    void everyPageHasAPicture() {
        const std::vector<HelpPage> english = helpPages("en");
        QSet<QByteArray> contents;
        qint64 all = 0;
        int pictures = 0;
        for (const QString language : {"en", "de", "zh_CN"}) {
            const std::vector<HelpPage> pages = helpPages(language);
            QCOMPARE(pages.size(), english.size());
            for (std::size_t i = 0; i < pages.size(); ++i) {
                const std::vector<PictureLink> links = picturesOf(pages[i]), originals = picturesOf(english[i]);
                QVERIFY2(!links.empty(), qPrintable(language + ' ' + pages[i].topic));
                QCOMPARE(links.size(), originals.size());
                for (std::size_t k = 0; k < links.size(); ++k) {
                    QVERIFY(links[k].text.size() > 10 && links[k].file.startsWith("../pictures/" + language + '/'));
                    QVERIFY2(language == "en" || links[k].text != originals[k].text, qPrintable(links[k].text));
                    QFile file(fileOf(pages[i], links[k]));
                    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
                    QVERIFY2(file.size() <= largestPicture, qPrintable(file.fileName()));
                    const QByteArray content = file.readAll();
                    const QImage image = QImage::fromData(content);
                    QVERIFY2(image.width() >= 200 && image.height() >= 40, qPrintable(file.fileName()));
                    contents.insert(content);
                    all += file.size();
                    ++pictures;
                }
            }
        }
        QCOMPARE(contents.size(), pictures); // none is shown twice, in two languages, say
        QVERIFY2(all < allPictures, qPrintable(QString::number(all)));
    }

    void picturesAreShown_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "de", "zh_CN"}) QTest::newRow(language) << language;
    }
    /// A picture is as wide as it is, or as the page where that is narrower; it follows the window's width.
    void picturesAreShown() {
        QFETCH(QString, language);
        const std::vector<HelpPage> pages = helpPages(language);
        HelpDialog help(pages);
        help.show();
        QVERIFY(QTest::qWaitForWindowExposed(&help));
        auto* page = help.findChild<QTextBrowser*>("helpPage");
        int reduced = 0;
        for (const int width : {1000, 640}) {
            help.resize(width, 640);
            QTRY_COMPARE(help.width(), width);
            for (const HelpPage& one : pages) {
                help.showTopic(one.topic);
                QTest::qWait(20);
                QVERIFY2(!page->toPlainText().contains('*'), qPrintable(one.topic)); // emphasis that does not end
                const std::vector<PictureLink> links = picturesOf(one);
                const std::vector<QTextImageFormat> shown = shownPictures(*page->document());
                QCOMPARE(shown.size(), links.size());
                for (std::size_t k = 0; k < links.size(); ++k) {
                    QCOMPARE(shown[k].property(QTextFormat::ImageAltText).toString(), links[k].text);
                    const double own = QImage(fileOf(one, links[k])).width();
                    const double drawn = drawnWidth(*page->document(), shown[k]);
                    QVERIFY2(drawn > 0.0 && drawn <= page->viewport()->width(), qPrintable(links[k].file));
                    QVERIFY2(drawn == own || (drawn < own && drawn > 0.8 * page->viewport()->width()),
                             qPrintable(links[k].file));
                    reduced += drawn < own ? 1 : 0;
                }
            }
        }
        QVERIFY(reduced > 0);   // the timeline is wide
        help.resize(1000, 640); // the same page, wider again
        help.showTopic("time");
        QTest::qWait(50);
        const double wide = drawnWidth(*page->document(), shownPictures(*page->document()).front());
        help.resize(640, 640);
        QTRY_VERIFY(drawnWidth(*page->document(), shownPictures(*page->document()).front()) < wide - 100.0);
        keepPicture(*page, QStringLiteral("help-time-%1").arg(language));
    }

    /// Names of files are no words of a page.
    void filesAreNotSearched() {
        HelpDialog help(helpPages("en"));
        help.show();
        auto* search = help.findChild<QLineEdit*>("helpSearch");
        QTest::keyClicks(search, "png");
        QVERIFY(help.findChild<QLabel*>("helpEmpty")->isVisible());
        search->selectAll();
        QTest::keyClicks(search, "clip with its stroke"); // the text of a picture is
        QCOMPARE(topicIn(help), QString("Timeline and history"));
    }
};

BURIN_TEST(TestWindowHelp, QApplication)

} // namespace burin::tst_window_help

#include "tst_window_help.moc"
