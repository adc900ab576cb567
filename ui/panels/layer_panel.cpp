// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/layer_panel.h"

#include "core/base/numbers.h"
#include "ui/panels/buttons.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/layer_fields.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"

#include <QHBoxLayout>

#include <algorithm>
#include <cmath>

namespace burin {

class LayerPanel::Fields : public QObject {
public:
    explicit Fields(LayerPanel* panel);
    void refresh();

    LayerState state;
    LengthUnit unit = LengthUnit::millimetre;
    LayerFields* layer;

private:
    void addButtons(LayerPanel* panel, QVBoxLayout* column);
    void addLayer();
    void move(int by);
    void change(std::vector<MaterialRegion> layers, int chosen);
    std::vector<ListRow> layerRows() const;
    std::vector<ListRow> amountRows() const;
    QString planesText(const MaterialRegion& region) const;
    QString gradingText() const;
    int chosen() const;

    LayerPanel* panel_;
    RowList *layers_, *amounts_;
    QToolButton *add_, *remove_, *earlier_, *later_;
    QLabel* empty_;
    Notice *problem_, *grading_, *nothing_;
};

LayerPanel::Fields::Fields(LayerPanel* panel) : QObject(panel), panel_(panel) {
    QVBoxLayout* column = makePanelLayout(panel);
    column->addWidget(makeSectionTitle(LayerPanel::tr("Layers of the stock"), panel));
    layers_ = new RowList(panel);
    layers_->setObjectName(QStringLiteral("layerList"));
    layers_->setAccessibleName(LayerPanel::tr("Layers of the stock"));
    column->addWidget(layers_);
    addButtons(panel, column);
    layer = new LayerFields(panel);
    column->addWidget(layer);
    problem_ = new Notice(panel);
    problem_->setObjectName(QStringLiteral("layerProblem"));
    column->addWidget(problem_);
    grading_ = new Notice(panel);
    grading_->setObjectName(QStringLiteral("gradingNotice"));
    column->addWidget(grading_);
    column->addWidget(makeSectionTitle(LayerPanel::tr("What the stock holds"), panel));
    empty_ = makeWrappedLabel(panel);
    empty_->setProperty("look", "quiet");
    column->addWidget(empty_);
    amounts_ = new RowList(panel);
    amounts_->setObjectName(QStringLiteral("amountList"));
    amounts_->setAccessibleName(LayerPanel::tr("What the stock holds"));
    amounts_->setMaximumRows(10);
    column->addWidget(amounts_);
    nothing_ = new Notice(panel);
    nothing_->setObjectName(QStringLiteral("freeCarvingNotice"));
    column->addWidget(nothing_);
    column->addStretch(1);

    connect(layers_, &RowList::rowChosen, this, [this] { refresh(); });
    connect(layer, &LayerFields::edited, this, [this](const MaterialRegion& region) {
        std::vector<MaterialRegion> changed = state.layers;
        if (chosen() < 0) return;
        changed[static_cast<std::size_t>(chosen())] = region;
        change(std::move(changed), chosen());
    });
}

void LayerPanel::Fields::addButtons(LayerPanel* panel, QVBoxLayout* column) {
    add_ = makeIconButton(QStringLiteral("add"), LayerPanel::tr("New layer"), QStringLiteral("addLayer"), panel);
    remove_ = makeIconButton(QStringLiteral("remove"), LayerPanel::tr("Delete the layer"),
                             QStringLiteral("removeLayer"), panel);
    earlier_ = makeIconButton(QStringLiteral("previous"), LayerPanel::tr("Let the one before have the place"),
                              QStringLiteral("earlierLayer"), panel);
    later_ = makeIconButton(QStringLiteral("next"), LayerPanel::tr("Let it have the place before the next"),
                            QStringLiteral("laterLayer"), panel);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    for (QToolButton* button : {add_, remove_, earlier_, later_}) row->addWidget(button);
    row->addStretch(1);
    column->addLayout(row);
    connect(add_, &QToolButton::clicked, this, [this] { addLayer(); });
    connect(remove_, &QToolButton::clicked, this, [this] {
        std::vector<MaterialRegion> layers = state.layers;
        layers.erase(layers.begin() + chosen());
        change(std::move(layers), std::max(0, chosen() - 1));
    });
    connect(earlier_, &QToolButton::clicked, this, [this] { move(-1); });
    connect(later_, &QToolButton::clicked, this, [this] { move(1); });
}

int LayerPanel::Fields::chosen() const {
    const int count = static_cast<int>(state.layers.size());
    return count == 0 ? -1 : std::clamp(layers_->currentRow(), 0, count - 1);
}

void LayerPanel::Fields::change(std::vector<MaterialRegion> layers, int chosen) {
    state.layers = std::move(layers);
    refresh();
    layers_->setChosen(state.layers.empty() ? -1 : chosen);
    refresh();
    emit panel_->layersEdited(state.layers);
}

/// Adds a layer for the upper half of the stock, of the first material, as a starting point.
void LayerPanel::Fields::addLayer() {
    MaterialRegion region;
    const auto taken = [&](const std::string& name) {
        return std::ranges::find(state.layers, name, &MaterialRegion::name) != state.layers.end();
    };
    for (int number = 1; region.name.empty() || taken(region.name); ++number)
        region.name = LayerPanel::tr("Layer %1").arg(number).toStdString();
    region.material = state.materials.front().id;
    region.from = std::round(state.stock.centre().z * 1e3) / 1e3;
    std::vector<MaterialRegion> layers = state.layers;
    layers.push_back(region);
    const int last = static_cast<int>(layers.size()) - 1;
    change(std::move(layers), last);
}

void LayerPanel::Fields::move(int by) {
    const int from = chosen(), to = from + by;
    std::vector<MaterialRegion> layers = state.layers;
    std::swap(layers[static_cast<std::size_t>(from)], layers[static_cast<std::size_t>(to)]);
    change(std::move(layers), to);
}

QString LayerPanel::Fields::planesText(const MaterialRegion& region) const {
    const auto plane = [&](double at) { return std::isfinite(at) ? lengthText(at, unit) : QStringLiteral("…"); };
    return axisLetter(region.axis) + QLatin1Char(' ') +
           LayerPanel::tr("%1 to %2").arg(plane(region.from), plane(region.to));
}

std::vector<ListRow> LayerPanel::Fields::layerRows() const {
    std::vector<ListRow> rows;
    for (const MaterialRegion& region : state.layers) {
        ListRow row;
        row.title = row.toolTip = QString::fromStdString(region.name);
        const auto material = std::ranges::find(state.materials, region.material, &Property::id);
        row.detail = planesText(region);
        if (material != state.materials.end()) {
            row.value = materialName(*material);
            row.swatch = QColor(material->colour[0], material->colour[1], material->colour[2]);
        }
        if (region.grade) row.badge = LayerPanel::tr("graded");
        rows.push_back(row);
    }
    return rows;
}

std::vector<ListRow> LayerPanel::Fields::amountRows() const {
    std::vector<ListRow> rows;
    for (const MaterialAmount& amount : state.amounts) {
        if (!(amount.volume > 0.0)) continue;
        ListRow row;
        Property named;
        named.id = amount.id;
        named.name = amount.name;
        row.title = row.toolTip = materialName(named);
        row.value = volumeText(amount.volume, unit);
        row.detail = amount.mass ? LayerPanel::tr("%1\u00a0g").arg(QLocale().toString(*amount.mass, 'f', 1))
                                 : LayerPanel::tr("mass not known: the material has no density");
        if (amount.isProtected) row.badge = LayerPanel::tr("protected");
        rows.push_back(row);
    }
    return rows;
}

/// The maximum error of a value at any position.
QString LayerPanel::Fields::gradingText() const {
    if (chosen() < 0) return {};
    const std::string& name = state.layers[static_cast<std::size_t>(chosen())].name;
    const auto grading = std::ranges::find(state.gradings, name, &RegionGrading::region);
    if (grading == state.gradings.end()) return {};
    const auto number = [](double value) { return QLocale().toString(value, 'g', 4); };
    return LayerPanel::tr("%1 from %2 to %3 %5 in %n bands: each place is within %4 %5.", nullptr, grading->bands)
        .arg(valueNameText(grading->value), number(grading->low), number(grading->high), number(grading->error),
             prettyUnit(grading->unit));
}

void LayerPanel::Fields::refresh() {
    layers_->setRows(layerRows());
    if (layers_->currentRow() < 0 && !state.layers.empty()) layers_->setChosen(0);
    const int place = chosen(), last = static_cast<int>(state.layers.size()) - 1;
    layers_->setVisible(place >= 0);
    const QString locked =
        state.locked ? LayerPanel::tr("Stock and material can't be changed once there are takes.") : QString();
    const QString none = LayerPanel::tr("There is no layer.");
    enableUnless(add_, state.stock.empty() || state.materials.empty() ? LayerPanel::tr("Import a part first.") : locked,
                 LayerPanel::tr("New layer"));
    enableUnless(remove_, place < 0 ? none : locked, LayerPanel::tr("Delete the layer"));
    enableUnless(earlier_, place <= 0 ? LayerPanel::tr("No layer comes before it.") : locked,
                 LayerPanel::tr("Let the one before have the place"));
    enableUnless(later_, place < 0 || place == last ? LayerPanel::tr("No layer comes after it.") : locked,
                 LayerPanel::tr("Let it have the place before the next"));
    layer->setVisible(place >= 0);
    if (place >= 0)
        layer->showLayer(state.layers[static_cast<std::size_t>(place)], state.materials, state.stock, state.locked);
    problem_->tell(Notice::Kind::error, place >= 0 ? state.problem : QString());
    grading_->tell(Notice::Kind::information, gradingText());
    amounts_->setRows(amountRows());
    amounts_->setVisible(!state.amounts.empty());
    setWrappedText(empty_, state.amounts.empty()
                               ? LayerPanel::tr("Embed the part: then each material is listed with volume and mass.")
                               : QString());
    empty_->setVisible(state.amounts.empty());
    nothing_->tell(Notice::Kind::warning,
                   state.nothingPushesBack
                       ? LayerPanel::tr("Free carving: there is no part, so nothing pushes the tool back.")
                       : QString());
}

LayerPanel::LayerPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("layerPanel"));
    fields_->refresh();
}

void LayerPanel::setUnit(LengthUnit unit) {
    fields_->unit = unit;
    fields_->layer->setUnit(unit);
    fields_->refresh();
}

void LayerPanel::setState(const LayerState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin
