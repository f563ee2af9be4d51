#include "apps/player/pointer.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {
namespace {

constexpr double kGrabPx = 6;
constexpr ImU32 kOutlineColour = IM_COL32(255, 210, 60, 255), kDividerColour = IM_COL32(240, 240, 245, 200);

double divider_position(const Player& player) {
  const PixelRect visible = player.view.visible();
  return split_parts(visible, player.settings.look.divider).right.x;
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
  const PixelRect all = player.view.placement();
  const View view = player.view.view_of(all);
  const auto on_screen = [&](glm::ivec2 p) {
    const glm::dvec2 output = glm::dvec2(all.x, all.y) +
                              glm::dvec2(p) / double(kSubpixels) * glm::dvec2(view.scale_x, view.scale_y);
    return ImVec2(static_cast<float>(output.x / pixel_ratio), static_cast<float>(output.y / pixel_ratio));
  };
  const auto unit = [&](int pixels) { return static_cast<float>(pixels / pixel_ratio); };
  ImDrawList* lines = ImGui::GetBackgroundDrawList();
  lines->PushClipRect({unit(visible.x), unit(visible.y)},
                      {unit(visible.x + visible.width), unit(visible.y + visible.height)});
  for (const OutlineLoop& loop : player.components().loops(found->index)) {
    const auto pieces = player.components().pieces(loop);
    lines->PathLineTo(on_screen(pieces.back().p3));
    for (const OutlinePiece& piece : pieces) {
      lines->PathBezierCubicCurveTo(on_screen(piece.p1), on_screen(piece.p2), on_screen(piece.p3), 6);
    }
    lines->PathStroke(kOutlineColour, 0, 2);
  }
  lines->PopClipRect();
  const Rgba c = found->colour;
  const std::string alpha = c.a == 255 ? "" : fmt::format(", alpha {}", c.a);
  ImGui::BeginTooltip();
  ImGui::ColorButton("##colour", ImVec4(c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, c.a / 255.0f),
                     ImGuiColorEditFlags_AlphaPreview, {16, 16});
  ImGui::SameLine();
  ImGui::TextUnformatted(fmt::format("#{:02x}{:02x}{:02x}{}\n{} pixel{}", c.r, c.g, c.b, alpha,
                                     found->size_px, found->size_px == 1 ? "" : "s")
                             .c_str());
  ImGui::EndTooltip();
}

}  // namespace depixel
