#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "apps/common/inputs.hpp"
#include "apps/common/natural_order.hpp"
#include "apps/player/key_bindings.hpp"
#include "apps/player/panels.hpp"

namespace depixel {
namespace {

namespace fs = std::filesystem;

constexpr auto kDialogFlags =
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize;

/// Room for the picture, beside the panels.
ImVec2 free_room(const Player& player) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const PixelRect room =
      area_beside_panels(player.settings.look, {static_cast<int>(window.x), static_cast<int>(window.y)});
  return {static_cast<float>(room.width), static_cast<float>(room.height)};
}

void centre_next_window() {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
}

void show_help(Player& player) {
  centre_next_window();
  ImGui::Begin("Keys", &player.shows_help, kDialogFlags);
  const auto bindings = key_bindings();
  constexpr int kColumns = 2;
  if (ImGui::BeginTable("##keys", 2 * kColumns)) {
    // A row for each thing to do; keys that do the same share it.
    std::vector<std::pair<std::string, std::string>> rows;
    for (const KeyBinding& binding : bindings) {
      if (binding.help.empty()) {
        rows.back().first += fmt::format(", {}", binding.name);
      } else {
        rows.emplace_back(binding.name, binding.help);
      }
    }
    const std::size_t half = (rows.size() + kColumns - 1) / kColumns;
    for (std::size_t i = 0; i < half; ++i) {
      ImGui::TableNextRow();
      for (std::size_t j = i; j < rows.size(); j += half) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(rows[j].first.c_str());
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s   ", rows[j].second.c_str());
      }
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

/// Opens something and closes the dialogue, or says why not.
void open_path(Player& player, const fs::path& path) {
  const auto opened = player.open({path.string()});
  if (!opened) {
    player.say(opened.error().message);
    return;
  }
  player.shows_open = false;
}

void show_open(Player& player) {
  const ImVec2 list_size{480, 300};
  centre_next_window();
  ImGui::Begin("Open", &player.shows_open, kDialogFlags);
  std::error_code ignored;
  std::string& folder = player.settings.last_folder;
  if (folder.empty()) folder = fs::current_path(ignored).string();
  ImGui::TextUnformatted(folder.c_str());
  std::vector<fs::path> folders;
  for (const auto& entry :
       fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, ignored)) {
    const bool is_hidden = entry.path().filename().string().starts_with('.');
    if (!is_hidden && entry.is_directory(ignored)) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end(),
            [](const fs::path& a, const fs::path& b) { return naturally_before(a.string(), b.string()); });
  std::optional<fs::path> entered;
  ImGui::BeginChild("##list", list_size, true);
  if (ImGui::Selectable("..")) entered = fs::path(folder).parent_path();
  for (const fs::path& path : folders) {
    if (ImGui::Selectable((path.filename().string() + "/").c_str())) entered = path;
  }
  if (const auto pictures = find_inputs({folder}); pictures) {
    for (const fs::path& path : pictures->files) {
      if (ImGui::Selectable(path.filename().c_str())) open_path(player, path);
    }
  }
  ImGui::EndChild();
  if (ImGui::Button("Play the whole folder")) open_path(player, fs::path(folder));
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) player.shows_open = false;
  if (entered) folder = entered->string();
  ImGui::End();
}

void show_progress(Player& player) {
  const Exporter& exporter = *player.exporter();
  centre_next_window();
  ImGui::Begin("Writing pictures", nullptr, kDialogFlags);
  ImGui::Text("to %s", exporter.folder().c_str());
  const auto count = player.extent().count;
  const float part = count && *count > 0 ? float(exporter.written()) / float(*count) : 0;
  ImGui::ProgressBar(
      part, {360, 0},
      fmt::format("{}{}", exporter.written(), count ? fmt::format(" of {}", *count) : "").c_str());
  const bool cancelled = ImGui::Button("Stop");
  ImGui::End();
  if (cancelled) player.cancel_export();
}

/// A line over the picture.
void show_line(const Player& player, const std::string& text, float from_top) {
  constexpr float kMargin = 40;
  const float text_width = ImGui::CalcTextSize(text.c_str()).x;
  const ImVec2 room = free_room(player);
  ImGui::SetNextWindowPos({room.x / 2, room.y * from_top}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin(text.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushTextWrapPos(std::min(text_width + kMargin / 2, std::max(1.0f, room.x - kMargin)));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

}  // namespace

void show_dialogs(Player& player) {
  if (!player.has_clip() && !player.shows_open) {
    show_line(player,
              "Drop pictures, a folder, a GIF or a Y4M file here, or press o to open. Press ? for all keys.",
              0.45f);
  }
  if (player.shows_help) show_help(player);
  if (player.shows_open) show_open(player);
  if (player.exporter() != nullptr) show_progress(player);
  if (!player.message().empty()) show_line(player, player.message(), 0.08f);
}

}  // namespace depixel
