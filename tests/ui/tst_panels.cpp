// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/panel_examples.h"
#include "ui/panels/allowance_panel.h"
#include "ui/panels/bounds_panel.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/guide_panel.h"
#include "ui/panels/hand_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/meters.h"
#include "ui/panels/mill_panel.h"
#include "ui/panels/notice.h"
#include "ui/panels/part_panel.h"
#include "ui/panels/path_panel.h"
#include "ui/panels/program_panel.h"
#include "ui/panels/step_bar.h"
#include "ui/panels/stock_panel.h"
#include "ui/panels/surroundings_panel.h"
#include "ui/panels/tool_panel.h"
#include "ui/panels/value_row.h"
#include "ui/theme/theme.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QApplication>
#include <QDir>
#include <QMetaMethod>
#include <QPainter>
#include <QProcess>
#include <QSignalSpy>
#include <QTranslator>
#include <QtTest>

#include <cmath>

namespace burin::tst_panels {

namespace {

constexpr int panelWidth = 320;

std::unique_ptr<QWidget> make(const QString& name, LengthUnit unit = LengthUnit::millimetre) {
    const auto made = [unit](auto* panel, const auto& state) {
        if constexpr (requires { panel->setUnit(unit); }) panel->setUnit(unit);
        panel->setState(state);
        return std::unique_ptr<QWidget>(panel);
    };
    if (name == QLatin1String("part")) return made(new PartPanel, examples::part());
    if (name == QLatin1String("stock")) return made(new StockPanel, examples::stock());
    if (name == QLatin1String("material")) return made(new MaterialPanel, examples::material());
    if (name == QLatin1String("tool")) return made(new ToolPanel, examples::tool());
    if (name == QLatin1String("allowance")) return made(new AllowancePanel, AllowanceState{0.3, 5.0, true});
    if (name == QLatin1String("mill")) return made(new MillPanel, examples::mill());
    if (name == QLatin1String("surroundings")) return made(new SurroundingsPanel, examples::surroundings());
    if (name == QLatin1String("bounds")) return made(new BoundsPanel, examples::surroundings());
    if (name == QLatin1String("guides")) return made(new GuidePanel, examples::guides());
    if (name == QLatin1String("hand")) return made(new HandPanel, examples::hand());
    if (name == QLatin1String("path")) return made(new PathPanel, examples::path());
    if (name == QLatin1String("program")) return made(new ProgramPanel, examples::program());
    if (name == QLatin1String("program failed")) return made(new ProgramPanel, examples::failedProgram());
    if (name == QLatin1String("meters")) return made(new Meters, examples::meters());
    return {};
}

const QStringList names{"part",   "stock",  "surroundings", "material", "tool",    "allowance",      "mill",
                        "bounds", "guides", "hand",         "path",     "program", "program failed", "meters"};

void shape(QWidget& panel) {
    panel.setAttribute(Qt::WA_DontShowOnScreen);
    panel.show();
    panel.resize(panelWidth, std::max(panel.heightForWidth(panelWidth), panel.minimumSizeHint().height()));
    QCoreApplication::processEvents();
}

/// The widget as the screen shows it, at the screen's scale.
QImage picture(QWidget& widget) {
    QImage image(widget.size() * widget.devicePixelRatio(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(widget.devicePixelRatio());
    image.fill(activePalette().panel);
    widget.render(&image);
    return image;
}

QString screenshot(const QString& name) {
    return QStringLiteral(BURIN_BUILD_DIRECTORY "/tests/screenshots/panel-%1.png").arg(name);
}

int coloursOf(const QImage& image) {
    QSet<QRgb> colours;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
    return static_cast<int>(colours.size());
}

void keep(const QImage& image, const QString& name) {
    QDir().mkpath(QStringLiteral(BURIN_BUILD_DIRECTORY "/tests/screenshots"));
    image.save(screenshot(QStringLiteral("%1-%2x").arg(name).arg(image.devicePixelRatio())));
}

/// Pictures next to each other, for visual inspection.
QImage beside(const std::vector<QImage>& pictures) {
    QSize size;
    for (const QImage& one : pictures) size = {size.width() + one.width() + 8, std::max(size.height(), one.height())};
    QImage sheet(size, QImage::Format_ARGB32_Premultiplied);
    sheet.fill(activePalette().window);
    QPainter painter(&sheet);
    int x = 0;
    for (QImage one : pictures) {
        one.setDevicePixelRatio(1.0);
        painter.drawImage(x, 0, one);
        x += one.width() + 8;
    }
    return sheet;
}

/// Counts all signals that a panel declares itself.
struct Ears {
    explicit Ears(QObject& panel) {
        const QMetaObject& meta = *panel.metaObject();
        for (int i = meta.methodOffset(); i < meta.methodCount(); ++i)
            if (meta.method(i).methodType() == QMetaMethod::Signal)
                spies.push_back(std::make_unique<QSignalSpy>(&panel, meta.method(i)));
    }
    qsizetype heard() const {
        qsizetype sum = 0;
        for (const auto& spy : spies) sum += spy->size();
        return sum;
    }
    std::vector<std::unique_ptr<QSignalSpy>> spies;
};

/// Makes every text as long as a German one: each word gets two fifths longer.
class LongWords : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* source, const char*, int) const override {
        QStringList words = QString::fromUtf8(source).split(QLatin1Char(' '));
        for (QString& word : words) {
            if (word.contains(QLatin1Char('%')) || word.size() < 2) continue;
            const auto more = static_cast<qsizetype>(std::ceil(0.4 * static_cast<double>(word.size())));
            word.insert(word.size() - 1, QString(more, QLatin1Char('n')));
        }
        return words.join(QLatin1Char(' '));
    }
};

/// The clipped parts of a visible panel; empty if there are none.
QString cutOff(const QWidget& panel) {
    QStringList found;
    const auto add = [&found](const QWidget& widget, const QString& what) {
        found.append(QStringLiteral("%1 \"%2\": %3").arg(widget.metaObject()->className(), widget.objectName(), what));
    };
    if (panel.minimumSizeHint().width() > panelWidth)
        add(panel, QStringLiteral("needs %1 pixels").arg(panel.minimumSizeHint().width()));
    for (const QWidget* widget : panel.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != &panel) continue;
        const auto* list = qobject_cast<const QAbstractScrollArea*>(widget->parentWidget());
        if (list == nullptr &&
            qobject_cast<const QAbstractScrollArea*>(widget->parentWidget()->parentWidget()) == nullptr &&
            !widget->parentWidget()->rect().contains(widget->geometry()))
            add(*widget, QStringLiteral("reaches out of what holds it"));
        const auto* label = qobject_cast<const QLabel*>(widget);
        if (label != nullptr && qobject_cast<const ElidedLabel*>(widget) == nullptr && !label->text().isEmpty()) {
            if (label->wordWrap() ? label->height() < label->heightForWidth(label->width())
                                  : label->width() < label->sizeHint().width())
                add(*widget, label->text());
        }
        if (qobject_cast<const QAbstractButton*>(widget) != nullptr &&
            widget->width() < widget->minimumSizeHint().width())
            add(*widget, static_cast<const QAbstractButton*>(widget)->text());
        if (const auto* row = qobject_cast<const ValueRow*>(widget)) {
            const auto* value = row->findChildren<ElidedLabel*>().last();
            if (value->fontMetrics().horizontalAdvance(value->text()) > value->width()) add(*widget, value->text());
        }
    }
    return found.join(QLatin1Char('\n'));
}

} // namespace

