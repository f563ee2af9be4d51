#include "apps/common/clip.hpp"

#include <algorithm>

namespace depixel {

tl::expected<std::unique_ptr<Clip>, Error> Clip::open(const Inputs& inputs, std::size_t budget_bytes) {
  const auto stream = std::count(inputs.files.begin(), inputs.files.end(), "-");
  if (stream == 0) return open_file_clip(inputs, budget_bytes);
  if (inputs.files.size() == 1) return open_stream_clip(budget_bytes);
  return tl::unexpected(Error{"Standard input is played by itself only, not among files."});
}

}  // namespace depixel
