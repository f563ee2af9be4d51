#include "tests/retroarch/play.hpp"

namespace depixel::test {

RetroArchRan play(const TemporaryFolder& folder, const std::string& script, int width, int height,
                  RetroArchRun run) {
  run.core = DEPIXEL_TEST_CORE;
  run.content = folder / "test.frames";
  run.settings.insert({{"video_fullscreen", "true"},
                       {"video_windowed_fullscreen", "true"},
                       {"aspect_ratio_index", "23"},  // the viewport that follows
                       {"custom_viewport_x", "0"},
                       {"custom_viewport_y", "0"},
                       {"custom_viewport_width", std::to_string(width)},
                       {"custom_viewport_height", std::to_string(height)}});
  write_text(run.content, script);
  return run_retroarch(run);
}

}  // namespace depixel::test
