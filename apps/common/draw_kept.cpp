#include "apps/common/draw_kept.hpp"

namespace depixel {

tl::expected<void, Error> draw_kept(FrameFilter& filter, Picture& picture, int width, int height) {
  const bool is_kept = picture.width() == width && picture.height() == height;
  if (!is_kept) picture.resize(width, height);
  const Target target = is_kept ? Target(KeptPicture{picture.target()}) : Target(picture.target());
  return filter.draw(target, {0, 0, width, height}, View::fit(filter.vectorizer().lattice(), width, height));
}

}  // namespace depixel
