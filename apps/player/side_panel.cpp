#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "apps/player/panels.hpp"
#include "apps/player/theme.hpp"

namespace depixel {
namespace {

constexpr float kLabelColumn = 118;

/// A label on the left, and room for a widget on its right.
void label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(kLabelColumn);
  ImGui::SetNextItemWidth(-1);
}

void show_help_of(std::string_view help) {
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%.*s.", static_cast<int>(help.size()), help.data());
}

/// A widget for a choice among names. \return the new choice.
int combo(const char* id, int chosen, std::span<const std::string_view> names) {
  if (ImGui::BeginCombo(id, std::string(names[static_cast<std::size_t>(chosen)]).c_str())) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (ImGui::Selectable(std::string(names[i]).c_str(), static_cast<int>(i) == chosen)) {
        chosen = static_cast<int>(i);
      }
    }
    ImGui::EndCombo();
  }
  return chosen;
}

void show_look(Player& player) {
  static constexpr std::array<std::string_view, 3> kAspects{"square", "8:7", "4:3 picture"};
  static constexpr std::array<std::string_view, 2> kRaw{"nearest", "bilinear"};
  LookSettings& look = player.settings.look;
  label("View");
  std::vector<std::string_view> views{"vector picture"};
  views.insert(views.end(), stage_view_names().begin(), stage_view_names().end());
  const int shown = player.stage ? 1 + static_cast<int>(*player.stage) : 0;
  const int chosen = combo("##view", shown, views);
  if (chosen != shown)
    player.stage = chosen == 0 ? std::nullopt : std::optional(static_cast<StageView>(chosen - 1));
  label("Pixels");
  const int aspect = static_cast<int>(look.aspect);
  if (const int now = combo("##aspect", aspect, kAspects); now != aspect) {
    player.set_aspect(static_cast<PixelAspect>(now));
  }
  label("Scale");
  const PixelRect all = player.view.placement();
  const std::string scale =
      all.empty() ? "none"
                  : fmt::format("{:.2f}x{}", player.view.scale(), player.view.is_fitted() ? ", fitted" : "");
  if (ImGui::Button(scale.c_str(), ImVec2(-1, 0))) player.view.fit();
  show_help_of("Click to show the whole picture; the wheel zooms, dragging moves");
  bool whole = look.whole_scales;
  if (ImGui::Checkbox("Whole scales only", &whole)) player.set_whole_scales(whole);
  ImGui::Checkbox("Outline under the pointer", &look.outline);
  ImGui::Checkbox("Split, raw frame:", &look.split);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  look.raw = static_cast<RawSampling>(combo("##raw", static_cast<int>(look.raw), kRaw));
}

/// The widget of an option; there is an overload for each kind.
struct OptionWidget {
  Options& options;
  const char* id;

  void operator()(const ChoiceOption& option) const {
    option.set(options, combo(id, option.get(options), option.names));
  }
  void operator()(const SwitchOption& option) const { ImGui::Checkbox(id, &(options.*option.value)); }
  void operator()(const NumberOption& option) const {
    auto value = static_cast<float>(options.*option.value);
    // Weights of interest are small; the whole range can be typed in with Ctrl and a click.
    constexpr float kSlidTo = 20;
    if (ImGui::SliderFloat(id, &value, static_cast<float>(option.minimum),
                           std::min(kSlidTo, static_cast<float>(option.maximum)), "%.2f")) {
      options.*option.value = std::clamp(double(value), option.minimum, option.maximum);
    }
  }
  void operator()(const CountOption& option) const {
    constexpr int kSlidTo = 16;
    int value = options.*option.value;
    if (ImGui::SliderInt(id, &value, option.minimum, std::min(kSlidTo, option.maximum))) {
      options.*option.value = std::clamp(value, option.minimum, option.maximum);
    }
  }
};

