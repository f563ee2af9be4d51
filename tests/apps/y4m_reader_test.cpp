#include "apps/common/y4m_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

/// A stream in memory, as a pipe would bring it.
Stream stream_of(std::string& bytes) {
  return Stream(::fmemopen(bytes.data(), bytes.size(), "rb"));
}

tl::expected<std::vector<Picture>, Error> read_all(std::string bytes) {
  auto reader = Y4mReader::open(stream_of(bytes));
  if (!reader) return tl::unexpected(reader.error());
  std::vector<Picture> frames;
  for (;;) {
    auto frame = reader->next();
    if (!frame) return tl::unexpected(frame.error());
    if (!*frame) return frames;
    frames.push_back(std::move(**frame));
  }
}

/// BT.601 as its matrix is printed, of studio range.
Rgba studio(int y, int u, int v) {
  const auto level = [](double value) {
    return static_cast<std::uint8_t>(std::lround(std::min(255.0, std::max(0.0, value))));
  };
  const double luma = 1.164384 * (y - 16);
  return {level(luma + 1.596027 * (v - 128)), level(luma - 0.391762 * (u - 128) - 0.812968 * (v - 128)),
          level(luma + 2.017232 * (u - 128)), 255};
}

void expect_near(Rgba a, Rgba b) {
  EXPECT_NEAR(a.r, b.r, 1);
  EXPECT_NEAR(a.g, b.g, 1);
  EXPECT_NEAR(a.b, b.b, 1);
  EXPECT_EQ(a.a, 255);
}

std::string bytes_from(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += static_cast<char>(value);
  return bytes;
}

TEST(Y4mReader, ReadsEveryKindOfChroma) {
  const std::string luma = bytes_from({50, 100, 150, 200, 90, 60});  // 3 x 2
  const auto first = [](const std::string& kind, const std::string& planes) {
    const auto frames = read_all("YUV4MPEG2 W3 H2 F25:1 C" + kind + "\nFRAME\n" + planes);
    if (!frames || frames->size() != 1) throw std::runtime_error(kind);
    return frames->front();
  };
  const Picture full =
      first("444", luma + bytes_from({100, 110, 120, 130, 140, 150}) + bytes_from({90, 80, 70, 60, 50, 40}));
  expect_near(pixel(full, 1, 0), studio(100, 110, 80));
  expect_near(pixel(full, 2, 1), studio(60, 150, 40));
  const Picture half = first("422", luma + bytes_from({100, 110, 120, 130}) + bytes_from({90, 80, 70, 60}));
  expect_near(pixel(half, 1, 0), studio(100, 100, 90));
  expect_near(pixel(half, 2, 1), studio(60, 130, 60));
  for (const char* kind : {"420", "420jpeg", "420mpeg2", "420paldv"}) {
    const Picture quarter = first(kind, luma + bytes_from({100, 110}) + bytes_from({90, 80}));
    expect_near(pixel(quarter, 1, 1), studio(90, 100, 90));
    expect_near(pixel(quarter, 2, 0), studio(150, 110, 80));
  }
  expect_near(pixel(first("mono", luma), 0, 1), studio(200, 128, 128));
}

TEST(Y4mReader, ReadsFullRange) {
  const auto frames = read_all("YUV4MPEG2 W1 H1 Cmono XCOLORRANGE=FULL\nFRAME\n" + bytes_from({77}));
  ASSERT_TRUE(frames);
  EXPECT_EQ(pixel(frames->front(), 0, 0), (Rgba{77, 77, 77, 255}));
}

TEST(Y4mReader, TellsRateAndPixelAspect) {
  std::string bytes = "YUV4MPEG2 W1 H1 F30000:1001 A8:7 Cmono Ip XYSCSS=MONO\nFRAME Ixyz\na";
  const auto reader = Y4mReader::open(stream_of(bytes));
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->frame_seconds(), 1001.0 / 30000);
  EXPECT_DOUBLE_EQ(reader->pixel_aspect().value(), 8.0 / 7);
  std::string plain = "YUV4MPEG2 W1 H1 F0:0 A0:0 Cmono\n";
  const auto unknown = Y4mReader::open(stream_of(plain));
  ASSERT_TRUE(unknown);
  EXPECT_FALSE(unknown->pixel_aspect());
}

TEST(Y4mReader, RefusesWhatIsCutShortAnywhere) {
  const std::string whole =
      "YUV4MPEG2 W2 H2 C444\nFRAME\n" + std::string(12, 'x') + "FRAME\n" + std::string(12, 'y');
  ASSERT_EQ(read_all(whole)->size(), 2u);
  const std::size_t header = whole.find('\n') + 1, frame = header + 6 + 12;
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const auto frames = read_all(whole.substr(0, size));
    const bool ends_between_frames = size == header || size == frame;
    EXPECT_EQ(frames.has_value(), ends_between_frames) << size;
  }
}

TEST(Y4mReader, RefusesHostileHeaders) {
  for (const std::string header :
       {"YUV4MPEG2", "YUV4MPEG2\n", "YUV4MPEG2 W0 H5\n", "YUV4MPEG2 W5\n", "YUV4MPEG2 W-3 H2\n",
        "YUV4MPEG2 W99999 H99999\n", "YUV4MPEG2 W4294967297 H1\n", "YUV4MPEG2 W2x H2\n",
        "YUV4MPEG2 W2 H2 C420p10\n", "YUV4MPEG2 W2 H2 C\n", "Yes\n"}) {
    const auto frames = read_all(header);
    ASSERT_FALSE(frames) << header;
    EXPECT_EQ(frames.error().message.back(), '.') << header;
  }
  EXPECT_FALSE(read_all("YUV4MPEG2 " + std::string(100'000, 'X') + "\n"));
  EXPECT_FALSE(read_all("YUV4MPEG2 W1 H1 Cmono\nNOISE\nx"));
  EXPECT_FALSE(read_all("YUV4MPEG2 W1 H1 Cmono\n" + std::string(100'000, 'F')));
}

TEST(Y4mReader, FeedsTheCommandLine) {
  const TemporaryFolder folder;
  const std::string stream = "YUV4MPEG2 W2 H2 Cmono\nFRAME\nabcdFRAME\nefgh";
  write_text(folder / "in.y4m", stream);
  EXPECT_EQ(run_depixel({folder / "in.y4m", "-o", folder / "out", "--quiet"}).exit_code, 0);
  EXPECT_EQ(folder.names("out"), (std::vector<std::string>{"in_0000.png", "in_0001.png"}));
  EXPECT_EQ(run_depixel({"-", "-o", folder / "piped", "--quiet"}, stream).exit_code, 0);
  EXPECT_EQ(folder.names("piped"), (std::vector<std::string>{"stdin_0000.png", "stdin_0001.png"}));
  const Ended cut = run_depixel({"-", "-o", folder / "cut", "--quiet"}, stream.substr(0, stream.size() - 1));
  EXPECT_EQ(cut.exit_code, 1);
  EXPECT_TRUE(cut.is_one_sentence()) << cut.err;
  const Ended none = run_depixel({"-", "-o", folder / "none"}, "YUV4MPEG2 W2 H2 Cmono\n");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_TRUE(none.is_one_sentence()) << none.err;
}

}  // namespace
}  // namespace depixel::test
