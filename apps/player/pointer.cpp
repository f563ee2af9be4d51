#include "apps/player/pointer.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {
namespace {

constexpr double kGrabPx = 6;
constexpr ImU32 kOutlineColour = IM_COL32(255, 210, 60, 255), kDividerColour = IM_COL32(240, 240, 245, 200);

double divider_position(const Player& player) {
  const PixelRect visible = player.view.visible();
  return split_parts(visible, player.settings.look.divider).right.x;
}

/// Draws loops upon the picture, as far as they are visible.
class OutlinePen {
 public:
  OutlinePen(const ViewControl& control, double pixel_ratio)
      : all_(control.placement()), view_(control.view_of(all_)), pixel_ratio_(pixel_ratio) {
    const PixelRect visible = control.visible();
    low_ = in_units({visible.x, visible.y});
    high_ = in_units({visible.x + visible.width, visible.y + visible.height});
    // Between its ends a piece bends by a part of a source pixel; lines must grow as the root of the scale.
    lines_ = std::clamp(static_cast<int>(std::ceil(std::sqrt(view_.scale_y))), 1, kMostLines);
  }

  void draw(std::span<const OutlinePiece> loop) {
    list_.PushClipRect(low_, high_);
    ImVec2 from = on_screen(loop.back().p3);
    int pieces = 0;
    for (const OutlinePiece& piece : loop) {
      const ImVec2 p1 = on_screen(piece.p1), p2 = on_screen(piece.p2), p3 = on_screen(piece.p3);
      const bool is_drawn = is_visible({from, p1, p2, p3});
      if (pieces > 0 && (!is_drawn || pieces == kPiecesAStroke)) {
        stroke();
        pieces = 0;
      }
      if (is_drawn) {
        if (pieces++ == 0) list_.PathLineTo(from);
        list_.PathBezierCubicCurveTo(p1, p2, p3, lines_);
      }
      from = p3;
    }
    if (pieces > 0) stroke();
    list_.PopClipRect();
  }

 private:
  static constexpr int kMostLines = 16;
  /// ImGui counts the points of a stroke with 16 bits: at most four times as many as there are lines.
  static constexpr int kPiecesAStroke = 65536 / 4 / kMostLines / 2;
  static constexpr float kWidth = 2;

  void stroke() { list_.PathStroke(kOutlineColour, 0, kWidth); }

  ImVec2 in_units(glm::dvec2 pixels) const {
    return {static_cast<float>(pixels.x / pixel_ratio_), static_cast<float>(pixels.y / pixel_ratio_)};
  }
  ImVec2 on_screen(glm::ivec2 subpixels) const {
    return in_units(glm::dvec2(all_.x, all_.y) +
                    glm::dvec2(subpixels) / double(kSubpixels) * glm::dvec2(view_.scale_x, view_.scale_y));
  }
  bool is_visible(std::initializer_list<ImVec2> points) const {
    ImVec2 low = *points.begin(), high = low;
    for (const ImVec2& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return low.x - kWidth < high_.x && high.x + kWidth > low_.x && low.y - kWidth < high_.y &&
           high.y + kWidth > low_.y;
  }

  PixelRect all_;
  View view_;
  double pixel_ratio_;
  ImVec2 low_, high_;
  int lines_;
  ImDrawList& list_ = *ImGui::GetBackgroundDrawList();
};

void draw_outlines(const Player& player, int component, double pixel_ratio) {
  OutlinePen pen(player.view, pixel_ratio);
  for (const OutlineLoop& loop : player.components().loops(component)) {
    pen.draw(player.components().pieces(loop));
  }
}

void show_tooltip(const FoundComponent& found) {
  const Rgba c = found.colour;
  const std::string alpha = c.a == 255 ? "" : fmt::format(", alpha {}", c.a);
  ImGui::BeginTooltip();
  ImGui::ColorButton("##colour", ImVec4(c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, c.a / 255.0f),
                     ImGuiColorEditFlags_AlphaPreview, {16, 16});
  ImGui::SameLine();
  ImGui::TextUnformatted(fmt::format("#{:02x}{:02x}{:02x}{}\n{} pixel{}", c.r, c.g, c.b, alpha, found.size_px,
                                     found.size_px == 1 ? "" : "s")
                             .c_str());
  ImGui::EndTooltip();
}

}  // namespace

bool Pointer::is_at_divider(const Player& player, glm::dvec2 position) const {
  const PixelRect visible = player.view.visible();
  return player.settings.look.split && !visible.empty() && position.y >= visible.y &&
         position.y < visible.y + visible.height &&
         std::abs(position.x - divider_position(player)) <= kGrabPx;
}

void Pointer::handle(Player& player, double pixel_ratio) {
  if (player.frame() == nullptr) return;
  const ImGuiIO& io = ImGui::GetIO();
  const glm::dvec2 position(io.MousePos.x * pixel_ratio, io.MousePos.y * pixel_ratio);
  const PixelRect visible = player.view.visible();
  if (player.settings.look.split && !visible.empty()) {
    const auto x = static_cast<float>(divider_position(player) / pixel_ratio);
    ImGui::GetBackgroundDrawList()->AddLine(
        {x, static_cast<float>(visible.y / pixel_ratio)},
        {x, static_cast<float>((visible.y + visible.height) / pixel_ratio)}, kDividerColour, 2);
  }
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) drag_ = Drag::none;
  if (drag_ == Drag::divider && visible.width > 0) {
    player.settings.look.divider = std::clamp((position.x - visible.x) / visible.width, 0.0, 1.0);
  } else if (drag_ == Drag::picture) {
    player.view.pan(glm::dvec2(io.MouseDelta.x, io.MouseDelta.y) * pixel_ratio);
  }
  if (io.WantCaptureMouse) return;
  constexpr double kWheelStep = 1.15;
  if (io.MouseWheel != 0) player.view.zoom_about(position, std::pow(kWheelStep, double(io.MouseWheel)));
  if (is_at_divider(player, position)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    drag_ = is_at_divider(player, position) ? Drag::divider : Drag::picture;
  }
  if (drag_ == Drag::none && player.settings.look.outline) show_component(player, position, pixel_ratio);
}

void Pointer::show_component(Player& player, glm::dvec2 position, double pixel_ratio) const {
  const PixelRect visible = player.view.visible();
  if (position.x < visible.x || position.y < visible.y || position.x >= visible.x + visible.width ||
      position.y >= visible.y + visible.height) {
    return;
  }
  const auto found = player.component_at(player.view.source_at(position));
  if (!found) return;
  draw_outlines(player, found->index, pixel_ratio);
  show_tooltip(*found);
}

}  // namespace depixel
