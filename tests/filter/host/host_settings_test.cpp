#include "filter/host/host_settings.hpp"

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace depixel::test {
namespace {

struct Read {
  HostSettings settings;
  std::vector<std::string> warnings;
};

Read read(const std::map<std::string, std::string>& preset) {
  Read result;
  const auto text_of = [&](const std::string& key) -> std::optional<std::string> {
    const auto found = preset.find(key);
    return found == preset.end() ? std::nullopt : std::optional(found->second);
  };
  result.settings = read_host_settings(text_of, [&](const std::string& w) { result.warnings.push_back(w); });
  return result;
}

TEST(HostSettings, AreTheDefaultsWhereNothingIsSaid) {
  const Read result = read({});
  EXPECT_EQ(result.settings.scale, 4);
  EXPECT_EQ(result.settings.backend, HostBackend::automatic);
  EXPECT_EQ(result.settings.options, Options{});
  EXPECT_TRUE(result.warnings.empty());
}

TEST(HostSettings, AreWhatThePresetSays) {
  const Read result = read({{"scale", "3.5"},
                            {"backend", "gl"},
                            {"similarity", "merge"},
                            {"connect_lines", "true"},
                            {"island_weight", "2.5"},
                            {"threads", "3"}});
  EXPECT_EQ(result.settings.scale, 3.5);
  EXPECT_EQ(result.settings.backend, HostBackend::gl);
  EXPECT_EQ(result.settings.options.similarity, Similarity::merge);
  EXPECT_TRUE(result.settings.options.connect_lines);
  EXPECT_EQ(result.settings.options.island_weight, 2.5);
  EXPECT_EQ(result.settings.options.threads, 3);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(HostSettings, ThatMakeNoSenseAreWarnedOfOnceEach) {
  for (const auto& [key, text] :
       std::vector<std::pair<std::string, std::string>>{{"scale", "0.5"},
                                                        {"scale", "17"},
                                                        {"scale", "nan"},
                                                        {"scale", "4x"},
                                                        {"backend", "vulkan"},
                                                        {"similarity", "MERGE"},
                                                        {"connect_lines", "yes"},
                                                        {"curve_weight", "-1"},
                                                        {"threads", "1.5"},
                                                        {"threads", "99999999999"}}) {
    const Read result = read({{key, text}});
    ASSERT_EQ(result.warnings.size(), 1U) << key << " = " << text;
    EXPECT_TRUE(result.warnings[0].starts_with("The setting " + key + " stays ")) << result.warnings[0];
    EXPECT_NE(result.warnings[0].find("\"" + text + "\""), std::string::npos) << result.warnings[0];
    EXPECT_EQ(result.settings.scale, 4);
    EXPECT_EQ(result.settings.options, Options{});
  }
}

}  // namespace
}  // namespace depixel::test
