// Averages a planar map over an output pixel: exactly, from the lines in the tiles that the pixel's box overlaps. The
// formulas are those of LineTiles (libdepixel/raster/line_tiles.hpp) and of the CPU rasteriser.
// LINEAR_LIGHT is defined where the tiles' colours are in linear light.
// Source: Nehab and Hoppe, "Random-access rendering of general vector graphics" (2008); FreeType's smooth rasteriser.

const float kTileUnits = 32768.0;

uniform highp usampler2D tiles;  // of each source pixel: colour at its top left (2 words), first line, count of lines
uniform highp usampler2D lines;  // x0 y0, x1 y1, change of colour (2 words)
uniform ivec2 lines_layout;      // of a line's number: mask of its column, shift to its row

uniform ivec2 frame_size;   // source pixels
uniform ivec3 viewport;     // x, y, height, in the framebuffer's pixels
uniform ivec2 origin_tile;  // the source pixel at the viewport's top left
uniform vec2 origin;        // the viewport's top left in that pixel
uniform vec2 box_size;      // of an output pixel, in source pixels
uniform float to_full_strength;  // of a sum, over the area of the box and the levels of a colour

out vec4 colour;

vec4 signed_halves(uvec2 words) {
  ivec4 halves = ivec4(words.x << 16, words.x, words.y << 16, words.y);
  return vec4(halves >> 16);
}

vec2 unsigned_halves(uint word) {
  return vec2(ivec2(word & 0xffffu, word >> 16));
}

// The part of a box that lies right of a line, as an area: positive if the line goes down.
float area_right_of(vec2 from, vec2 to, vec2 low, vec2 high) {
  vec2 y = clamp(vec2(from.y, to.y), low.y, high.y);
  float height = to.y - from.y;
  float slope = (to.x - from.x) / (abs(height) < 0.5 ? 1.0 : height);
  // How much of the box's rows is right of the line, where it enters and leaves them; and the integral of that, clamped
  // to the box, over the way between.
  vec2 right = high.x - from.x - (y - from.y) * slope;
  vec2 inside = clamp(right, 0.0, high.x - low.x);
  vec2 integral = inside * (right - 0.5 * inside);
  float way = right.y - right.x;
  float mean = abs(way) < 4.0 ? 0.5 * (inside.x + inside.y) : (integral.y - integral.x) / way;
  return mean * (y.y - y.x);
}

// What a line that meets the tile's left side changes below that place, as an area.
float area_below_start(vec2 from, vec2 to, vec2 low, vec2 high) {
  float begins = from.x == 0.0 ? -1.0 : to.x == 0.0 ? 1.0 : 0.0;
  float y = from.x == 0.0 ? from.y : to.y;
  return begins * (high.x - low.x) * max(high.y - max(y, low.y), 0.0);
}

// Sum of colours times areas over the part of a tile from low to high.
vec4 sum_of_tile(ivec2 position, vec2 low, vec2 high) {
  uvec4 tile = texelFetch(tiles, position, 0);
  vec4 sum = signed_halves(tile.xy) * ((high.x - low.x) * (high.y - low.y));
  int first = int(tile.z), end = first + int(tile.w);
  for (int i = first; i < end; ++i) {
    uvec4 line = texelFetch(lines, ivec2(i & lines_layout.x, i >> lines_layout.y), 0);
    vec2 from = unsigned_halves(line.x), to = unsigned_halves(line.y);
    sum += signed_halves(line.zw) *
           (area_right_of(from, to, low, high) + area_below_start(from, to, low, high));
  }
  return sum;
}

#ifdef LINEAR_LIGHT
// To sRGB. Source: IEC 61966-2-1.
vec3 encode(vec3 light) {
  vec3 power = 1.055 * pow(max(light, 0.0), vec3(1.0 / 2.4)) - 0.055;
  return mix(power, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}
#else
vec3 encode(vec3 srgb) {
  return srgb;
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - viewport.xy;
  pixel.y = viewport.z - 1 - pixel.y;
  vec2 low = origin + vec2(pixel) * box_size, high = origin + vec2(pixel + 1) * box_size;
  // A tile of which a box overlaps less than 1/512 of its own size is left out: it is rounding's. A box beside the frame
  // overlaps nothing of the tile that it is given.
  vec2 margin = box_size / 512.0;
  ivec2 east_south = frame_size - origin_tile - 1;
  ivec2 first = clamp(ivec2(floor(low + margin)), -origin_tile, east_south);
  ivec2 last = clamp(ivec2(ceil(high - margin)) - 1, first, east_south);
  vec4 sum = vec4(0.0);
  ivec2 tile = first;
  do {  // one loop, not two: what a loop costs dominates where there are few lines
    vec2 corner = vec2(tile);
    sum += sum_of_tile(origin_tile + tile, kTileUnits * clamp(low - corner, 0.0, 1.0),
                       kTileUnits * clamp(high - corner, 0.0, 1.0));
    ++tile.x;
    if (tile.x > last.x) tile = ivec2(first.x, tile.y + 1);
  } while (tile.y <= last.y);
  sum *= to_full_strength;
  colour = sum.a < 0.5 / 255.0 ? vec4(0.0) : vec4(encode(sum.rgb / sum.a), sum.a);
}
