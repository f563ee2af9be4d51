#include "tests/support/test_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include "tests/support/ascii_picture.hpp"

namespace depixel::test {
namespace {

std::array<int, 4> channels(Rgba c) {
  return {c.r, c.g, c.b, c.a};
}

/// What two pixels differ by, made visible: twice the difference of the colours, or of alpha as grey.
Rgba visible_difference(Rgba p, Rgba q) {
  const auto doubled = [](int a, int b) {
    return static_cast<std::uint8_t>(std::min(255, 2 * std::abs(a - b)));
  };
  const std::uint8_t alpha = doubled(p.a, q.a);
  if (alpha != 0) return {alpha, alpha, alpha, 255};
  return {doubled(p.r, q.r), doubled(p.g, q.g), doubled(p.b, q.b), 255};
}

Picture difference_picture(const Picture& expected, const Picture& actual) {
  Picture out(std::max(expected.width, actual.width), std::max(expected.height, actual.height),
              {255, 0, 255, 255});
  for (int y = 0; y < std::min(expected.height, actual.height); ++y) {
    for (int x = 0; x < std::min(expected.width, actual.width); ++x) {
      out.at(x, y) = visible_difference(expected.at(x, y), actual.at(x, y));
    }
  }
  return out;
}

}  // namespace

std::filesystem::path data_folder() {
  return DEPIXEL_TEST_DATA;
}

std::filesystem::path output_folder() {
  return DEPIXEL_TEST_OUTPUT;
}

Picture load_picture(const std::filesystem::path& file) {
  int width = 0, height = 0;
  stbi_uc* data = stbi_load(file.c_str(), &width, &height, nullptr, 4);
  if (data == nullptr) return {};
  Picture picture(width, height);
  std::memcpy(picture.pixels.data(), data, picture.pixels.size() * sizeof(Rgba));
  stbi_image_free(data);
  return picture;
}

bool save_picture(const std::filesystem::path& file, const Picture& picture) {
  std::filesystem::create_directories(file.parent_path());
  return stbi_write_png(file.c_str(), picture.width, picture.height, 4, picture.pixels.data(),
                        4 * picture.width) != 0;
}

Picture hills(glm::ivec2 from, char low) {
  Picture picture(96, 48);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double u = x + from.x, v = y + from.y;
      const double height =
          std::sin(0.31 * u + 0.17 * v) + std::sin(0.11 * u - 0.23 * v) + std::sin(0.47 * v + 0.002 * u * u);
      picture.at(x, y) = palette_colour(height < -0.5 ? low : height < 0.7 ? 'g' : 'y');
    }
  }
  return picture;
}

Picture premultiplied(Picture picture) {
  const auto weighted = [](int channel, int alpha) {
    return static_cast<std::uint8_t>((channel * alpha + 127) / 255);
  };
  for (Rgba& c : picture.pixels) c = {weighted(c.r, c.a), weighted(c.g, c.a), weighted(c.b, c.a), c.a};
  return picture;
}

PictureDifference compare(const Picture& expected, const Picture& actual) {
  if (expected.width != actual.width || expected.height != actual.height) return {255, 255};
  PictureDifference result;
  double sum = 0;
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    const auto p = channels(normalized(expected.pixels[i])), q = channels(normalized(actual.pixels[i]));
    for (int c = 0; c < 4; ++c) {
      result.largest = std::max(result.largest, std::abs(p[c] - q[c]));
      sum += std::abs(p[c] - q[c]);
    }
  }
  result.mean = expected.pixels.empty() ? 0 : sum / (4.0 * double(expected.pixels.size()));
  return result;
}

std::string golden_mismatch(const std::string& name, const Picture& actual, int tolerance) {
  const std::filesystem::path golden = data_folder() / "golden" / (name + ".png");
  if (std::getenv("DEPIXEL_UPDATE_GOLDEN") != nullptr) {
    return save_picture(golden, actual) ? "" : "cannot write " + golden.string();
  }
  const Picture expected = load_picture(golden);
  const PictureDifference difference = compare(expected, actual);
  if (difference.largest <= tolerance) return "";
  const std::filesystem::path folder = output_folder() / name;
  if (expected.width > 0) save_picture(folder / "expected.png", expected);
  save_picture(folder / "actual.png", actual);
  save_picture(folder / "difference.png", difference_picture(expected, actual));
  std::ostringstream text;
  text << name << ": ";
  if (expected.width == 0) {
    text << "there is no " << golden.string();
  } else {
    text << "channels differ by up to " << difference.largest << ", " << difference.mean << " on average";
  }
  text << "; what there is of expected.png, actual.png and difference.png is in " << folder.string()
       << "; DEPIXEL_UPDATE_GOLDEN=1 accepts the actual picture";
  return text.str();
}

}  // namespace depixel::test