class TestPanels : public QObject {
    Q_OBJECT
private slots:
    void init() {
        QLocale::setDefault(QLocale(QStringLiteral("en_US")));
        applyTheme(*qApp, *loadPalette(Theme::dark));
    }

    /// As on the page of a step that is not shown yet.
    void aNoticeThatIsToldWhileHiddenIsSeenWhole() {
        const QString sentence =
            QStringLiteral("The material can be changed until the first take; the workpiece is kept.");
        QWidget page;
        auto* place = new NoticePlace(&page);
        Notice* notice = place->add("notice");
        place->resize(300, place->sizeHint().height());
        notice->tell(Notice::Kind::information, sentence);
        page.resize(320, 200);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        const auto* text = notice->findChild<QLabel*>();
        QVERIFY(text->isVisible());
        QCOMPARE(QString(text->text()).remove(QChar(0x200B)), sentence); // U+200B marks where lines may break
        const QRect needed =
            text->fontMetrics().boundingRect(QRect(0, 0, text->width(), 1000), Qt::TextWordWrap, text->text());
        QVERIFY(needed.height() > text->fontMetrics().lineSpacing()); // it has two lines
        QVERIFY2(text->height() >= needed.height(), qPrintable(QString::number(text->height())));
    }

    void everyRowOfAChoiceIsSeen() {
        for (const int count : {2, 5, 10}) {
            ChoiceBox box;
            for (int i = 0; i < count; ++i) box.addItem(QStringLiteral("choice %1").arg(i));
            box.show();
            QVERIFY(QTest::qWaitForWindowExposed(&box));
            box.showPopup();
            QTRY_VERIFY(box.view()->isVisible());
            QTest::qWait(50); // scrolling begins a moment later
            const QRect last = box.view()->visualRect(box.model()->index(count - 1, 0));
            QVERIFY(last.isValid() && box.view()->viewport()->rect().contains(last));
            box.hidePopup();
        }
    }

