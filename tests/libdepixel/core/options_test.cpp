#include "libdepixel/core/options.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace depixel {
namespace {

const OptionInfo& find_option(std::string_view name) {
  for (const OptionInfo& info : option_table()) {
    if (info.name == name) return info;
  }
  ADD_FAILURE() << "no option " << name;
  return option_table().front();
}

TEST(Options, NamesAreUniqueAndFitACommandLine) {
  std::set<std::string_view> names;
  for (const OptionInfo& info : option_table()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(info.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos)
        << info.name;
    EXPECT_FALSE(info.help.empty()) << info.name;
    EXPECT_NE(info.help.back(), '.') << info.name;
  }
}

TEST(Options, EveryChoiceCanBeSetAndReadBack) {
  for (const OptionInfo& info : option_table()) {
    const auto* choice = std::get_if<ChoiceOption>(&info.kind);
    if (choice == nullptr) continue;
    for (int value = 0; value < static_cast<int>(choice->names.size()); ++value) {
      Options options;
      choice->set(options, value);
      EXPECT_EQ(choice->get(options), value) << info.name << ' ' << choice->names[value];
    }
  }
}

TEST(Options, ChoiceNamesMatchTheirEnumerators) {
  Options options;
  const auto set = [&](std::string_view option, std::string_view name) {
    const auto& choice = std::get<ChoiceOption>(find_option(option).kind);
    for (std::size_t i = 0; i < choice.names.size(); ++i) {
      if (choice.names[i] == name) choice.set(options, static_cast<int>(i));
    }
  };
  set("similarity", "merge");
  EXPECT_EQ(options.similarity, Similarity::merge);
  set("dither", "blend");
  EXPECT_EQ(options.dither, DitherKind::blend);
  set("spline", "interpolate");
  EXPECT_EQ(options.spline, SplineKind::interpolate);
  set("spline", "approximate");
  EXPECT_EQ(options.spline, SplineKind::approximate);
  set("smoothing", "none");
  EXPECT_EQ(options.smoothing, Smoothing::none);
  set("smoothing", "average");
  EXPECT_EQ(options.smoothing, Smoothing::average);
  set("corners", "round");
  EXPECT_EQ(options.corners, Corners::round);
}

TEST(Options, DefaultsLieWithinTheirRanges) {
  const Options options;
  for (const OptionInfo& info : option_table()) {
    if (const auto* number = std::get_if<NumberOption>(&info.kind)) {
      EXPECT_LE(number->minimum, options.*number->value) << info.name;
      EXPECT_GE(number->maximum, options.*number->value) << info.name;
    }
    if (const auto* count = std::get_if<CountOption>(&info.kind)) {
      EXPECT_LE(count->minimum, options.*count->value) << info.name;
      EXPECT_GE(count->maximum, options.*count->value) << info.name;
    }
  }
}

TEST(Options, VotesDefaultToTheThesis) {
  const Options options;
  EXPECT_EQ(options.curve_weight, 1);
  EXPECT_EQ(options.sparse_weight, 1);
  EXPECT_EQ(options.island_weight, 5);
  EXPECT_EQ(options.similarity, Similarity::exact);
  EXPECT_FALSE(options.connect_lines);
}

TEST(Options, EveryFieldHasARow) {
  // Changing each setting through the table must give different Options.
  std::size_t changed = 0;
  for (const OptionInfo& info : option_table()) {
    Options options;
    if (const auto* choice = std::get_if<ChoiceOption>(&info.kind)) {
      choice->set(options, (choice->get(options) + 1) % static_cast<int>(choice->names.size()));
    }
    if (const auto* flag = std::get_if<SwitchOption>(&info.kind))
      options.*flag->value = !(options.*flag->value);
    if (const auto* number = std::get_if<NumberOption>(&info.kind)) options.*number->value += 0.5;
    if (const auto* count = std::get_if<CountOption>(&info.kind)) options.*count->value += 1;
    if (!(options == Options{})) ++changed;
  }
  EXPECT_EQ(changed, option_table().size());
  EXPECT_EQ(changed, 17u);
}

}  // namespace
}  // namespace depixel
