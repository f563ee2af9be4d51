#pragma once

#include <filesystem>
#include <string>

#include "tests/support/picture.hpp"

namespace depixel::test {

/// Folder of the pictures that are shipped for tests, and folder for what failing tests leave behind.
std::filesystem::path data_folder();
std::filesystem::path output_folder();

/// Reads a picture file; an empty picture if it cannot be read.
Picture load_picture(const std::filesystem::path& file);
/// Writes a PNG, and the folder it is in.
bool save_picture(const std::filesystem::path& file, const Picture& picture);

/// A landscape in which nothing comes twice, seen from a place: 96x48 pixels of three colours.
Picture hills(glm::ivec2 from, char low = 'b');

/// Colours weighted by their alpha: what is nearly transparent hardly shows its colour.
Picture premultiplied(Picture picture);

/// Largest and mean difference of two pictures' channels; of pictures that differ in size, 255.
struct PictureDifference {
  int largest = 0;
  double mean = 0;
};
PictureDifference compare(const Picture& expected, const Picture& actual);

/// Compares a picture with the golden one of that name in the data folder's `golden`.
/// \return  empty if no channel differs by more than the tolerance, else what differs and where the expected
/// picture,
///          the actual one and their difference (doubled, in grey where alpha differs) lie.
/// With DEPIXEL_UPDATE_GOLDEN set in the environment, the golden picture is replaced and the comparison
/// passes.
std::string golden_mismatch(const std::string& name, const Picture& actual, int tolerance = 0);

}  // namespace depixel::test
