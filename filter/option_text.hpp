#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "libdepixel/core/error.hpp"
#include "libdepixel/core/options.hpp"

namespace depixel {

/// A number in decimal digits, finite, that is all of the text; none otherwise.
std::optional<double> parse_number(std::string_view text);
std::optional<int> parse_count(std::string_view text);

/// Sets an option to what a text says: one of a choice's names, a number in its range, or for a switch true
/// or false. \return an error without a full stop, and the option as it was, where it says no such thing.
tl::expected<void, Error> set_option(Options& options, const OptionInfo& option, std::string_view text);

/// The option as the text that sets it.
std::string option_text(const Options& options, const OptionInfo& option);

/// The index of one of some names, or an error without a full stop.
tl::expected<int, Error> parse_choice(std::string_view text, std::span<const std::string_view> names);

}  // namespace depixel
