#include "apps/player/player.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "apps/common/about_frame.hpp"
#include "apps/common/encode_png.hpp"
#include "apps/common/files.hpp"
#include "libdepixel/svg/svg_writer.hpp"

namespace depixel {
namespace {

namespace fs = std::filesystem;

/// What a clip is called in the title, and what is written of it.
std::string name_of(const std::vector<std::string>& inputs) {
  if (inputs.front() == "-") return "standard input";
  fs::path path(inputs.front());
  if (!path.has_filename()) path = path.parent_path();
  return inputs.size() == 1 ? path.filename().string()
                            : fmt::format("{} and others", path.filename().string());
}

}  // namespace

Player::Player(Settings remembered, std::unique_ptr<Canvas> canvas)
    : settings(std::move(remembered)), canvas_(std::move(canvas)) {
  playback_.set_loop(settings.play.loop);
  playback_.set_speed(settings.play.speed);
  view.set_aspect(settings.look.aspect);
  view.set_whole(settings.look.whole_scales);
}

tl::expected<void, Error> Player::open(const std::vector<std::string>& inputs) {
  auto found = find_inputs(inputs);
  if (!found) return tl::unexpected(found.error());
  auto clip = Clip::open(*found);
  if (!clip) return tl::unexpected(clip.error());
  // A clip whose first frame is damaged does not take the place of one that plays.
  if ((*clip)->frame_count() && (*clip)->has_frame(0)) {
    if (auto first = (*clip)->frame(0); !first) return tl::unexpected(first.error());
  }
  clip_ = std::move(*clip);
  clip_name_ = name_of(inputs);
  frame_.reset();
  frame_index_ = -1;
  canvas_->clear();
  playback_ = {};
  playback_.set_loop(settings.play.loop);
  playback_.set_speed(settings.play.speed);
  view.fit();
  exporter_.reset();
  failure_.reset();
  if (inputs.front() != "-") {
    std::error_code ignored;
    const fs::path path = fs::absolute(inputs.front(), ignored);
    settings.last_folder = (fs::is_directory(path, ignored) ? path : path.parent_path()).string();
  }
  take_frame();
  return {};
}

Playback::Extent Player::extent() const {
  if (!clip_) return {};
  const auto count = clip_->frame_count();
  const int first = clip_->first_frame();
  if (count) return {first, *count, count};
  int arrived = std::max(first, playback_.index());
  while (clip_->has_frame(arrived)) ++arrived;
  return {first, arrived, std::nullopt};
}

void Player::advance(double seconds) {
  message_seconds_ -= seconds;
  if (message_seconds_ < 0) message_.clear();
  if (!clip_) return;
  playback_.advance(seconds, extent(), [this](int index) { return seconds_of(index); });
  take_frame();
  if (exporter_) {
    const auto more = exporter_->write_next(*clip_);
    if (!more) {
      say(more.error().message);
      exporter_.reset();
    } else if (!*more) {
      say(fmt::format("{} pictures are in {}", exporter_->written(), exporter_->folder().string()));
      exporter_.reset();
    }
  }
}

double Player::seconds_left() const {
  constexpr double kIdle = 0.5, kPolling = 0.004;  // the latter where the next frame of a stream is late
  const double message = message_.empty() ? kIdle : message_seconds_;
  const bool is_waiting = clip_ && !frame_;
  if (is_waiting || !clip_) return std::clamp(is_waiting ? kPolling : message, kPolling, kIdle);
  const auto frame = playback_.seconds_left(extent(), [this](int index) { return seconds_of(index); });
  const bool is_late = frame && *frame <= 0;
  return is_late ? kPolling : std::clamp(std::min(message, frame.value_or(kIdle)), 0.0, kIdle);
}

double Player::seconds_of(int index) const {
  const auto frame = clip_->has_frame(index) ? clip_->frame(index) : tl::unexpected(Error{});
  return frame ? (*frame)->seconds : 1.0 / 60;
}

void Player::show_next() {
  if (!clip_) return;
  const Playback::Extent all = extent();
  const int next = frame_index_ + 1;
  playback_.seek(all.count && next >= *all.count && playback_.loops() ? all.first : next, all);
  take_frame();
}

void Player::take_frame() {
  const int index = playback_.index();
  if (index == frame_index_ || !clip_->has_frame(index)) return;
  auto frame = clip_->frame(index);
  frame_index_ = index;
  if (!frame) {
    say(frame.error().message);
    if (!damage_) damage_ = frame.error();
    playback_.pause();
    if (!frame_) failure_ = frame.error();
    return;
  }
  frame_ = std::move(*frame);
  view.set_source({frame_->picture.width(), frame_->picture.height()}, clip_->pixel_aspect().value_or(1));
  ++serial_;
}

tl::expected<void, Error> Player::vectorize() {
  if (!frame_) return {};
  auto taken = canvas_->submit(frame_->picture.view(), serial_, settings.options);
  if (!taken && !tell_difference(taken.error())) return taken;
  return {};
}

tl::expected<void, Error> Player::draw(glm::ivec2 window) {
  if (auto taken = vectorize(); !taken) return taken;  // once more: panels change options
  auto drawn = canvas_->draw(window, view, settings.look, stage);
  if (!drawn && !tell_difference(drawn.error())) return drawn;
  return {};
}

void Player::check_incremental(bool wanted) {
  is_checking_ = wanted;
  canvas_->check_incremental(wanted);
  if (exporter_) exporter_->check_incremental(wanted);
}

/// \return whether the error is one that is only told.
bool Player::tell_difference(const Error& error) {
  if (!is_checking_ || !frame_) return false;
  const Error told = about_frame(frame_->name, error);
  if (!difference_) difference_ = told;
  differing_serial_ = serial_;
  say(told.message);
  return true;
}

void Player::set_speed(double speed) {
  playback_.set_speed(speed);
  settings.play.speed = playback_.speed();
}

void Player::set_loop(bool loops) {
  playback_.set_loop(loops);
  settings.play.loop = loops;
}

void Player::set_aspect(PixelAspect aspect) {
  settings.look.aspect = aspect;
  view.set_aspect(aspect);
}

void Player::set_whole_scales(bool whole) {
  settings.look.whole_scales = whole;
  view.set_whole(whole);
}

void Player::save_svg() {
  if (!frame_) return;
  const IncrementalVectorizer& vectorizer = canvas_->filter().vectorizer();
  const std::string svg =
      stage ? write_stage_svg(make_stage_drawing(*stage, frame_->picture.view(), settings.options))
            : write_svg(vectorizer.map(), vectorizer.graph());
  const fs::path path = unused_path(".", frame_->name, ".svg");
  const auto saved = write_file(path, bytes_of(svg));
  say(saved ? fmt::format("The vector picture is in {}", path.string()) : saved.error().message);
}

void Player::save_picture(const Picture& picture) {
  const fs::path path = unused_path(".", frame_ ? frame_->name : "depixel", ".png");
  const auto saved = write_file(path, encode_png(picture.view()));
  say(saved ? fmt::format("What the window shows is in {}", path.string()) : saved.error().message);
}

void Player::start_export() {
  if (!clip_ || !frame_ || exporter_) return;
  const PixelRect all = view.placement();
  const glm::dvec2 scale(double(all.width) / frame_->picture.width(),
                         double(all.height) / frame_->picture.height());
  auto exporter = Exporter::start(unused_path(".", fs::path(clip_name_).stem().string() + "_depixel", ""),
                                  settings.options, scale);
  if (!exporter) {
    say(exporter.error().message);
    return;
  }
  playback_.pause();
  exporter_ = std::move(*exporter);
  exporter_->check_incremental(is_checking_);
}

void Player::cancel_export() {
  if (!exporter_) return;
  say(fmt::format("Stopped; {} pictures are in {}", exporter_->written(), exporter_->folder().string()));
  exporter_.reset();
}

void Player::say(std::string message) {
  constexpr double kSeconds = 6;
  message_ = std::move(message);
  message_seconds_ = kSeconds;
}

std::optional<FoundComponent> Player::component_at(glm::dvec2 point) {
  // A map with an error need not be closed, and its outlines could lead nowhere.
  if (!frame_ || differing_serial_ == serial_) return std::nullopt;
  const IncrementalVectorizer& vectorizer = canvas_->filter().vectorizer();
  components_.take(vectorizer.map(), vectorizer.graph(), canvas_->submissions());
  return components_.at(point);
}

}  // namespace depixel
