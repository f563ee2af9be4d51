/// Times frame sequences, played through a filter that may reuse what it knows of the frames before, against
/// starting from scratch and against other upscalers, on one core.

#include <fmt/core.h>

#include "bench/common/program.hpp"
#include "bench/sequences/report.hpp"

namespace depixel::bench {
namespace {

struct Settings {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path softfilter_folder = DEPIXEL_SOFTFILTERS;
  int every = 1, repeats = 5, threads = 1;
  bool json = false, softfilters = false;
};

/// Opens all softfilters that can be opened, and says which cannot.
std::vector<SoftFilterLibrary> open_softfilters(const std::filesystem::path& folder) {
  std::vector<SoftFilterLibrary> opened;
  const auto libraries = list_softfilters(folder);
  if (libraries.empty()) fmt::print(stderr, "No softfilters are timed: {} has none.\n", folder.string());
  for (const auto& library : libraries) {
    try {
      opened.push_back(open_softfilter(library));
    } catch (const std::runtime_error& error) {
      fmt::print(stderr, "left out: {}\n", error.what());
    }
  }
  return opened;
}

/// Times all sequences and prints the table as it grows.
std::vector<Verdict> print_table(const std::vector<SequenceFiles>& sequences,
                                 const std::vector<SoftFilterLibrary>& softfilters,
                                 const Settings& settings) {
  std::vector<Verdict> verdicts;
  print_header();
  for (const SequenceFiles& files : sequences) {
    const Sequence sequence = read_sequence(files);
    const SequenceTiming timing = time_sequence(sequence, softfilters, settings.repeats);
    print_timing(timing);
    const std::vector<Verdict> judged = judge(timing);
    verdicts.insert(verdicts.end(), judged.begin(), judged.end());
    if (settings.threads == 1) continue;
    const ThreadTiming threads = time_threads(sequence, settings.threads, settings.repeats);
    print_threads(threads);
    verdicts.push_back(judge(sequence.name, threads));
  }
  return verdicts;
}

void run(const Settings& settings) {
  const auto sequences = find_sequences(settings.folders, settings.every);
  std::vector<SoftFilterLibrary> softfilters;
  if (settings.softfilters) softfilters = open_softfilters(settings.softfilter_folder);
  if (!settings.json) {
    print_verdicts(print_table(sequences, softfilters, settings));
    return;
  }
  std::vector<SequenceTiming> timings;
  timings.reserve(sequences.size());
  for (const SequenceFiles& files : sequences) {
    timings.push_back(time_sequence(read_sequence(files), softfilters, settings.repeats));
  }
  print_json(timings);
}

void add_options(CLI::App& app, Settings& settings) {
  app.description(
      "Times sequences of frames at 4x on one core: each frame after those before it (incremental), from "
      "scratch, by libavfilter's xbr=n=4 and hqx=n=4, and by RetroArch's softfilters. They take turns of a "
      "few "
      "frames, the sequence is played several times, and the median of each frame counts. The first frame "
      "warms "
      "up and is not counted.\n"
      "Example: bench_sequences --softfilters --threads 2 captures/");
  app.add_option("FOLDER", settings.folders,
                 "folders of numbered PNG files, one sequence each, and folders of such folders")
      ->required();
  app.add_option("--every", settings.every, "take each n-th frame of a sequence")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--repeats", settings.repeats, "how often a sequence is played")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--softfilters", settings.softfilters,
               "time RetroArch's video filters too, each at its own scale");
  app.add_option("--softfilter-folder", settings.softfilter_folder, "where RetroArch's video filters are")
      ->capture_default_str();
  app.add_option("--threads", settings.threads,
                 "also time drawing from scratch with this many threads against one; not with --json")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--json", settings.json,
               "print the times of the sequences as one JSON object, and nothing else");
}

}  // namespace
}  // namespace depixel::bench

int main(int argc, char** argv) {
  using namespace depixel::bench;
  return run_program<Settings>("bench_sequences", argc, argv, add_options, run);
}