    void pictures_data() {
        QTest::addColumn<QString>("theme");
        for (const char* theme : {"dark", "light"}) QTest::newRow(theme) << QString::fromLatin1(theme);
    }
    void pictures() {
        QFETCH(QString, theme);
        const bool light = theme == QLatin1String("light");
        applyTheme(*qApp, *loadPalette(light ? Theme::light : Theme::dark));
        std::vector<QImage> all;
        for (const QString& name : names) {
            const std::unique_ptr<QWidget> panel = make(name, light ? LengthUnit::inch : LengthUnit::millimetre);
            shape(*panel);
            all.push_back(picture(*panel));
            keep(all.back(), QString(name).replace(' ', '-') + QLatin1Char('-') + theme);
            QVERIFY2(coloursOf(all.back()) > 8, qPrintable(name)); // more than a background and a text
        }
        StepBar line;
        line.setState(examples::job(), JobStep::mill);
        line.setAttribute(Qt::WA_DontShowOnScreen);
        line.show();
        line.resize(1280, line.sizeHint().height());
        QCoreApplication::processEvents();
        keep(picture(line), QStringLiteral("job-line-") + theme);
        if (qApp->devicePixelRatio() > 1.0) return; // these pictures are needed once only
        keep(beside({all.begin(), all.begin() + 4}), QStringLiteral("sheet-1-") + theme);
        keep(beside({all.begin() + 4, all.begin() + 7}), QStringLiteral("sheet-2-") + theme);
        keep(beside({all.begin() + 7, all.end()}), QStringLiteral("sheet-3-") + theme);
    }

