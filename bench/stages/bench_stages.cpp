/// Times each stage of vectorizing, and the rasteriser, by itself on each frame: bench_stages [FLAGS] [FILES
/// or FOLDERS...], with Google Benchmark's flags (--help lists them); the shipped frames if none is given.

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <exception>
#include <memory>

#include "bench/common/inputs.hpp"
#include "bench/common/picture.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel::bench {
namespace {

constexpr int kScale = 4;
const Options kOptions;

/// A frame with what every stage makes of it, to be read by the next.
struct Subject {
  Picture picture;
  Vectorizer done;
};

void dithers(benchmark::State& state, const Subject& subject) {
  Dithers blended;
  while (state.KeepRunning()) blend_dithers(subject.picture.view(), kOptions.linear_light, blended);
}

void similarity(benchmark::State& state, const Subject& subject) {
  SimilarityGraph graph;
  while (state.KeepRunning())
    build_similarity_graph(subject.picture.view(), LinkCriteria::of(kOptions), graph);
}

void crossings(benchmark::State& state, const Subject& subject) {
  SimilarityGraph frozen, graph;
  CrossingScratch scratch;
  build_similarity_graph(subject.picture.view(), LinkCriteria::of(kOptions), frozen);
  while (state.KeepRunning()) {
    state.PauseTiming();
    graph = frozen;
    state.ResumeTiming();
    resolve_crossings(graph, {}, scratch);
  }
}

void cells(benchmark::State& state, const Subject& subject) {
  CellGraph graph;
  while (state.KeepRunning()) build_cell_graph(subject.done.graph(), nullptr, graph);
}

void contours(benchmark::State& state, const Subject& subject) {
  Contours traced;
  while (state.KeepRunning()) trace_contours(subject.done.cells(), traced);
}

void arcs(benchmark::State& state, const Subject& subject) {
  std::vector<PixelMarks> marks;
  find_pixel_marks(subject.done.graph(), false, marks);
  Arcs cut;
  const Vectorizer& done = subject.done;
  while (state.KeepRunning()) {
    cut_arcs(done.cells(), done.contours(), marks, kOptions.spline, kOptions.smoothing, cut);
  }
}

void splines(benchmark::State& state, const Subject& subject) {
  SplineTable table;
  Workers workers;
  const Arcs& arcs = subject.done.arcs();
  while (state.KeepRunning()) {
    table.clear();
    for (const Arc& arc : arcs.list) table.place_of(arcs.words(arc), arc.kind);
    table.fit_added(kOptions, workers);
  }
}

void map(benchmark::State& state, const Subject& subject) {
  PlanarMap built;
  const Vectorizer& done = subject.done;
  while (state.KeepRunning()) build_planar_map(done.by_edge(), built);
}

void raster(benchmark::State& state, const Subject& subject) {
  CpuRaster raster;
  Picture out(subject.picture.width() * kScale, subject.picture.height() * kScale);
  const Vectorizer& done = subject.done;
  const View view = View::fit(done.cells().lattice, out.width(), out.height());
  while (state.KeepRunning()) raster.draw(done.by_edge(), view, kOptions.linear_light, 1, out.target());
}

void register_frame(const std::filesystem::path& file) {
  const auto subject = std::make_shared<Subject>();
  subject->picture = read_picture(file);
  subject->done.vectorize(subject->picture.view(), kOptions);
  const std::string name = (file.parent_path().filename() / file.stem()).string();
  const auto add = [&](std::string_view stage, void (*run)(benchmark::State&, const Subject&)) {
    benchmark::RegisterBenchmark(fmt::format("{}/{}", stage, name).c_str(), [=](benchmark::State& state) {
      run(state, *subject);
    })->Unit(benchmark::kMicrosecond);
  };
  add("dithers", dithers);
  add("similarity", similarity);
  add("crossings", crossings);
  add("cells", cells);
  add("contours", contours);
  add("arcs", arcs);
  add("splines", splines);
  add("map", map);
  add("raster", raster);
}

}  // namespace
}  // namespace depixel::bench

int main(int argc, char** argv) {
  namespace bench = depixel::bench;
  benchmark::Initialize(&argc, argv);
  std::vector<std::filesystem::path> inputs(argv + 1, argv + argc);  // what is not a flag
  if (inputs.empty()) inputs.push_back(bench::shipped_data() / "frames");
  try {
    for (const auto& file : bench::list_pictures(inputs, 1)) bench::register_frame(file);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_stages: {}\n", error.what());
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
