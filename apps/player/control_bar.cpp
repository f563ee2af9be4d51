#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "apps/player/panels.hpp"
#include "apps/player/theme.hpp"

namespace depixel {
namespace {

constexpr float kSpeedWidth = 84;

void show_buttons(Player& player) {
  if (ImGui::Button("|<")) player.seek(0);
  ImGui::SameLine(0, 3);
  if (ImGui::Button("<")) player.step(-1);
  ImGui::SameLine(0, 3);
  if (ImGui::Button(player.playback().is_playing() ? "Pause" : "Play", ImVec2(62, 0)))
    player.toggle_playing();
  ImGui::SameLine(0, 3);
  if (ImGui::Button(">")) player.step(1);
}

void show_seek_bar(Player& player, float width) {
  const Playback::Extent extent = player.extent();
  int number = player.playback().index() + 1;  // people count from one
  const std::string format = !player.has_clip() ? "nothing open"
                             : extent.count     ? fmt::format("%d of {}", *extent.count)
                                                : fmt::format("%d, {} have come", extent.arrived);
  ImGui::SetNextItemWidth(width);
  const int last = std::max(extent.first, extent.arrived - 1);
  if (ImGui::SliderInt("##seek", &number, extent.first + 1, last + 1, format.c_str(),
                       ImGuiSliderFlags_NoInput)) {
    player.seek(number - 1);
  }
}

}  // namespace

void show_control_bar(Player& player) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float width = window.x;
  ImGui::SetNextWindowPos({0, window.y - kBarHeight});
  ImGui::SetNextWindowSize({width, kBarHeight});
  ImGui::Begin("##bar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::SetCursorPosY(13);
  ImGui::BeginDisabled(!player.has_clip());
  show_buttons(player);
  ImGui::SameLine();
  const float left = ImGui::GetCursorPosX(), right_part = kSpeedWidth + 150;
  show_seek_bar(player, std::max(60.0f, width - left - right_part));
  ImGui::EndDisabled();
  ImGui::SameLine();
  auto speed = static_cast<float>(player.playback().speed());
  ImGui::SetNextItemWidth(kSpeedWidth);
  if (ImGui::SliderFloat("##speed", &speed, float(Playback::kMinSpeed), float(Playback::kMaxSpeed), "%.2fx",
                         ImGuiSliderFlags_Logarithmic)) {
    player.set_speed(speed);
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Speed");
  ImGui::SameLine();
  bool loops = player.playback().loops();
  if (ImGui::Checkbox("Loop", &loops)) player.set_loop(loops);
  ImGui::SameLine();
  if (ImGui::Button("?")) player.shows_help = !player.shows_help;
  ImGui::End();
}

}  // namespace depixel