    /// Runs the same program once more, on a screen of twice the density.
    BURIN_ONLY_IN_LONG_RUNS void theSameAtScaleTwo() {
        if (qApp->devicePixelRatio() > 1.0) return;
        QProcess again;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QStringLiteral("2"));
        again.setProcessEnvironment(environment);
        again.setProcessChannelMode(QProcess::MergedChannels);
        again.start(QCoreApplication::applicationFilePath(), {"panels", "pictures", "nothingIsCutOff"});
        QVERIFY(again.waitForFinished(60000));
        QVERIFY2(again.exitCode() == 0, again.readAll().constData());
        const QImage once(screenshot(QStringLiteral("stock-dark-1x"))),
            twice(screenshot(QStringLiteral("stock-dark-2x")));
        QCOMPARE(twice.width(), 2 * once.width());
    }

    void nothingIsCutOff_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<bool>("inch");
        for (const char* words : {"English", "long-words", "German"})
            for (const bool inch : {false, true})
                QTest::addRow("%s, %s", words, inch ? "in" : "mm") << QString::fromLatin1(words) << inch;
    }
    void nothingIsCutOff() {
        QFETCH(QString, words);
        QFETCH(bool, inch);
        LongWords longWords;
        QTranslator german;
        if (words == QLatin1String("long-words")) QCoreApplication::installTranslator(&longWords);
        if (words == QLatin1String("German")) {
            QVERIFY(german.load(QStringLiteral("burin_de"), QStringLiteral(BURIN_TRANSLATIONS)));
            QCoreApplication::installTranslator(&german);
            QCOMPARE(MillPanel::tr("Depth of cut"), QStringLiteral("Zustellung")); // the classes find their contexts
        }
        for (const QString& name : names) {
            const std::unique_ptr<QWidget> panel = make(name, inch ? LengthUnit::inch : LengthUnit::millimetre);
            shape(*panel);
            if (words != QLatin1String("English"))
                keep(picture(*panel), QString(name).replace(' ', '-') + QLatin1Char('-') + words.toLower());
            QVERIFY2(cutOff(*panel).isEmpty(), qPrintable(name + QStringLiteral(": ") + cutOff(*panel)));
        }
        StepBar line;
        QVERIFY2(line.minimumSizeHint().width() <= 1280, qPrintable(QString::number(line.minimumSizeHint().width())));
    }

    void settingAStateNeverTells() {
        const auto silent = [](auto&& panel, auto first, auto second) {
            Ears ears(panel);
            panel.show();
            for (int i = 0; i < 2; ++i) {
                panel.setState(first);
                panel.setUnit(LengthUnit::inch);
                panel.setState(second);
                panel.setUnit(LengthUnit::millimetre);
                panel.setState({});
                QCoreApplication::processEvents();
            }
            return !ears.spies.empty() && ears.heard() == 0;
        };
        QVERIFY(silent(PartPanel(), examples::part(), PartState{nullptr, true}));
        StockState locked = examples::stock();
        locked.locked = true;
        QVERIFY(silent(StockPanel(), examples::stock(), locked));
        MaterialState wax = examples::material();
        wax.stockMaterial = "machinable-wax";
        QVERIFY(silent(MaterialPanel(), examples::material(), wax));
        ToolState ball = examples::tool();
        ball.current = "ball-3";
        QVERIFY(silent(ToolPanel(), examples::tool(), ball));
        QVERIFY(silent(AllowancePanel(), AllowanceState{3.0, 5.0, false}, AllowanceState{3.0, 1.0, true}));
        MillState alongPart = examples::mill();
        alongPart.depthRule = DepthChoice::part;
        QVERIFY(silent(MillPanel(), examples::mill(), alongPart));
        PathState other = examples::path();
        other.path.edits.erase(other.path.edits.begin());
        other.path.edits[0].enabled = true;
        QVERIFY(silent(PathPanel(), examples::path(), other));
        QVERIFY(silent(ProgramPanel(), examples::program(), examples::failedProgram()));
    }

    void everyFieldHasANameForAssistance() {
        const auto nameless = [](QWidget& panel) {
            QStringList names;
            for (QWidget* widget : panel.findChildren<QWidget*>()) {
                if (widget->window() != panel.window()) continue; // the list of a choice
                if ((widget->focusPolicy() & Qt::TabFocus) == 0 ||
                    widget->objectName().startsWith(QLatin1String("qt_")))
                    continue;
                const auto* button = qobject_cast<QAbstractButton*>(widget);
                const bool named =
                    !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
                if (!named || widget->objectName().isEmpty() || (button != nullptr && button->toolTip().isEmpty()))
                    names.append(widget->objectName() + QLatin1Char(' ') +
                                 QLatin1String(widget->metaObject()->className()));
            }
            return names.join(QStringLiteral(", "));
        };
        const auto check = [&](auto&& panel, const auto& state) {
            panel.setState(state);
            return nameless(panel);
        };
        QCOMPARE(check(PartPanel(), examples::part()), QString());
        QCOMPARE(check(StockPanel(), examples::stock()), QString());
        QCOMPARE(check(MaterialPanel(), examples::material()), QString());
        QCOMPARE(check(ToolPanel(), examples::tool()), QString());
        QCOMPARE(check(AllowancePanel(), AllowanceState()), QString());
        QCOMPARE(check(MillPanel(), examples::mill()), QString());
        QCOMPARE(check(PathPanel(), examples::path()), QString());
        QCOMPARE(check(ProgramPanel(), examples::failedProgram()), QString());
    }
};

BURIN_TEST(TestPanels, QApplication)

} // namespace burin::tst_panels

#include "tst_panels.moc"
