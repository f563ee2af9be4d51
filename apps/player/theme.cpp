#include "apps/player/theme.hpp"

#include <imgui.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>

namespace depixel {
namespace {

namespace fs = std::filesystem;

/// A font that people read with ease, where the XDG base directories have it.
std::optional<std::string> find_font() {
  const char* variable = std::getenv("XDG_DATA_DIRS");
  const bool is_set = variable != nullptr && *variable != '\0';
  std::istringstream folders(is_set ? variable : "/usr/local/share:/usr/share");
  for (std::string folder; std::getline(folders, folder, ':');) {
    for (const char* name : {"dejavu/DejaVuSans.ttf", "noto/NotoSans-Regular.ttf"}) {
      const fs::path font = fs::path(folder) / "fonts" / "truetype" / name;
      std::error_code ignored;
      if (fs::is_regular_file(font, ignored)) return font.string();
    }
  }
  return std::nullopt;
}

void set_font(float pixel_ratio) {
  ImGuiIO& io = ImGui::GetIO();
  io.FontGlobalScale = 1 / pixel_ratio;
  if (const auto font = find_font()) {
    io.Fonts->AddFontFromFileTTF(font->c_str(), kFontSize * pixel_ratio);
  } else {
    io.Fonts->AddFontDefault();
  }
}

ImVec4 grey(float level, float alpha = 1) {
  return {level, level, level * 1.06f, alpha};
}

void set_colours(ImGuiStyle& style) {
  const ImVec4 accent{0.36f, 0.60f, 0.86f, 1.0f}, dim_accent{0.25f, 0.42f, 0.62f, 1.0f};
  ImGui::StyleColorsDark(&style);
  const struct {
    ImGuiCol index;
    ImVec4 colour;
  } table[] = {
      {ImGuiCol_Text, grey(0.88f)},
      {ImGuiCol_TextDisabled, grey(0.56f)},
      {ImGuiCol_WindowBg, grey(0.125f)},
      {ImGuiCol_PopupBg, grey(0.10f, 0.97f)},
      {ImGuiCol_Border, grey(0.24f)},
      {ImGuiCol_FrameBg, grey(0.19f)},
      {ImGuiCol_FrameBgHovered, grey(0.25f)},
      {ImGuiCol_FrameBgActive, grey(0.29f)},
      {ImGuiCol_TitleBg, grey(0.10f)},
      {ImGuiCol_TitleBgActive, grey(0.16f)},
      {ImGuiCol_Button, grey(0.22f)},
      {ImGuiCol_ButtonHovered, grey(0.30f)},
      {ImGuiCol_ButtonActive, dim_accent},
      {ImGuiCol_Header, grey(0.19f)},
      {ImGuiCol_HeaderHovered, grey(0.26f)},
      {ImGuiCol_HeaderActive, dim_accent},
      {ImGuiCol_CheckMark, accent},
      {ImGuiCol_SliderGrab, dim_accent},
      {ImGuiCol_SliderGrabActive, accent},
      {ImGuiCol_PlotHistogram, dim_accent},
      {ImGuiCol_PlotHistogramHovered, accent},
      {ImGuiCol_PlotLines, accent},
      {ImGuiCol_ModalWindowDimBg, grey(0.0f, 0.45f)},
  };
  for (const auto& [index, colour] : table) style.Colors[index] = colour;
}

}  // namespace

void set_up_theme(float pixel_ratio) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing but the player's own settings is remembered
  set_font(pixel_ratio);
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 4;
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.PopupRounding = 4;
  style.WindowBorderSize = 1;
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ScrollbarSize = 12;
  set_colours(style);
}

}  // namespace depixel