void show_options(Player& player) {
  for (const OptionInfo& option : option_table()) {
    label(std::string(option.name).c_str());
    const std::string id = fmt::format("##{}", option.name);
    std::visit(OptionWidget{player.settings.options, id.c_str()}, option.kind);
    show_help_of(option.help);
  }
  if (ImGui::Button("Reset", ImVec2(-1, 0))) player.settings.options = {};
}

void row(const char* name, const std::string& value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(kLabelColumn);
  ImGui::TextUnformatted(value.c_str());
}

/// What was done for the frame, and not for those before.
void show_work(const VectorizeStats& stats) {
  row("pixels", fmt::format("{} changed of {}", stats.changed_pixels, stats.pixels));
  row("blocks", fmt::format("{} recomputed", stats.stale_corners));
  row("contours", fmt::format("{} traced", stats.contours));
  row("nodes", fmt::format("{} traced", stats.nodes));
  row("arcs", fmt::format("{} traced", stats.arcs));
  row("shapes", fmt::format("{} fitted, {} known", stats.fitted_shapes, stats.arcs - stats.fitted_shapes));
  row("tiles", fmt::format("{} changed", stats.changed_tiles));
  row("", fmt::format("{} moved", stats.moved_tiles));
}

void show_statistics(const Player& player) {
  const FrameHistory& history = player.history;
  const auto plot = history.plot();
  if (!plot.empty()) {
    constexpr float kFrameBudgetMs = 1000.0f / 60;
    ImGui::SetNextItemWidth(-1);
    ImGui::PlotHistogram("##frames", plot.data(), static_cast<int>(plot.size()), 0, nullptr, 0,
                         2 * kFrameBudgetMs, ImVec2(0, 44));
    show_help_of("Time of each frame; the middle of the graph is 1/60 s");
    row("frame", fmt::format("{:.1f} ms, {:.0f} a second", double(plot.back()), history.frames_a_second()));
  }
  if (player.frame() == nullptr) return;
  const VectorizeStats& stats = player.canvas().filter().vectorizer().stats();
  const FilterStats& filter = player.canvas().prepared();
  const auto ms = [](std::int64_t ns) { return fmt::format("{:.2f} ms", double(ns) * 1e-6); };
  for (std::size_t i = 0; i < stats.stage_ns.size(); ++i) {
    row(std::string(VectorizeStats::kStageNames[i]).c_str(), ms(stats.stage_ns[i]));
  }
  row("tiles, upload", ms(filter.prepare_ns));
  row("uploaded", fmt::format("{:.2f} MB", double(filter.upload_bytes) * 1e-6));
  if (player.stage) row("painting", ms(player.canvas().stage_paint_ns()));
  show_work(stats);
  row("segments", fmt::format("{} in the map", stats.segments));
  row("lines", fmt::format("{} in the tiles", filter.lines));
  if (player.exporter() != nullptr) {
    const FilterStats& written = player.exporter()->stats();
    row("export", fmt::format("{} pixels drawn", written.drawn_pixels));
    row("", fmt::format("{} moved", written.moved_pixels));
  }
}

}  // namespace

PixelRect area_beside_panels(const LookSettings& look, glm::ivec2 window) {
  if (!look.panels) return {0, 0, window.x, window.y};
  return {0, 0, std::max(0, window.x - static_cast<int>(kPanelWidth)),
          std::max(0, window.y - static_cast<int>(kBarHeight))};
}

void show_side_panel(Player& player) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x - kPanelWidth, 0});
  ImGui::SetNextWindowSize({kPanelWidth, std::max(1.0f, window.y - kBarHeight)});
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration & ~ImGuiWindowFlags_NoScrollbar;
  ImGui::Begin("##panel", nullptr,
               kFlags | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  if (ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen)) show_look(player);
  if (ImGui::CollapsingHeader("Options", ImGuiTreeNodeFlags_DefaultOpen)) show_options(player);
  if (ImGui::CollapsingHeader("Statistics", ImGuiTreeNodeFlags_DefaultOpen)) show_statistics(player);
  ImGui::End();
}

}  // namespace depixel
